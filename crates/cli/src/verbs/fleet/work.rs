//! `dobot fleet work`: drawings and programs for any arm.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use clap::Subcommand;
use data_encoding::BASE64;
use dobot_api::{NewJob, StationAddress, WorkPhase, WorkView, delete, fetch, post};
use serde_json::{Value, json};

use crate::drawing_options::DrawingOptions;
use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// Drawings and programs for any arm of the fleet
#[derive(Clone, Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet work                               what was submitted here, and what has become of it
  dobot fleet work draw house.svg --needs pen --needs a5 --student Anna --at 210 0 --pen-down -40
  dobot fleet work job program.json --needs gripper
  dobot fleet work cancel 3f                     the work whose number begins so
  dobot fleet work give 3f                       it is in doubt, and you have looked: another arm is to do it

An arm takes it that is free and has all that is needed; `dobot up --fleet --offers pen --takes-work` lets a station take
work. Each is done once. Where nobody knows whether it was done, it is in doubt and waits for a person.")]
pub(super) struct WorkArgs {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// List the work
    List,
    /// Submit a drawing; the station that takes it plans it for its own arm
    Draw(Box<DrawArgs>),
    /// Submit a job, a JSON file as `dobot jobs submit` takes it
    Job {
        /// The file
        file: PathBuf,
        #[command(flatten)]
        whose: WhoseArgs,
    },
    /// Cancel work that no arm is at
    Cancel {
        /// Its number, or the beginning of it
        number: String,
    },
    /// Give work that is in doubt or has failed to another arm, after a look at the first one: what was drawn there may be
    /// drawn again
    Give {
        /// Its number, or the beginning of it
        number: String,
    },
}

/// A drawing.
#[derive(Clone, Debug, clap::Args)]
#[command(allow_negative_numbers = true)]
struct DrawArgs {
    /// The file to draw; none for a text or a test card
    file: Option<PathBuf>,
    #[command(flatten)]
    options: DrawingOptions,
    #[command(flatten)]
    whose: WhoseArgs,
}

/// Whose it is, and what it needs.
#[derive(Clone, Debug, clap::Args)]
struct WhoseArgs {
    /// What an arm has to have for it, as in pen, laser or a5; may be given several times
    #[arg(long, value_name = "WORD")]
    needs: Vec<String>,
    /// Whose it is (default: the name of the token)
    #[arg(long, value_name = "NAME")]
    student: Option<String>,
    /// The group of that one
    #[arg(long, value_name = "NAME")]
    group: Option<String>,
}

impl WorkArgs {
    pub(super) async fn run(self, station: &Station, as_json: bool) -> Result<(), Failure> {
        let address = station.address_of_running().await?;
        let all = match self.action.unwrap_or(Action::List) {
            Action::List => fetch(&address, WORK).await?,
            Action::Draw(args) => {
                let name = args.file.as_deref().map(name).transpose()?;
                let file = args.file.as_deref().map(read).transpose()?;
                let file = file.map(|it| BASE64.encode(&it));
                let drawing = json!({ "name": name, "file": file, "options": args.options.0 });
                vec![args.whose.submit(&address, "drawing", drawing).await?]
            }
            Action::Job { file, whose } => {
                let job = super::super::jobs::read(&file)?;
                vec![submit_job(&address, &whose, &job).await?]
            }
            Action::Cancel { number } => {
                let work = find(&address, &number).await?;
                vec![delete(&address, &format!("{WORK}/{work}")).await?]
            }
            Action::Give { number } => {
                let work = find(&address, &number).await?;
                vec![post(&address, &format!("{WORK}/{work}/give"), &json!({})).await?]
            }
        };
        if as_json {
            return Ok(output::json(&all)?);
        }
        for work in &all {
            for line in lines(work) {
                output::plain_line(&line)?;
            }
        }
        Ok(())
    }
}

async fn submit_job(
    address: &StationAddress,
    whose: &WhoseArgs,
    job: &NewJob,
) -> Result<WorkView, Failure> {
    let job = serde_json::to_value(job).context("a job is written")?;
    whose.submit(address, "job", job).await
}

