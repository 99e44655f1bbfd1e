//! `dobot play`: runs a program, once, several times, or until a person ends it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{JobRepeat, NewJob};
use dobot_host::{PlannedFor, Prediction, Rules, StationClient, predict};
use dobot_teach::{Compiled, Times, check};
use serde::Serialize;

use crate::connect::{To, personality_of};
use crate::control::{self, arm_laser, check_pose, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::output::{self, clock};
use crate::{program_file, values};

#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the command line"
)]
/// Run a program: check it, print its duration, and execute it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot play pick.toml              on the station's arm, or on a virtual one
  dobot play pick.toml --dry-run    check it and print its duration; nothing moves
  dobot play pick.toml --times 20   20 cycles
  dobot play pick.toml --forever    until Ctrl-C or `dobot jobs cancel`
  dobot play pick.toml --from 4     start at the fourth step
  dobot play pick.toml --step       one step; `dobot jobs step` runs the next one
  dobot play pick.toml --to serial:/dev/ttyUSB0

The program becomes a job, which survives a crash and a power failure.
`dobot jobs` shows its step and cycle, pauses it, and changes its speed.")]
pub(crate) struct Args {
    /// Program: a TOML file, PlayBackPoints.xml or a .play file
    program: PathBuf,
    /// Number of cycles (default: as in the program)
    #[arg(long, value_name = "N", value_parser = values::whole_from(1), conflicts_with = "forever")]
    times: Option<u64>,
    /// Start at this step, counted from 1 as in `dobot check` and `dobot jobs`
    #[arg(long, value_name = "STEP", value_parser = values::whole_from(1))]
    from: Option<u64>,
    /// Repeat until a person ends it
    #[arg(long)]
    forever: bool,
    /// Run only the first step, then pause
    #[arg(long, conflicts_with = "dry_run")]
    step: bool,
    /// Simulate only: check the program and print its duration
    #[arg(long)]
    dry_run: bool,
    /// Arm the laser for this many seconds, 1 to 3600; everyone present must wear goggles
    #[arg(long, value_name = "SECONDS", value_parser = values::laser_seconds)]
    arm_laser: Option<Duration>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    // Report problems of the program before connecting to an arm.
    let rules = Rules::of(&args.to.policy()?);
    let planned = Planned::new(&args, &PlannedFor::any(rules.into(), args.to.dialect))?;
    if args.dry_run {
        return planned.print(args.json);
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
        planned.print(false)?;
    }
    // Take control first, so that a queued job can be started.
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

/// A checked program.
struct Planned {
    job: NewJob,
    /// The prediction of the twin.
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
            let count = output::count(count, "problem");
            return Err(anyhow!("{file} has {count}:\n{}", problems.join("\n")).into());
        }
        let job = compiled.job();
        let prediction = predict(
            &job,
            policy,
            personality_of(arm.dialect()),
            arm.calibration.as_ref(),
        );
        let prediction = prediction.map_err(|error| anyhow!("in the simulation: {error}"))?;
        Ok(Self { job, prediction })
    }

    /// Prints the duration.
    fn print(&self, as_json: bool) -> Result<(), Failure> {
        let times = self.times();
        if as_json {
            return Ok(output::json(&times)?);
        }
        let cycle = times
            .cycle_s
            .map(|cycle_s| format!("a cycle takes {}", clock(cycle_s)));
        let total = match times.total_s {
            Some(total_s) => format!("{} in total", clock(total_s)),
            None => "until a person ends it".to_owned(),
        };
        let steps = output::count(self.job.program.steps.len(), "step");
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

    /// The duration of each step in the first cycle, in seconds.
    fn steps_s(&self) -> Vec<f64> {
        let until_s = &self.prediction.until_s;
        let over = |command: usize| command.checked_sub(1).map_or(0.0, |last| until_s[last]);
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
            #[expect(clippy::cast_precision_loss, reason = "2^53 cycles never end")]
            Some(JobRepeat { times, .. }) => times
                .map(|times| times.saturating_sub(1) as f64)
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

/// The durations of a program on the twin.
#[derive(Debug, Serialize)]
struct DryRunTimes {
    steps: usize,
    /// The duration of each step in the first cycle.
    steps_s: Vec<f64>,
    commands: usize,
    /// The duration of the first cycle.
    first_s: f64,
    /// The duration of each further cycle.
    cycle_s: Option<f64>,
    /// The total duration; `None` if a person has to end it.
    total_s: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Done {
    job: u64,
    took_s: f64,
}

/// The number of cycles that the arguments ask for.
fn times(args: &Args) -> Option<Times> {
    let count = args.times.map(Times::Count);
    count.or_else(|| args.forever.then_some(Times::Forever))
}

/// Returns a program from a step on, counted from 1.
fn from_step(program: &Compiled, step: u64, file: &Path) -> Result<Compiled, Failure> {
    let rest = usize::try_from(step - 1)
        .ok()
        .and_then(|index| program.from_step(index));
    rest.ok_or_else(|| {
        let (file, steps) = (file.display(), program.steps.len());
        let steps = output::count(steps, "step");
        Failure::usage(anyhow!("{file} has {steps}, and --from is {step}"))
    })
}
