//! A plan on its way to an arm: from this process, or as a job of the station.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_client::position;
use dobot_draw::{Parting, Plan, Progress, Stopped};
use dobot_station::{JobKind, JobPause, NewJob, Remote, Reply, Request, State};
use indicatif::{ProgressBar, ProgressStyle};
use tokio::io::{AsyncBufReadExt, BufReader};

use super::args::Args;
use crate::connect::{Connected, Reached};
use crate::control::{arm_laser, first_state, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::guard;
use crate::interrupt::interrupt;
use crate::output::clock;

/// Where the statuses saw the tool, and how long it took or why it did not get to the end.
pub(super) struct Executed {
    pub(super) outcome: Result<Duration, Failure>,
    pub(super) seen: Vec<dobot_arm::Position>,
}

impl Executed {
    fn failed(failure: Failure) -> Self {
        Self {
            outcome: Err(failure),
            seen: Vec::new(),
        }
    }
}

/// Draws from this process.
pub(super) async fn direct(connected: &mut Connected, plan: &Plan, total_s: f64) -> Executed {
    if let Err(failure) = check(connected, plan).await {
        return Executed::failed(failure);
    }
    let bar = progress_bar(plan);
    let scale = total_s / plan.duration_s().max(f64::MIN_POSITIVE);
    let tell = |progress: Progress| {
        bar.set_position(progress.vectors as u64);
        bar.set_message(clock(total_s - progress.planned_s * scale));
    };
    let confirm = async |message: &str| {
        bar.suspend(|| prompt(message));
        enter().await;
    };
    let outcome = dobot_draw::run(&mut connected.arm, plan, confirm, interrupt(), tell).await;
    bar.finish_and_clear();
    match outcome {
        Ok(finished) => Executed {
            outcome: Ok(finished.time),
            seen: finished.seen,
        },
        Err(mut stopped) => Executed {
            seen: std::mem::take(&mut stopped.seen),
            outcome: Err(stopped_failure(stopped)),
        },
    }
}

/// What would stop the drawing half way is found out before anything moves.
async fn check(connected: &mut Connected, plan: &Plan) -> Result<(), Failure> {
    guard::check_all(connected, plan.commands()).await?;
    let asks = !plan.breaks.is_empty() && connected.virtual_arm.is_none();
    if asks && !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("the pen has to be changed, and there is nobody at the terminal to do it"),
            "run it in a terminal, or through a station: `dobot up`",
        ));
    }
    Ok(())
}

/// What would not be let burn is told before anything moves or is queued; the laser of an arm that this
/// process talks to is armed from here on.
pub(super) async fn check_laser(
    reached: &mut Reached,
    plan: &Plan,
    args: &Args,
) -> Result<(), Failure> {
    let armed = match reached {
        _ if !plan.burns() => true,
        Reached::Station(_) if args.tool.arm_laser.is_some() => true,
        Reached::Station(station) => first_state(station).await?.laser.armed_for_s > 0.0,
        Reached::Arm(it) => {
            if let Some(time) = args.tool.arm_laser {
                it.arm.arm_laser(time);
            }
            it.arm.session().laser_armed_until().is_some()
        }
    };
    if armed {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("the laser is disarmed"),
        "put the goggles on, then let `dobot draw` burn for a while: `--arm-laser SECONDS`",
    ))
}

/// Queues a plan as a job of the station, and follows it.
pub(super) async fn through(
    station: &mut Remote,
    plan: &Plan,
    title: &str,
    args: &Args,
) -> Executed {
    let mut seen = Vec::new();
    let see = |state: &State| {
        seen.extend(state.arm.as_ref().map(|arm| position(&arm.status)));
    };
    let outcome = job(station, plan, title, args, see).await;
    Executed { outcome, seen }
}

async fn job(
    station: &mut Remote,
    plan: &Plan,
    title: &str,
    args: &Args,
    see: impl FnMut(&State),
) -> Result<Duration, Failure> {
    // Nothing is queued that cannot be started.
    take_control(station).await?;
    arm_laser(station, args.tool.arm_laser).await?;
    let pauses = plan.breaks_in_commands().map(|(before, message)| JobPause {
        before,
        message: message.to_owned(),
    });
    let job = NewJob {
        title: title.to_owned(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: lift_mm(plan),
        pauses: pauses.collect(),
    };
    match station.request(Request::SubmitJob { job }).await? {
        Reply::Job { job } => follow::start(station, job.job, plan.burns(), see).await,
        other => Err(anyhow!("the station answers {other:?} to a new job").into()),
    }
}

/// Tells a person why it waits, and for what.
fn prompt(message: &str) {
    eprintln!("{message}");
    if std::io::stdin().is_terminal() {
        eprintln!("press Enter to go on");
    }
}

/// Waits for a person at the terminal; where there is none, a virtual arm goes on.
async fn enter() {
    if std::io::stdin().is_terminal() {
        // Whoever closes the terminal is heard as a signal.
        line_entered().await;
    }
}

/// Whether a frame has its person; that of a virtual arm in this process needs none.
pub(super) fn check_frame(reached: &Reached) -> Result<(), Failure> {
    if is_harmless(reached) || std::io::stdin().is_terminal() {
        return Ok(());
    }
    Err(Failure::new(
        anyhow!("nobody is there to be asked whether the frame is where the drawing is to be"),
        "run it in a terminal, with the drawing in a file, or leave `--frame` out",
    ))
}

/// Asks whether the frame that was gone around is the place.
pub(super) async fn ask_about_frame(reached: &Reached) -> Result<(), Failure> {
    if is_harmless(reached) && !std::io::stdin().is_terminal() {
        return Ok(());
    }
    prompt("this is where it will be; Ctrl-C leaves it undone");
    let agreed = tokio::select! {
        entered = line_entered() => entered,
        // The way around it has taken Ctrl-C from the system.
        () = interrupt() => false,
    };
    if agreed {
        return Ok(());
    }
    Err(anyhow!("left undone after the frame; nothing was drawn").into())
}

const fn is_harmless(reached: &Reached) -> bool {
    matches!(reached, Reached::Arm(it) if it.virtual_arm.is_some())
}

/// Whether a line came, and not the end of all lines.
async fn line_entered() -> bool {
    let mut line = String::new();
    let mut lines = BufReader::new(tokio::io::stdin());
    matches!(lines.read_line(&mut line).await, Ok(1..))
}

fn stopped_failure(stopped: Stopped) -> Failure {
    match stopped.parting {
        Parting::Done | Parting::Unneeded => stopped.into(),
        Parting::Sent | Parting::Lost => Failure::new(
            stopped,
            "look after the arm: lift the pen or switch it off by hand",
        ),
    }
}

fn progress_bar(plan: &Plan) -> ProgressBar {
    let vectors = plan.moves.len() as u64;
    let style =
        ProgressStyle::with_template("{wide_bar:.cyan/dim} {pos}/{len} vectors, {msg} left");
    ProgressBar::new(vectors).with_style(style.expect("the template is well-formed"))
}

#[expect(clippy::cast_possible_truncation, reason = "as the job holds it")]
fn lift_mm(plan: &Plan) -> f32 {
    plan.lift_mm() as f32
}
