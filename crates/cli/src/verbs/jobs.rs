//! `dobot jobs`: the jobs of a station, or of an arm without one.

use std::fs;
use std::io::{IsTerminal, Read, stdin};
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use clap::Subcommand;
use dobot_api::{Answer, JobPhase, JobView, NewJob, Reply, Request, Role};
use dobot_host::StationClient;

use crate::connect::To;
use crate::control::{self, arm_laser, check_pose, take_control};
use crate::failure::Failure;
use crate::follow::{self, place};
use crate::output::{self, clock, time_left};
use crate::questions;
use crate::values;

/// List, start, pause and cancel jobs
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot jobs                            list all jobs
  dobot jobs show 4
  dobot jobs start 4                    start or resume it, and follow it
  dobot jobs step 4                     run its next step, then pause
  dobot jobs answer 4 red               answer the question of its program
  dobot jobs answer 4 --at 200 50 -20   give it a position
  dobot jobs pause                      pause the running job, with the tool lifted
  dobot jobs speed 150                  150 % of the planned speed
  dobot jobs height -0.2                0.2 mm lower, if the pen leaves no ink
  dobot jobs cancel 4
  dobot jobs again 4                    queue a copy of it
  dobot jobs move 6 --before 5          change the order (default: to the end)
  dobot jobs forget 4                   remove one that is over or not started
  dobot jobs submit program.json        queue a file
  dobot jobs --to serial:/dev/ttyUSB0   jobs of an arm that was used without a
                                        station

Jobs survive the end of the station, a crash and a power failure. Starting one
requires control of the arm; control may be released while the job runs, unless
it uses the laser. `dobot draw` and `dobot play` create jobs.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    to: To,
    /// Print JSON
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// List all jobs
    List,
    /// Show one job
    Show {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
    },
    /// Start or resume a job and follow it; Ctrl-C pauses it
    Start {
        /// Job number (default: the only waiting job)
        #[arg(value_parser = values::whole_from(0))]
        job: Option<u64>,
        /// Arm the laser for this many seconds, 1 to 3600; everyone present must wear goggles
        #[arg(long, value_name = "SECONDS", value_parser = values::laser_seconds)]
        arm_laser: Option<Duration>,
        #[command(flatten)]
        person: Person,
    },
    /// Run the next step of a queued or paused job, then pause
    Step {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
        #[command(flatten)]
        person: Person,
    },
    /// Answer the question of the running program
    Answer {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
        /// One of the possible answers
        #[arg(required_unless_present = "at")]
        answer: Option<String>,
        /// Position of the tool's tip, in mm, and its rotation, in degrees (default: 0)
        #[arg(long, num_args = 3..=4, value_names = ["X", "Y", "Z", "ROTATION"], conflicts_with = "answer", allow_negative_numbers = true, value_parser = values::finite)]
        at: Option<Vec<f32>>,
        #[command(flatten)]
        person: Person,
    },
    /// Pause the running job after its in-flight commands
    Pause,
    /// Set the speed of the running or paused job, from its next command on
    Speed {
        /// Percentage of the planned speed, 10 to 200
        #[arg(value_name = "PERCENT", allow_negative_numbers = true, value_parser = values::number(10.0..=200.0, "percent"))]
        percent: f64,
    },
    /// Set the height of the running or paused job, gradually
    Height {
        /// Height above the plan, -5 to 5 mm
        #[arg(value_name = "MM", allow_negative_numbers = true, value_parser = values::number(-5.0..=5.0, "mm"))]
        offset_mm: f64,
    },
    /// End a job permanently
    Cancel {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
    },
    /// Queue a copy of a job
    Again {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
    },
    /// Move a queued job before another one, or to the end
    Move {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
        /// Number of the queued job that is to follow it (default: none, the end of the queue)
        #[arg(long, value_name = "JOB", value_parser = values::whole_from(0))]
        before: Option<u64>,
    },
    /// Remove a job that is over or not started
    Forget {
        /// Job number
        #[arg(value_parser = values::whole_from(0))]
        job: u64,
    },
    /// Queue a job from a JSON file
    ///
    /// The file has the keys title, kind, commands, `lift_mm` and pauses.
    Submit {
        /// Job file, or - for standard input
        file: PathBuf,
    },
}

/// The confirmation of a person.
#[derive(Clone, Copy, Debug, clap::Args)]
struct Person {
    /// Confirm what the job waits for, such as a new pen, without a terminal (administrators)
    #[arg(long)]
    as_person: bool,
}

