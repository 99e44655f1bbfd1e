//! Sending commands to an arm, under its rules.

use std::io::IsTerminal;
use std::time::Duration;

use anyhow::anyhow;
use dobot_api::{ArmView, RemoteError, Reply, Request, State};
use dobot_host::{PlannedFor, StationClient};
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

/// Arms the laser for a time, if any; the client must have control.
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

/// Sends a command and waits for its end; Ctrl-C stops the arm.
pub(crate) async fn run_command(
    station: &mut StationClient,
    command: Command,
) -> Result<(), Failure> {
    let reply = station
        .request_at_rest(Request::Command { command })
        .await?;
    let Reply::Accepted { command, .. } = reply else {
        // A switch, which ends immediately.
        return Ok(());
    };
    tokio::select! {
        done = station.finished(command) => return Ok(done?),
        () = interrupt() => {}
    }
    stop(station).await
}

/// Carries out one command, created from the status and the dialect of the arm. Arms the laser for a
/// time, if any. Returns the status at rest.
pub(crate) async fn run_one_command(
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
    run_command(station, command).await?;
    wait_for_rest(station).await
}

/// Stops the arm, because this program was interrupted.
pub(crate) async fn stop(station: &mut StationClient) -> Result<(), Failure> {
    let reason = Some("Ctrl-C was pressed".to_owned());
    station.request(Request::Stop { reason }).await?;
    Err(Failure::new(
        anyhow!("interrupted; the arm is stopped"),
        "look at the arm, then run `dobot stop --reset`",
    ))
}

/// Reads a line from standard input; `None` at its end.
pub(crate) async fn line_entered() -> Option<String> {
    let mut line = String::new();
    let mut lines = BufReader::new(tokio::io::stdin());
    match lines.read_line(&mut line).await {
        Ok(1..) => Some(line),
        _ => None,
    }
}

/// Returns the first state that the station reports.
pub(crate) async fn first_state(station: &mut StationClient) -> Result<State, Failure> {
    let state = timeout(PATIENCE, station.state()).await;
    Ok(state.map_err(|_| RemoteError::Silent)??)
}

/// Returns the next status of the arm.
pub(crate) async fn status(station: &mut StationClient) -> Result<Status, Failure> {
    Ok(arm(station).await?.0.status)
}

/// Returns the arm to plan for: its current state and its rules.
pub(crate) async fn planned_for(station: &mut StationClient) -> Result<PlannedFor, Failure> {
    let state = station.first_state().await?;
    Ok(station.planned_for(&state).await?)
}

/// Returns the next report of the arm, and its dialect if it is known. Waits for the first report after
/// the start of a station.
pub(crate) async fn arm(
    station: &mut StationClient,
) -> Result<(ArmView, Option<Dialect>), Failure> {
    let state = station.first_state().await?;
    let arm = state.arm.ok_or(RemoteError::Silent)?;
    Ok((arm, state.dialect))
}

/// Ensures that the pose of the arm is confirmed before a motion: by a question to the person, or by
/// `--pose-confirmed`.
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

/// Asks whether the arm has the pose that it reports.
async fn ask_about_pose(why: &str, status: &Status) -> Result<bool, Failure> {
    if !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!(
                "the arm may not be at the position it reports, and standard input is no terminal: {why}"
            ),
            "look at the arm; if it is where `dobot status` shows it, add `--pose-confirmed`",
        ));
    }
    eprintln!("The arm may not be at the position it reports: {why}.");
    eprintln!("{}", output::status_text(status));
    eprintln!(
        "Look at it: is it there, and does it point in the direction of base {:.1}°? y or n",
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

/// Waits until the arm is at rest, and returns its status.
pub(crate) async fn wait_for_rest(station: &mut StationClient) -> Result<Status, Failure> {
    Ok(station.rest().await?.status)
}

/// Waits until the arm is at rest, at most 5 s.
pub(crate) async fn wait_briefly_for_rest(station: &mut StationClient) -> Result<(), Failure> {
    timeout(PATIENCE, station.rest()).await.ok().transpose()?;
    Ok(())
}

const PATIENCE: Duration = Duration::from_secs(5);
