//! `dobot play`: a taught program, once, often, or until somebody ends it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{JobRepeat, NewJob};
use dobot_host::{PlannedFor, Prediction, Rules, StationClient, predict};
use dobot_teach::{Compiled, Times, check};
use serde::Serialize;

use crate::connect::{To, speaker};
use crate::control::{self, arm_laser, check_pose, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::output::{self, clock};
use crate::program_file;
use crate::verbs::jog::laser_seconds;

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
/// Play a taught program: check it, say how long it takes, and do it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot play pick.toml                    with the arm of the station, or with a virtual one
  dobot play pick.toml --dry-run          check it, and say how long it takes; nothing moves
  dobot play pick.toml --times 20         twenty cycles
  dobot play pick.toml --forever          until Ctrl-C or `dobot jobs cancel`
  dobot play pick.toml --from 4           from its fourth step on
  dobot play pick.toml --step             its first step; `dobot jobs step` does the next one
  dobot play pick.toml --to serial:/dev/ttyUSB0

The program becomes a job, which survives a crash and a power cut: `dobot jobs` shows its step and cycle, pauses
it, and makes it faster or slower.")]
pub(crate) struct Args {
    /// The program: a TOML file, or PlayBackPoints.xml or a .play file of the vendor's program
    program: PathBuf,
    /// How often it is done; without this as often as the program itself says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..), conflicts_with = "forever")]
    times: Option<u64>,
    /// Begin with this step, as `dobot check` and `dobot jobs` count them from 1
    #[arg(long, value_name = "STEP", value_parser = clap::value_parser!(u64).range(1..))]
    from: Option<u64>,
    /// Do it until a person ends it
    #[arg(long)]
    forever: bool,
    /// Do the first step only, and pause behind it
    #[arg(long, conflicts_with = "dry_run")]
    step: bool,
    /// Check it and say how long it takes; nothing moves
    #[arg(long)]
    dry_run: bool,
    /// Let the laser be switched on for so many seconds: everybody's goggles are on
    #[arg(long, value_name = "SECONDS", value_parser = laser_seconds)]
    arm_laser: Option<Duration>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    // What is wrong with it is told before any arm is touched.
    let rules = Rules::of(&args.to.policy()?);
    let planned = Planned::new(&args, &PlannedFor::any(rules.into(), args.to.dialect))?;
    if args.dry_run {
        return planned.tell(args.json);
    }
    let play = async |station: &mut StationClient| play(station, &args, planned).await;
    args.to.with_arm("play", play).await
}

async fn play(
    station: &mut StationClient,
    args: &Args,
    mut planned: Planned,
) -> Result<(), Failure> {
    check_pose(station, args.to.pose_confirmed).await?;
    if station.virtual_arm().is_none() {
        let arm = control::planned_for(station, &args.to.policy()?).await?;
        planned = Planned::new(args, &arm)?;
    }
    if !args.json {
        planned.tell(false)?;
    }
    // Nothing is queued that cannot be started.
    take_control(station).await?;
    arm_laser(station, args.arm_laser).await?;
    let title = planned.job.title.clone();
    let job = station.submit(planned.job).await?;
    if args.step {
        return follow::step(station, job).await;
    }
    let burns = args.arm_laser.is_some();
    let took = follow::start(station, job, burns, |_| {}).await?;
    let done = Done {
        job,
        took_s: took.as_secs_f64(),
    };
    if args.json {
        return Ok(output::json(&done)?);
    }
    let took = clock(done.took_s);
    Ok(output::line(&format!("{title} is done, in {took}"))?)
}

/// A program that was checked.
struct Planned {
    job: NewJob,
    /// What the twin took.
    prediction: Prediction,
}

impl Planned {
    fn new(args: &Args, arm: &PlannedFor) -> Result<Self, Failure> {
        let mut compiled = program_file::compile(&args.program, arm)?;
        if let Some(times) = times(args) {
            compiled.repeat(times);
        }
        let compiled = match args.from {
            Some(step) => from_step(&compiled, step, &args.program)?,
            None => compiled,
        };
        let policy = &arm.rules.policy;
        let report = check(&compiled, policy, arm.model());
        let problems: Vec<String> = report.problems.iter().map(ToString::to_string).collect();
        if !problems.is_empty() {
            let (file, count) = (args.program.display(), problems.len());
            return Err(anyhow!("{file} has {count} problems:\n{}", problems.join("\n")).into());
        }
        let job = compiled.job();
        let prediction = predict(
            &job,
            policy,
            speaker(arm.dialect()),
            arm.calibration.as_ref(),
        );
        let prediction = prediction.map_err(|error| anyhow!("on the twin: {error}"))?;
        Ok(Self { job, prediction })
    }

    /// How long it takes.
    fn tell(&self, as_json: bool) -> Result<(), Failure> {
        let times = self.times();
        if as_json {
            return Ok(output::json(&times)?);
        }
        let cycle = times
            .cycle_s
            .map(|it| format!("a cycle takes {}", clock(it)));
        let total = match times.total_s {
            Some(it) => format!("{} in all", clock(it)),
            None => "until a person ends it".to_owned(),
        };
        let steps = format!("{} steps", self.job.program.steps.len());
        let parts: Vec<String> = [Some(steps), cycle, Some(total)]
            .into_iter()
            .flatten()
            .collect();
        Ok(output::line(&format!(
            "{}: {}",
            self.job.title,
            parts.join(", ")
        ))?)
    }

    /// How long each step takes the first time, in seconds.
    fn steps_s(&self) -> Vec<f64> {
        let until_s = &self.prediction.until_s;
        let over = |command: usize| command.checked_sub(1).map_or(0.0, |it| until_s[it]);
        let firsts = self.job.program.steps.iter().copied();
        let ends = firsts.clone().skip(1).chain([until_s.len()]);
        let times = firsts.zip(ends);
        times.map(|(first, end)| over(end) - over(first)).collect()
    }

    fn times(&self) -> DryRunTimes {
        let first_s = self.prediction.until_s.last().copied().unwrap_or(0.0);
        let cycle_s = self.prediction.cycle_s;
        let total_s = match self.job.program.repeat {
            None => Some(first_s),
            #[expect(clippy::cast_precision_loss, reason = "nobody waits for 2^53 cycles")]
            Some(JobRepeat { times, .. }) => times
                .map(|it| it.saturating_sub(1) as f64)
                .map(|more| first_s + cycle_s.unwrap_or(0.0) * more),
        };
        DryRunTimes {
            steps: self.job.program.steps.len(),
            steps_s: self.steps_s(),
            commands: self.job.commands.len(),
            first_s,
            cycle_s,
            total_s,
        }
    }
}

/// How long a program takes on the twin.
#[derive(Debug, Serialize)]
struct DryRunTimes {
    steps: usize,
    /// How long each step takes the first time.
    steps_s: Vec<f64>,
    commands: usize,
    /// All of it once.
    first_s: f64,
    /// A cycle that follows another one.
    cycle_s: Option<f64>,
    /// None where it goes on until a person ends it.
    total_s: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Done {
    job: u64,
    took_s: f64,
}

/// How often it is to be done, where the arguments say it.
fn times(args: &Args) -> Option<Times> {
    let count = args.times.map(Times::Count);
    count.or_else(|| args.forever.then_some(Times::Forever))
}

/// The rest of a program from a step on, counted from 1.
fn from_step(program: &Compiled, step: u64, file: &Path) -> Result<Compiled, Failure> {
    let rest = usize::try_from(step - 1)
        .ok()
        .and_then(|it| program.from_step(it));
    rest.ok_or_else(|| {
        let (file, steps) = (file.display(), program.steps.len());
        anyhow!("{file} has {steps} steps, and --from is {step}").into()
    })
}
