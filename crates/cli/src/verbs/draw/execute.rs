//! Execution of a plan as a job.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{RemoteError, State, problem_kinds};
use dobot_host::{StationClient, drawing_job};
use dobot_plan::Plan;
use dobot_session::position;
use indicatif::ProgressBar;

use crate::control::{arm_laser, first_state, line_entered, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::interrupt::interrupt;

/// The outcome of a plan: its duration or failure, and the reported positions.
pub(super) struct Executed {
    pub(super) outcome: Result<Duration, Failure>,
    /// The planned duration of the job, in seconds, including the way to the start; `None` if it was not
    /// executed.
    pub(super) planned_s: Option<f64>,
    pub(super) seen: Vec<dobot_arm::Position>,
}

/// Checks that the laser is armed for a plan that burns, before anything moves or is queued.
pub(super) async fn check_laser(
    station: &mut StationClient,
    plan: &Plan,
    armed_for: Option<Duration>,
) -> Result<(), Failure> {
    let armed =
        !plan.burns() || armed_for.is_some() || first_state(station).await?.laser.armed_for_s > 0.0;
    if armed {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("the laser is disarmed"),
        "put on goggles, then arm the laser with `--arm-laser SECONDS`",
    ))
}

/// Submits a plan as a job, starts it and follows it.
pub(super) async fn execute(
    station: &mut StationClient,
    plan: &Plan,
    title: &str,
    armed_for: Option<Duration>,
    bar: &ProgressBar,
) -> Executed {
    let mut seen = Vec::new();
    let mut planned_s = None;
    let see = |state: &State| {
        seen.extend(state.arm.as_ref().map(|arm| position(&arm.status)));
        let job = state.job.as_ref();
        planned_s = job.and_then(|job| job.planned_s).or(planned_s);
    };
    let outcome = match submit(station, plan, title, armed_for).await {
        Ok(job) => start(station, job, plan.burns(), bar, see).await,
        Err(failure) => Err(failure),
    };
    Executed {
        outcome,
        planned_s,
        seen,
    }
}

/// Starts and follows a job, and removes it if it did not start.
async fn start(
    station: &mut StationClient,
    job: u64,
    burns: bool,
    bar: &ProgressBar,
    see: impl FnMut(&State),
) -> Result<Duration, Failure> {
    let outcome = follow::start_shown(station, job, burns, bar, see).await;
    if outcome.is_err() {
        station.remove_unstarted(job).await;
    }
    outcome
}

async fn submit(
    station: &mut StationClient,
    plan: &Plan,
    title: &str,
    armed_for: Option<Duration>,
) -> Result<u64, Failure> {
    // Take control first, so that a queued job can be started.
    take_control(station).await?;
    arm_laser(station, armed_for).await?;
    let submitted = station.submit(drawing_job(plan, title)).await;
    submitted.map_err(refused)
}

/// Adds a hint to a refused drawing.
fn refused(error: RemoteError) -> Failure {
    if error.kind() != Some(problem_kinds::BAD_JOB.name) {
        return error.into();
    }
    let rule = match &error {
        RemoteError::Refused(problem) => problem.rule.clone(),
        _ => None,
    };
    let remedy = rule.map_or(
        "try another `--speed`, position or size (`--at`, `--fit`, `--scale`)",
        |rule| remedy(&rule),
    );
    Failure::new(error, format!("{remedy}; `dobot policy` shows the rules"))
}

/// The remedy for a drawing that a rule of the policy refuses.
fn remedy(rule: &str) -> &'static str {
    match rule.split_once('.') {
        Some(("acceleration", _)) => "try another `--acceleration`",
        Some(("laser", "least_speed")) => {
            "try another `--speed`, or a material with another one (`dobot materials`); corners and short lines that are slow at any speed need a larger `--tolerance` or `--scale`"
        }
        Some(("laser", "longest")) => {
            "try a higher `--speed` or `--acceleration`, or a policy with a larger `laser.longest_s` (`--policy`)"
        }
        Some(("speed", _)) => {
            "try another `--speed` or `--travel-speed`, or another pen or material (`dobot materials`)"
        }
        Some(("laser", "allowed" | "standing")) => {
            "use a policy that allows the laser (`--policy`)"
        }
        _ => "move it or make it smaller (`--at`, `--fit`, `--scale`)",
    }
}

/// Checks that a person can answer the question; a virtual arm in this process needs none.
pub(super) fn check_frame(station: &StationClient) -> Result<(), Failure> {
    if is_harmless(station) || std::io::stdin().is_terminal() {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("--outline asks whether the position is right, and standard input is no terminal"),
        "run it in a terminal with the drawing in a file, or leave out `--outline`",
    ))
}

/// Asks whether the traced outline is at the right position.
pub(super) async fn ask_about_frame(station: &StationClient) -> Result<(), Failure> {
    if is_harmless(station) && !std::io::stdin().is_terminal() {
        return Ok(());
    }
    eprintln!("this is where it will be drawn");
    eprintln!("press Enter to continue or Ctrl-C to cancel");
    let agreed = tokio::select! {
        entered = line_entered() => entered.is_some(),
        // Ctrl-C no longer ends the process by now.
        () = interrupt() => false,
    };
    if agreed {
        return Ok(());
    }
    Err(anyhow!("cancelled after the outline; nothing was drawn").into())
}

const fn is_harmless(station: &StationClient) -> bool {
    station.virtual_arm().is_some()
}