impl Person {
    /// Parses the answer to the question of a job. One that only a person may answer needs a
    /// terminal, or an administrator who confirms that.
    async fn answer(
        self,
        station: &mut StationClient,
        job: u64,
        text: &str,
    ) -> Result<Answer, Failure> {
        self.check_role(station)?;
        let view = control::first_state(station).await?.job;
        let view = view.filter(|view| view.job == job);
        let Some(pending) = view.and_then(|view| view.question) else {
            return Err(Failure::new(
                anyhow!("job {job} does not wait for an answer now"),
                "run `dobot jobs` to list the jobs and their questions",
            ));
        };
        if pending.question.is_for_person() && !self.is_there(station) {
            return Err(Failure::new(
                anyhow!("only a person may answer: {}", pending.question),
                "answer in a terminal, on the page, or as an administrator with --as-person",
            ));
        }
        questions::parse(&pending.question, text).map_err(|reason| Failure::usage(anyhow!(reason)))
    }

    /// Returns whether a person is present.
    fn is_there(self, station: &StationClient) -> bool {
        // A virtual arm in this process is harmless.
        self.as_person || stdin().is_terminal() || station.virtual_arm().is_some()
    }

    /// Confirms what a job waits for if a person is present; otherwise its start is refused.
    async fn confirm(self, station: &mut StationClient, job: u64) -> Result<(), Failure> {
        self.check_role(station)?;
        if self.is_there(station) {
            take_control(station).await?;
            follow::confirm(station, job).await?;
        }
        Ok(())
    }

    fn check_role(self, station: &StationClient) -> Result<(), Failure> {
        if self.as_person && station.role() < Role::Admin {
            return Err(Failure::new(
                anyhow!(
                    "--as-person needs the role admin; this client has the role {}",
                    station.role()
                ),
                "use an administrator's token, or start the job in a terminal or on the page",
            ));
        }
        Ok(())
    }
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let action = args.action.clone().unwrap_or(Action::List);
    let act = async |station: &mut StationClient| act(station, &args, action).await;
    args.to.with_lasting_arm("jobs", act).await
}

async fn act(station: &mut StationClient, args: &Args, action: Action) -> Result<(), Failure> {
    let (request, done) = match action {
        Action::List => return list(station, args.json).await,
        Action::Show { job } => return show(station, job, args.json).await,
        Action::Start {
            job,
            arm_laser,
            person,
        } => return start(station, args, job, arm_laser, person).await,
        Action::Step { job, person } => return step(station, args, job, person).await,
        Action::Answer {
            job,
            answer,
            at,
            person,
        } => {
            let numbers: Vec<String> = at.iter().flatten().map(f32::to_string).collect();
            let text = answer.unwrap_or_else(|| numbers.join(" "));
            let answer = person.answer(station, job, &text).await?;
            (
                Request::AnswerJob {
                    job,
                    question: None,
                    answer,
                },
                format!("job {job} continues"),
            )
        }
        Action::Pause => (Request::PauseJob, "the job is paused".to_owned()),
        Action::Speed { percent } => {
            let done = "the speed of the job is changed".to_owned();
            (Request::SetJobSpeed { percent }, done)
        }
        Action::Height { offset_mm } => {
            let done = "the height of the job is changed".to_owned();
            (Request::SetJobHeight { offset_mm }, done)
        }
        Action::Cancel { job } => (
            Request::CancelJob { job },
            format!("job {job} is cancelled"),
        ),
        Action::Again { job } => (
            Request::QueueAgain { job, key: None },
            format!("a copy of job {job} is queued"),
        ),
        Action::Move { job, before } => (
            Request::MoveJob { job, before },
            format!("job {job} is moved in the queue"),
        ),
        Action::Forget { job } => (Request::ForgetJob { job }, format!("job {job} is removed")),
        Action::Submit { file } => {
            let job = read(&file)?;
            (
                Request::SubmitJob { job, key: None },
                "the job is queued".to_owned(),
            )
        }
    };
    send(station, request, &done, args.json).await
}

async fn list(station: &mut StationClient, as_json: bool) -> Result<(), Failure> {
    let jobs = station.jobs().await?;
    if let Some(missing) = control::first_state(station).await?.jobs_missing {
        eprintln!("{missing}");
    }
    if as_json {
        return Ok(output::json(&jobs)?);
    }
    if jobs.is_empty() {
        eprintln!("no jobs; `dobot draw picture.svg` creates one");
    }
    for job in &jobs {
        output::line(&line(job))?;
    }
    Ok(())
}

async fn show(station: &mut StationClient, job: u64, as_json: bool) -> Result<(), Failure> {
    let jobs = station.jobs().await?;
    match jobs.iter().find(|one| one.job == job) {
        Some(job) => print(job, as_json),
        None => Err(Failure::new(
            anyhow!("there is no job {job}"),
            "run `dobot jobs` to list the jobs",
        )),
    }
}

