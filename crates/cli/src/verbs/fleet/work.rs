//! `dobot fleet work`: drawings and programs for any suitable arm.

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

/// Submit drawings and programs to any suitable arm, and track them
#[derive(Clone, Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet work                       list the submitted work and its state
  dobot fleet work draw house.svg --needs pen --needs a5 --student Anna
  dobot fleet work job program.json --needs gripper
  dobot fleet work cancel 3f             cancel the work requirements ID starts with 3f
  dobot fleet work give 3f               give doubtful work to another arm

The first free arm with all that is needed takes the work; a station accepts
work with `dobot up --fleet --offers pen --takes-work`. Each piece of work is
done once. If it is unknown whether it was done, it is in doubt and waits for a
person, who looks at the arm before giving it to another one.")]
pub(super) struct WorkArgs {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// List the submitted work
    List,
    /// Submit a drawing; the station that takes it plans it for its arm
    Draw(Box<DrawArgs>),
    /// Submit a job, a JSON file as for `dobot jobs submit`
    Job {
        /// Job file
        file: PathBuf,
        #[command(flatten)]
        requirements: RequirementArgs,
    },
    /// Cancel work that no arm is doing
    Cancel {
        /// ID of the work, or its first characters
        number: String,
    },
    /// Give work in doubt, or failed work, to another arm
    ///
    /// Look at the first arm before: what it has drawn may be drawn again.
    Give {
        /// ID of the work, or its first characters
        number: String,
    },
}

/// Arguments of a drawing.
#[derive(Clone, Debug, clap::Args)]
#[command(allow_negative_numbers = true)]
struct DrawArgs {
    /// File to draw (default: none, for a text or a test card)
    file: Option<PathBuf>,
    #[command(flatten)]
    options: DrawingOptions,
    #[command(flatten)]
    requirements: RequirementArgs,
}

/// The student and the requirements of work.
#[derive(Clone, Debug, clap::Args)]
struct RequirementArgs {
    /// Equipment that the arm must have, for example pen, laser or a5; may be repeated
    #[arg(long, value_name = "WORD")]
    needs: Vec<String>,
    /// Name of the student (default: the name of the token)
    #[arg(long, value_name = "NAME")]
    student: Option<String>,
    /// Group of the student
    #[arg(long, value_name = "NAME")]
    group: Option<String>,
}

impl WorkArgs {
    pub(super) async fn run(self, station: &Station, as_json: bool) -> Result<(), Failure> {
        let address = station.address_of_running().await?;
        let action = self.action.unwrap_or(Action::List);
        let all = action.carry_out(&address).await?;
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

impl Action {
    /// Carries out the action; returns the work that it is about.
    async fn carry_out(self, address: &StationAddress) -> Result<Vec<WorkView>, Failure> {
        Ok(match self {
            Self::List => fetch(address, WORK).await?,
            Self::Draw(args) => vec![args.submit(address).await?],
            Self::Job { file, requirements } => {
                let job = super::super::jobs::read(&file)?;
                vec![submit_job(address, &requirements, &job).await?]
            }
            Self::Cancel { number } => {
                let work = find(address, &number).await?;
                vec![delete(address, &format!("{WORK}/{work}")).await?]
            }
            Self::Give { number } => {
                let work = find(address, &number).await?;
                vec![post(address, &format!("{WORK}/{work}/give"), &json!({})).await?]
            }
        })
    }
}

impl DrawArgs {
    async fn submit(&self, address: &StationAddress) -> Result<WorkView, Failure> {
        let name = self.file.as_deref().map(name).transpose()?;
        let file = self.file.as_deref().map(read).transpose()?;
        let file = file.map(|bytes| BASE64.encode(&bytes));
        let drawing = json!({ "name": name, "file": file, "options": self.options.0 });
        self.requirements.submit(address, "drawing", drawing).await
    }
}

async fn submit_job(
    address: &StationAddress,
    requirements: &RequirementArgs,
    job: &NewJob,
) -> Result<WorkView, Failure> {
    let job = serde_json::to_value(job).context("cannot write the job")?;
    requirements.submit(address, "job", job).await
}

impl RequirementArgs {
    async fn submit(
        &self,
        address: &StationAddress,
        key: &str,
        work: Value,
    ) -> Result<WorkView, Failure> {
        let mut body = json!({ "needs": self.needs, "student": self.student, "group": self.group });
        body[key] = work;
        Ok(post(address, WORK, &body).await?)
    }
}

/// Finds the work whose ID starts with a text.
async fn find(address: &StationAddress, number: &str) -> Result<String, Failure> {
    let all: Vec<WorkView> = fetch(address, WORK).await?;
    let mut found = all.into_iter().filter(|work| work.id.starts_with(number));
    match (found.next(), found.next()) {
        (Some(one), None) => Ok(one.id),
        (None, _) => Err(Failure::new(
            anyhow!("no work has an ID that starts with {number}"),
            "run `dobot fleet work` to list the work of this station",
        )),
        (Some(_), Some(_)) => Err(Failure::new(
            anyhow!("several IDs start with {number}"),
            "give more characters of the ID",
        )),
    }
}

/// Formats the lines about a piece of work.
fn lines(work: &WorkView) -> Vec<String> {
    let id: String = work.id.chars().take(8).collect();
    let phase = format!("{:?}", work.phase).to_lowercase();
    let mut line = format!("{id}  {:12}  {phase:9}  {}", work.student, work.title);
    if let Some(member) = &work.member {
        line = format!("{line} ({})", place(work, &member.name));
    }
    let reason = work
        .reason
        .iter()
        .map(|reason| format!("          {reason}"));
    let before = work.before.iter().map(|before| {
        let name = &before.member.name;
        format!("          before, at {name}: {}", before.drawn)
    });
    let doubt = work.doubt.iter().map(|doubt| {
        format!(
            "          IN DOUBT: {doubt}; look there, then run `dobot fleet work give {id}` or wait"
        )
    });
    let mut lines = vec![line];
    lines.extend(reason.chain(before).chain(doubt));
    lines
}

/// Describes where the work is.
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
    let name = file
        .file_name()
        .map(|name| name.to_string_lossy().into_owned());
    name.ok_or_else(|| anyhow!("{} is not a file", file.display()).into())
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
    fn work_in_doubt_is_listed_with_where_to_look_and_what_to_do() {
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
