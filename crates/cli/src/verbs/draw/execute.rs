//! A plan on its way to an arm, as a job.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{RemoteError, State, problem_kinds};
use dobot_host::{StationClient, drawing_job};
use dobot_motion::Model;
use dobot_plan::Plan;
use dobot_session::position;
use indicatif::ProgressBar;

use crate::control::{self, arm_laser, first_state, line_entered, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::interrupt::interrupt;

/// Where the statuses saw the tool, and how long it took or why it did not get to the end.
pub(super) struct Executed {
    pub(super) outcome: Result<Duration, Failure>,
    /// How long all of it was to take by the motion model, in seconds, the way to its start
    /// included; absent where it was not taken.
    pub(super) planned_s: Option<f64>,
    pub(super) seen: Vec<dobot_arm::Position>,
}

/// What would not burn is told before anything moves or is queued.
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
        "put the goggles on, then let `dobot draw` burn for a while: `--arm-laser SECONDS`",
    ))
}

/// Makes a job of a plan, starts it and follows it.
pub(super) async fn execute(
    station: &mut StationClient,
    plan: &Plan,
    title: &str,
    armed_for: Option<Duration>,
    bar: &ProgressBar,
) -> Executed {
    let mut seen = Vec::new();
    let see = |state: &State| {
        seen.extend(state.arm.as_ref().map(|arm| position(&arm.status)));
    };
    let planned_s = way_s(station, plan).await.map(|it| it + plan.duration_s());
    let outcome = match submit(station, plan, title, armed_for).await {
        Ok(job) => {
            let outcome = follow::start_shown(station, job, plan.burns(), bar, see).await;
            if outcome.is_err() {
                station.remove_unstarted(job).await;
            }
            outcome
        }
        Err(failure) => Err(failure),
    };
    Executed {
        outcome,
        planned_s,
        seen,
    }
}

/// How long the way to the plan's start takes from where the arm stands, in seconds.
async fn way_s(station: &mut StationClient, plan: &Plan) -> Option<f64> {
    let (arm, dialect) = control::arm(station).await.ok()?;
    let model = Model::new(dialect?, &arm.status);
    let to_start = plan.commands().nth(plan.command_of(0) - 1)?;
    model.trajectory(&to_start).ok()?.duration_s()
}

async fn submit(
    station: &mut StationClient,
    plan: &Plan,
    title: &str,
    armed_for: Option<Duration>,
) -> Result<u64, Failure> {
    // Nothing is queued that cannot be started.
    take_control(station).await?;
    arm_laser(station, armed_for).await?;
    let submitted = station.submit(drawing_job(plan, title)).await;
    submitted.map_err(refused)
}

/// Nobody changes a command of a drawing.
fn refused(error: RemoteError) -> Failure {
    if error.kind() != Some(problem_kinds::BAD_JOB.name) {
        return error.into();
    }
    let rule = match &error {
        RemoteError::Refused(problem) => problem.rule.clone(),
        _ => None,
    };
    let helps = rule.map_or(
        "another `--speed`, place or size (`--at`, `--fit`, `--scale`)",
        |it| what_helps(&it),
    );
    Failure::new(error, format!("{helps}; `dobot policy` shows the rules"))
}

/// What of a drawing has to be otherwise, where this rule of the policy refuses it.
fn what_helps(rule: &str) -> &'static str {
    match rule.split_once('.') {
        Some(("acceleration", _)) => "another `--acceleration`",
        Some(("laser", "least_speed")) => {
            "another `--speed`, or a material that is burned at another one (`dobot materials`); corners and short lines that are slower at any speed need a larger `--tolerance` or `--scale`"
        }
        Some(("laser", "longest")) => {
            "a higher `--speed` or `--acceleration`, or a policy with a larger `laser.longest_s` (`--policy`)"
        }
        Some(("speed", _)) => {
            "another `--speed` or `--travel-speed`, or a pen or material with others (`dobot materials`)"
        }
        Some(("laser", "allowed" | "standing")) => "a policy that lets the laser burn (`--policy`)",
        _ => "place it elsewhere or make it smaller (`--at`, `--fit`, `--scale`)",
    }
}

/// Whether a frame has its person; that of a virtual arm in this process needs none.
pub(super) fn check_frame(station: &StationClient) -> Result<(), Failure> {
    if is_harmless(station) || std::io::stdin().is_terminal() {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("nobody is there to be asked whether the frame is where the drawing is to be"),
        "run it in a terminal, with the drawing in a file, or leave `--frame` out",
    ))
}

/// Asks whether the frame that was gone around is the place.
pub(super) async fn ask_about_frame(station: &StationClient) -> Result<(), Failure> {
    if is_harmless(station) && !std::io::stdin().is_terminal() {
        return Ok(());
    }
    eprintln!("this is where it will be; Ctrl-C leaves it undone");
    eprintln!("press Enter to go on");
    let agreed = tokio::select! {
        entered = line_entered() => entered.is_some(),
        // The way around it has taken Ctrl-C from the system.
        () = interrupt() => false,
    };
    if agreed {
        return Ok(());
    }
    Err(anyhow!("left undone after the frame; nothing was drawn").into())
}

const fn is_harmless(station: &StationClient) -> bool {
    station.virtual_arm().is_some()
}