async fn start(
    station: &mut StationClient,
    args: &Args,
    job: Option<u64>,
    laser: Option<Duration>,
    person: Person,
) -> Result<(), Failure> {
    let job = match job {
        Some(job) => job,
        None => waiting(station).await?,
    };
    check_pose(station, args.to.pose_confirmed).await?;
    take_control(station).await?;
    arm_laser(station, laser).await?;
    person.confirm(station, job).await?;
    // Control must be kept while the laser may be used.
    let burns = laser.is_some() || control::first_state(station).await?.laser.armed_for_s > 0.0;
    let time = follow::start(station, job, burns, |_| {}).await?;
    // The duration is unknown if a station was killed during the job.
    let took = if time.is_zero() {
        String::new()
    } else {
        format!(", in {}", clock(time.as_secs_f64()))
    };
    Ok(output::line(&format!("job {job} is done{took}"))?)
}

/// Returns the only job that waits to be started.
async fn waiting(station: &mut StationClient) -> Result<u64, Failure> {
    let jobs = station.jobs().await?;
    let waits = |job: &&JobView| matches!(job.phase, JobPhase::Queued | JobPhase::Paused);
    let waiting: Vec<u64> = jobs.iter().filter(waits).map(|job| job.job).collect();
    match waiting[..] {
        [job] => Ok(job),
        [] => Err(Failure::new(
            anyhow!("no job waits to be started"),
            "create one with `dobot draw` or `dobot play`, or run `dobot jobs` to list all jobs",
        )),
        _ => Err(Failure::new(
            anyhow!("{} jobs wait to be started: {waiting:?}", waiting.len()),
            "name one: `dobot jobs start NUMBER`",
        )),
    }
}

async fn step(
    station: &mut StationClient,
    args: &Args,
    job: u64,
    person: Person,
) -> Result<(), Failure> {
    check_pose(station, args.to.pose_confirmed).await?;
    person.confirm(station, job).await?;
    follow::step(station, job).await?;
    show(station, job, args.json).await
}

/// Sends a request; takes control of the arm if that is needed and possible.
async fn send(
    station: &mut StationClient,
    request: Request,
    done: &str,
    as_json: bool,
) -> Result<(), Failure> {
    if matches!(
        request,
        Request::SubmitJob { .. } | Request::QueueAgain { .. }
    ) {
        // The job is planned for the connected arm.
        control::status(station).await?;
    }
    let reply = match station.request(request.clone()).await {
        Err(error) if error.kind() == Some("no-lease") => {
            take_control(station).await?;
            station.request(request).await?
        }
        reply => reply?,
    };
    match reply {
        Reply::Job { job } => print(&job, as_json),
        reply if as_json => Ok(output::json(&reply)?),
        _ => Ok(output::line(done)?),
    }
}

fn print(job: &JobView, as_json: bool) -> Result<(), Failure> {
    if as_json {
        return Ok(output::json(job)?);
    }
    Ok(output::line(&line(job))?)
}

/// `   4  paused    120 of   400   1:23 min left   harbour.svg: a person asked for it`
fn line(job: &JobView) -> String {
    let phase = format!("{:?}", job.phase).to_lowercase();
    let left = if job.phase.is_over() {
        String::new()
    } else {
        time_left(job.left_s)
    };
    let asks = job.question.as_ref();
    let asks = asks.map(|pending| format!("asks: {}", pending.question));
    let reason = job.reason.as_ref().or(asks.as_ref());
    let reason = reason.map(|reason| format!(": {reason}"));
    let place = job
        .program
        .as_ref()
        .map(|program| format!(" ({})", place(program)));
    format!(
        "{:4}  {phase:8} {:6} of {:6}   {left:16} {}{}{}{}",
        job.job,
        job.completed,
        job.commands,
        job.title,
        place.unwrap_or_default(),
        adjusted(job),
        reason.unwrap_or_default()
    )
}

/// Formats changes and durations: ` (150 %, 0.2 mm lower)` or ` (took 1:20 min, planned 1:18 min)`.
fn adjusted(job: &JobView) -> String {
    let took = job.took_s.map(|took_s| {
        let planned = job
            .planned_s
            .map(|planned_s| format!(", planned {}", clock(planned_s)));
        format!("took {}{}", clock(took_s), planned.unwrap_or_default())
    });
    let speed = (job.speed_percent != 100.0).then(|| format!("{} %", job.speed_percent));
    let side = if job.height_mm < 0.0 {
        "lower"
    } else {
        "higher"
    };
    let height = (job.height_mm != 0.0).then(|| format!("{} mm {side}", job.height_mm.abs()));
    let parts: Vec<String> = [took, speed, height].into_iter().flatten().collect();
    if parts.is_empty() {
        return String::new();
    }
    format!(" ({})", parts.join(", "))
}

/// Reads a job from a file or from standard input.
pub(super) fn read(file: &Path) -> Result<NewJob, Failure> {
    let text = if file == Path::new("-") {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text);
        read.context("cannot read standard input")?;
        text
    } else {
        fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?
    };
    serde_json::from_str(&text).map_err(|error| {
        Failure::new(
            anyhow!("{} is not a job: {error}", file.display()),
            "give it a title, a kind (drawing or program) and commands in the form of `dobot decode --json`",
        )
    })
}
