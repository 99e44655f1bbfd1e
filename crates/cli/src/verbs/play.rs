//! `dobot play`: runs a program, once, several times, or until a person ends it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use dobot_api::{Answer, NewJob};
use dobot_host::{DryRun, PlannedFor, StationClient, dry_run, dry_run_program};
use dobot_teach::{Compiled, Program, Times};
use serde::Serialize;

use crate::connect::To;
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
    /// Program: a TOML file, PlayBackPoints.xml, a .play or a .playback file
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
    // Report what is wrong with the text before connecting to an arm.
    let program = program_file::read_program(&args.program)?;
    if args.dry_run {
        let (arm, arm_line) = args.to.planned_for("play").await?;
        return Planned::new(&args, &program, &arm)?.print(args.json, Some(arm_line));
    }
    let play = async |station: &mut StationClient| play(station, &args, &program).await;
    args.to.with_arm("play", play).await
}

async fn play(station: &mut StationClient, args: &Args, program: &Program) -> Result<(), Failure> {
    let arm = control::planned_for(station).await?;
    let planned = Planned::new(args, program, &arm)?;
    check_pose(station, args.to.pose_confirmed).await?;
    if !args.json {
        planned.print(false, None)?;
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
    compiled: Compiled,
    job: NewJob,
    dry_run: DryRun,
}

impl Planned {
    fn new(args: &Args, program: &Program, arm: &PlannedFor) -> Result<Self, Failure> {
        let file = &args.program;
        let (program, compiled) = program_file::compile_times(file, program, times(args), arm)?;
        let mut files = program_file::files_beside(file, arm);
        let from = args
            .from
            .map_or(0, |step| usize::try_from(step - 1).unwrap_or(usize::MAX));
        let (path, whole) = if compiled.asks {
            let (path, whole) = dry_run_program(&program, arm, &mut files)?;
            (path, Some(whole))
        } else {
            (compiled, None)
        };
        let job = program.job(&path, from, &arm.arm(), &mut files);
        let job = job.with_context(|| file.display().to_string())?;
        let job = job.ok_or_else(|| no_step(&path, from + 1, file))?;
        let rest = path.from_step(from).unwrap_or_default();
        let dry_run = match whole {
            Some(whole) if from == 0 || !whole.problems.is_empty() => whole,
            whole => DryRun {
                depends_on_answers: whole.is_some(),
                ..dry_run(&rest, arm)
            },
        };
        let problems: Vec<String> = dry_run.problems.iter().map(ToString::to_string).collect();
        if !problems.is_empty() {
            let (file, count) = (args.program.display(), problems.len());
            let count = output::count(count, "problem");
            return Err(anyhow!("{file} has {count}:\n{}", problems.join("\n")).into());
        }
        Ok(Self {
            compiled: rest,
            job,
            dry_run,
        })
    }

    /// Prints the durations, and the arm that they are for.
    fn print(&self, as_json: bool, arm: Option<String>) -> Result<(), Failure> {
        if as_json {
            return Ok(output::json(&DryRunTimes {
                arm,
                steps: self.compiled.steps.len(),
                commands: self.compiled.commands.len(),
                dry_run: &self.dry_run,
            })?);
        }
        output::line(&program_file::summary(&self.compiled, &self.dry_run))?;
        if let Some(line) = self.start_line() {
            output::line(&line)?;
        }
        arm.map_or(Ok(()), |arm| Ok(output::line(&arm)?))
    }
}

impl Planned {
    /// The step that a program starts at after a question, with the answers to the earlier ones.
    fn start_line(&self) -> Option<String> {
        let asking = self.job.program.asking.as_ref()?;
        let choices = asking.answers.iter().filter_map(|answer| match answer {
            Answer::Choice(text) => Some(text.as_str()),
            _ => None,
        });
        let choices: Vec<&str> = choices.collect();
        if choices.is_empty() {
            return None;
        }
        let (step, choices) = (asking.from_step + 1, choices.join(", "));
        Some(format!(
            "starts at step {step}; the questions before it count as answered: {choices}"
        ))
    }
}

/// The durations of a program on the twin.
#[derive(Debug, Serialize)]
struct DryRunTimes<'a> {
    /// The arm that they are for.
    arm: Option<String>,
    steps: usize,
    commands: usize,
    #[serde(flatten)]
    dry_run: &'a DryRun,
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

/// The failure for a step that does not exist, counted from 1.
fn no_step(program: &Compiled, step: usize, file: &Path) -> Failure {
    let (file, steps) = (file.display(), program.steps.len());
    let steps = output::count(steps, "step");
    let answered = if program.asks {
        " with the first answer to each question"
    } else {
        ""
    };
    Failure::usage(anyhow!(
        "{file} has {steps}{answered}, and --from is {step}"
    ))
}