impl WhoseArgs {
    async fn submit(
        &self,
        address: &StationAddress,
        what: &str,
        it: Value,
    ) -> Result<WorkView, Failure> {
        let mut body = json!({ "needs": self.needs, "student": self.student, "group": self.group });
        body[what] = it;
        Ok(post(address, WORK, &body).await?)
    }
}

/// The number of the work whose number begins so.
async fn find(address: &StationAddress, number: &str) -> Result<String, Failure> {
    let all: Vec<WorkView> = fetch(address, WORK).await?;
    let mut found = all.into_iter().filter(|it| it.id.starts_with(number));
    match (found.next(), found.next()) {
        (Some(one), None) => Ok(one.id),
        (None, _) => Err(Failure::new(
            anyhow!("no work has a number that begins with {number}"),
            "`dobot fleet work` lists all that was submitted to this station",
        )),
        (Some(_), Some(_)) => Err(Failure::new(
            anyhow!("several numbers begin with {number}"),
            "give more of the number",
        )),
    }
}

/// What a person reads of some work.
fn lines(work: &WorkView) -> Vec<String> {
    let id: String = work.id.chars().take(8).collect();
    let phase = format!("{:?}", work.phase).to_lowercase();
    let mut line = format!("{id}  {:12}  {phase:9}  {}", work.student, work.title);
    if let Some(member) = &work.member {
        let place = place(work, &member.name);
        line = format!("{line} ({place})");
    }
    let reason = work.reason.iter().map(|it| format!("          {it}"));
    let before = work.before.iter().map(|it| {
        let name = &it.member.name;
        format!("          before, at {name}: {}", it.drawn)
    });
    let doubt = work.doubt.iter().map(|it| {
        format!("          IN DOUBT: {it}; look there, then `dobot fleet work give {id}` or wait")
    });
    [line]
        .into_iter()
        .chain(reason)
        .chain(before)
        .chain(doubt)
        .collect()
}

/// Where it is.
fn place(work: &WorkView, member: &str) -> String {
    match &work.job {
        Some(job) if work.phase == WorkPhase::Taken => {
            let phase = format!("{:?}", job.phase).to_lowercase();
            format!("job {} of {member}, {phase}", job.job)
        }
        Some(job) => format!("job {} of {member}", job.job),
        None => member.to_owned(),
    }
}

fn name(file: &Path) -> Result<String, Failure> {
    let name = file.file_name().map(|it| it.to_string_lossy().into_owned());
    name.ok_or_else(|| anyhow!("{} is no file", file.display()).into())
}

fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    let read = fs::read(file);
    Ok(read.with_context(|| format!("cannot read {}", file.display()))?)
}

const WORK: &str = "/api/v1/fleet/work";

#[cfg(test)]
mod tests {
    use dobot_api::{WorkBefore, WorkMember};

    use super::*;

    #[test]
    fn work_in_doubt_tells_where_to_look_and_what_a_person_can_do() {
        let member = |name: &str| WorkMember {
            name: name.into(),
            id: "0".repeat(32),
        };
        let work = WorkView {
            id: "3f".repeat(16),
            title: "a house".into(),
            student: "Anna".into(),
            group: None,
            needs: Vec::new(),
            submitted_ms: 0,
            phase: WorkPhase::Offered,
            doubt: Some("desk-2 cannot be reached; it may have been drawn".into()),
            reason: None,
            member: Some(member("desk-2")),
            job: None,
            before: vec![WorkBefore {
                member: member("desk-1"),
                drawn: "nothing of it was drawn".into(),
                is_settled: true,
            }],
        };
        let lines = lines(&work);
        assert_eq!(lines.len(), 3);
        assert!(lines[0].contains("Anna") && lines[0].contains("(desk-2)"));
        assert!(lines[1].contains("desk-1: nothing of it was drawn"));
        assert!(lines[2].contains("desk-2 cannot be reached"));
        assert!(lines[2].contains("`dobot fleet work give 3f3f3f3f`"));
    }
}
