//! Having an arm do something, under its rules.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{ArmView, RemoteError, Reply, Request, State};
use dobot_host::{PlannedFor, Rules, StationClient};
use dobot_safety::Policy;
use dobot_wire::{Command, Dialect, Status};
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::time::timeout;

use crate::connect::To;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;

/// Takes control of the arm.
pub(crate) async fn take_control(station: &mut StationClient) -> Result<(), RemoteError> {
    station.request(Request::TakeLease).await?;
    Ok(())
}

/// Lets the laser be switched on for a while, if that is wanted; control has been taken.
pub(crate) async fn arm_laser(
    station: &mut StationClient,
    time: Option<Duration>,
) -> Result<(), RemoteError> {
    if let Some(time) = time {
        let for_s = time.as_secs_f64();
        station.request(Request::ArmLaser { for_s }).await?;
    }
    Ok(())
}

/// Sends a command and waits until it is over; Ctrl-C stops the arm.
pub(crate) async fn carry_out(
    station: &mut StationClient,
    command: Command,
) -> Result<(), Failure> {
    let reply = station
        .request_at_rest(Request::Command { command })
        .await?;
    let Reply::Accepted { command, .. } = reply else {
        // A switch that is over at once.
        return Ok(());
    };
    tokio::select! {
        done = station.finished(command) => return Ok(done?),
        () = interrupt() => {}
    }
    stop(station).await
}

/// Carries out one command, which is made from how the arm stands and from its dialect; the laser may be
/// switched on for so long. Gives how the arm rests then.
pub(crate) async fn carry_out_one(
    station: &mut StationClient,
    to: &To,
    laser: Option<Duration>,
    command: impl FnOnce(&Status, Option<Dialect>) -> Result<Command, Failure>,
) -> Result<Status, Failure> {
    check_pose(station, to.pose_confirmed).await?;
    let (arm, dialect) = arm(station).await?;
    let command = command(&arm.status, dialect)?;
    take_control(station).await?;
    arm_laser(station, laser).await?;
    carry_out(station, command).await?;
    rest(station).await
}

/// Stops the arm, because this program was interrupted.
pub(crate) async fn stop(station: &mut StationClient) -> Result<(), Failure> {
    let reason = Some("Ctrl-C was pressed".to_owned());
    station.request(Request::Stop { reason }).await?;
    Err(Failure::new(
        anyhow!("interrupted; the arm is stopped"),
        "when it may move again: `dobot stop --reset`",
    ))
}

/// The line that a person enters; `None` at the end of all lines.
pub(crate) async fn line_entered() -> Option<String> {
    let mut line = String::new();
    let mut lines = BufReader::new(tokio::io::stdin());
    match lines.read_line(&mut line).await {
        Ok(1..) => Some(line),
        _ => None,
    }
}

/// The first state that the station tells.
pub(crate) async fn first_state(station: &mut StationClient) -> Result<State, Failure> {
    let state = timeout(PATIENCE, station.state()).await;
    Ok(state.map_err(|_| RemoteError::Silent)??)
}

/// What the arm tells next, through its station.
pub(crate) async fn status(station: &mut StationClient) -> Result<Status, Failure> {
    Ok(arm(station).await?.0.status)
}

/// For which arm to plan: as it stands, by these rules.
pub(crate) async fn planned_for(
    station: &mut StationClient,
    policy: &Policy,
) -> Result<PlannedFor, Failure> {
    let state = station.first_state().await?;
    Ok(station.planned_for(Rules::of(policy), &state).await?)
}

/// What the arm tells next, and which dialect it speaks if that is known. A station that has just
/// been started is waited for until its arm tells something.
pub(crate) async fn arm(
    station: &mut StationClient,
) -> Result<(ArmView, Option<Dialect>), Failure> {
    let state = station.first_state().await?;
    let arm = state.arm.ok_or(RemoteError::Silent)?;
    Ok((arm, state.dialect))
}

/// Whether the arm stands where it says is known before it is moved: a person is asked, or has said
/// so already (`--pose-confirmed`).
pub(crate) async fn check_pose(
    station: &mut StationClient,
    pose_confirmed: bool,
) -> Result<(), Failure> {
    arm(station).await?;
    let state = first_state(station).await?;
    let (Some(arm), false) = (&state.arm, state.trust.trusted) else {
        return Ok(());
    };
    let why = state.trust.reason.unwrap_or_default();
    if !pose_confirmed && !ask_about_pose(&why, &arm.status).await? {
        return Err(anyhow!("the pose was not confirmed; nothing was moved").into());
    }
    station.request(Request::ConfirmPose).await?;
    Ok(())
}

/// Tells what happened, and asks whether the arm stands where it says.
async fn ask_about_pose(why: &str, status: &Status) -> Result<bool, Failure> {
    if !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("the arm may not stand where it says, and nobody is there to be asked: {why}"),
            "look at the arm; where it stands as `dobot status` says: `--pose-confirmed`",
        ));
    }
    eprintln!("The arm may not stand where it says: {why}.");
    eprintln!("{}", output::status_text(status));
    eprintln!(
        "Look at it: does it stand there, and does it point to where base {:.1}° is? y or n",
        status.base_deg
    );
    let answer = tokio::task::spawn_blocking(|| {
        let mut line = String::new();
        std::io::stdin().read_line(&mut line).map(|_| line)
    });
    tokio::select! {
        answer = answer => Ok(matches!(answer??.trim(), "y" | "Y" | "yes")),
        () = interrupt() => Ok(false),
    }
}

/// What the arm tells when it has come to rest.
pub(crate) async fn rest(station: &mut StationClient) -> Result<Status, Failure> {
    loop {
        let (arm, _) = arm(station).await?;
        if !arm.moving {
            return Ok(arm.status);
        }
    }
}

/// The same, but no longer than a motion that runs down takes.
pub(crate) async fn rest_soon(station: &mut StationClient) -> Result<(), Failure> {
    let until = station.now() + PATIENCE;
    while arm(station).await?.0.moving && station.now() < until {}
    Ok(())
}

const PATIENCE: Duration = Duration::from_secs(5);
