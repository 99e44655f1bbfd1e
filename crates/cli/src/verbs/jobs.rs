//! `dobot jobs`: drawings and programs that a station keeps.

use std::fs;
use std::io::{IsTerminal, Read, stdin};
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use clap::Subcommand;
use dobot_api::{JobPhase, JobView, NewJob, Reply, Request, Role};
use dobot_host::StationClient;

use crate::connect::To;
use crate::control::{self, arm_laser, check_pose, take_control};
use crate::failure::Failure;
use crate::follow::{self, place};
use crate::output::{self, clock, time_left};
use crate::verbs::jog::laser_seconds;

/// List, start, pause and cancel jobs: of the station, or of an arm that is used without one
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot jobs                             all of them
  dobot jobs show 4
  dobot jobs start 4                     start it, or go on with it, and follow it
  dobot jobs step 4                      do its next step, and pause behind it
  dobot jobs pause                       the one that runs, with the tool lifted
  dobot jobs speed 150                   draw it half as fast again as planned
  dobot jobs height -0.2                 0.2 mm lower than planned: the pen leaves no ink
  dobot jobs cancel 4
  dobot jobs again 4                     queue what it does once more
  dobot jobs move 6 --before 5           or last, without --before
  dobot jobs forget 4                    one that is over, or has not begun
  dobot jobs submit program.json         queue a file; `dobot draw` queues a picture
  dobot jobs --to serial:/dev/ttyUSB0    those of an arm that was used without a station

Jobs survive the station's end, a crash and a power cut. Whoever starts one needs control of the arm; anybody
may let go of it again while the job runs, unless it burns.")]
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
    /// Tell about one job
    Show {
        /// Its number
        job: u64,
    },
    /// Start a queued job or go on with a paused one, and follow it; Ctrl-C pauses it
    Start {
        /// Its number (default: the one job that waits)
        job: Option<u64>,
        /// Let the laser be switched on for so many seconds: everybody's goggles are on
        #[arg(long, value_name = "SECONDS", value_parser = laser_seconds)]
        arm_laser: Option<Duration>,
        #[command(flatten)]
        person: Person,
    },
    /// Do the next step of a queued or paused job, and pause behind it
    Step {
        /// Its number
        job: u64,
        #[command(flatten)]
        person: Person,
    },
    /// Pause the running job after what the arm has got already
    Pause,
    /// Do the job that runs or is paused faster or slower than planned, from its next vector or target on
    Speed {
        /// In percent of the planned speed, 10 to 200; 100 is as planned
        #[arg(value_name = "PERCENT", allow_negative_numbers = true)]
        percent: f64,
    },
    /// Draw the job that runs or is paused higher or lower than planned, gently
    Height {
        /// How far above the plan, -5 to 5 mm; below 0 is lower, 0 is as planned
        #[arg(value_name = "MM", allow_negative_numbers = true)]
        offset_mm: f64,
    },
    /// End a job for good
    Cancel {
        /// Its number
        job: u64,
    },
    /// Queue what a job does once more, as a new job
    Again {
        /// Its number
        job: u64,
    },
    /// Put a queued job before another queued one, or behind all of them
    Move {
        /// Its number
        job: u64,
        /// The number of the queued job that comes behind it (default: it comes last)
        #[arg(long, value_name = "JOB")]
        before: Option<u64>,
    },
    /// Forget a job that is over, or that has not begun
    Forget {
        /// Its number
        job: u64,
    },
    /// Queue a job from a JSON file with its title, kind, commands, `lift_mm` and `pauses`
    Submit {
        /// The file, or - for standard input
        file: PathBuf,
    },
}

/// Whether a person confirms what a job waits for.
#[derive(Clone, Copy, Debug, clap::Args)]
struct Person {
    /// Confirm what the job waits for, such as a new pen, without a terminal; takes an administrator's token
    #[arg(long)]
    as_person: bool,
}

impl Person {
    /// Confirms what a job waits for, if a person is there; otherwise the start of the job is refused.
    async fn confirm(self, station: &mut StationClient, job: u64) -> Result<(), Failure> {
        if self.as_person && station.role() < Role::Admin {
            return Err(Failure::new(
                anyhow!(
                    "--as-person takes the role admin; this client has {}",
                    station.role()
                ),
                "use an administrator's token, or start the job in a terminal or on the page",
            ));
        }
        // A virtual arm of this process harms nobody.
        if self.as_person || stdin().is_terminal() || station.virtual_arm().is_some() {
            take_control(station).await?;
            follow::confirm(station, job).await?;
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
        Action::Pause => (Request::PauseJob, "the job is paused".to_owned()),
        Action::Speed { percent } => {
            let done = "the job goes at another speed".to_owned();
            (Request::SetJobSpeed { percent }, done)
        }
        Action::Height { offset_mm } => {
            let done = "the job is drawn at another height".to_owned();
            (Request::SetJobHeight { offset_mm }, done)
        }
        Action::Cancel { job } => (
            Request::CancelJob { job },
            format!("job {job} is cancelled"),
        ),
        Action::Again { job } => (
            Request::QueueAgain { job, key: None },
            format!("job {job} is queued once more"),
        ),
        Action::Move { job, before } => (
            Request::MoveJob { job, before },
            format!("job {job} has another place"),
        ),
        Action::Forget { job } => (
            Request::ForgetJob { job },
            format!("job {job} is forgotten"),
        ),
        Action::Submit { file } => {
            let job = read(&file)?;
            (
                Request::SubmitJob { job, key: None },
                "the job is queued".to_owned(),
            )
        }
    };
    ask(station, request, &done, args.json).await
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
        eprintln!("no job yet; `dobot draw picture.svg` makes one");
    }
    for job in &jobs {
        output::line(&line(job))?;
    }
    Ok(())
}

async fn show(station: &mut StationClient, job: u64, as_json: bool) -> Result<(), Failure> {
    let jobs = station.jobs().await?;
    match jobs.iter().find(|it| it.job == job) {
        Some(job) => tell(job, as_json),
        None => Err(Failure::new(
            anyhow!("there is no job {job}"),
            "`dobot jobs` lists the jobs",
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
    // Whoever may burn keeps control.
    let burns = laser.is_some() || control::first_state(station).await?.laser.armed_for_s > 0.0;
    let time = follow::start(station, job, burns, |_| {}).await?;
    // Nobody knows how long it took where a station was killed in it.
    let took = if time.is_zero() {
        String::new()
    } else {
        format!(", in {}", clock(time.as_secs_f64()))
    };
    Ok(output::line(&format!("job {job} is done{took}"))?)
}

/// The job that waits to be started, where there is one and no other.
async fn waiting(station: &mut StationClient) -> Result<u64, Failure> {
    let jobs = station.jobs().await?;
    let waits = |it: &&JobView| matches!(it.phase, JobPhase::Queued | JobPhase::Paused);
    let waiting: Vec<u64> = jobs.iter().filter(waits).map(|it| it.job).collect();
    match waiting[..] {
        [job] => Ok(job),
        [] => Err(Failure::new(
            anyhow!("no job waits to be started"),
            "`dobot draw` and `dobot play` make jobs; `dobot jobs` lists them",
        )),
        _ => Err(Failure::new(
            anyhow!("{} jobs wait to be started: {waiting:?}", waiting.len()),
            "say which one: `dobot jobs start NUMBER`",
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

/// Asks, with control of the arm where nobody else has it.
async fn ask(
    station: &mut StationClient,
    request: Request,
    done: &str,
    as_json: bool,
) -> Result<(), Failure> {
    if matches!(
        request,
        Request::SubmitJob { .. } | Request::QueueAgain { .. }
    ) {
        // Its way is planned for the arm that is there.
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
        Reply::Job { job } => tell(&job, as_json),
        reply if as_json => Ok(output::json(&reply)?),
        _ => Ok(output::line(done)?),
    }
}

fn tell(job: &JobView, as_json: bool) -> Result<(), Failure> {
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
    let reason = job.reason.as_ref().map(|it| format!(": {it}"));
    let place = job.program.as_ref().map(|it| format!(" ({})", place(it)));
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

/// ` (150 %, 0.2 mm lower)`, where a person has changed it, or ` (took 1:20 min, planned 1:18 min)`.
fn adjusted(job: &JobView) -> String {
    let took = job.took_s.map(|took_s| {
        let planned = job.planned_s.map(|it| format!(", planned {}", clock(it)));
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

/// The job in a file, or on the standard input.
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
            anyhow!("{} is no job: {error}", file.display()),
            "a job has title, kind (drawing or program) and commands, each as `dobot decode --json` prints them",
        )
    })
}
