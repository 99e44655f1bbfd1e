//! Having a station do something.

use std::time::Duration;

use anyhow::anyhow;
use dobot_station::{ArmView, LinkPhase, Remote, RemoteError, Reply, Request, State};
use dobot_wire::{Command, Dialect, Status};
use tokio::time::{Instant, sleep, timeout, timeout_at};

use crate::failure::Failure;
use crate::interrupt::interrupt;

/// Takes control of the arm.
pub(crate) async fn take_control(station: &mut Remote) -> Result<(), RemoteError> {
    station.request(Request::TakeLease).await?;
    Ok(())
}

/// Lets the laser be switched on for a while, if that is wanted; control has been taken.
pub(crate) async fn arm_laser(
    station: &mut Remote,
    time: Option<Duration>,
) -> Result<(), RemoteError> {
    if let Some(time) = time {
        let for_s = time.as_secs_f64();
        station.request(Request::ArmLaser { for_s }).await?;
    }
    Ok(())
}

/// Asks for something that takes an arm at rest, as soon as it is.
pub(crate) async fn request_at_rest(
    station: &mut Remote,
    request: Request,
) -> Result<Reply, RemoteError> {
    let until = Instant::now() + PATIENCE;
    loop {
        match station.request(request.clone()).await {
            Err(error) if error.kind() == Some("still-moving") && Instant::now() < until => {
                sleep(PAUSE).await;
            }
            answer => return answer,
        }
    }
}

/// Sends a command and waits until it is over; Ctrl-C stops the arm.
pub(crate) async fn carry_out(station: &mut Remote, command: Command) -> Result<(), Failure> {
    let reply = station.request(Request::Command { command }).await?;
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

/// Stops the arm, because this program was interrupted.
pub(crate) async fn stop(station: &mut Remote) -> Result<(), Failure> {
    let reason = Some("Ctrl-C was pressed".to_owned());
    station.request(Request::Stop { reason }).await?;
    Err(Failure::new(
        anyhow!("interrupted; the arm is stopped"),
        "when it may move again: `dobot stop --reset`",
    ))
}

/// The first state that the station tells.
pub(crate) async fn first_state(station: &mut Remote) -> Result<State, Failure> {
    let state = timeout(PATIENCE, station.state()).await;
    Ok(state.map_err(|_| RemoteError::Silent)??)
}

/// What the arm tells next, through its station.
pub(crate) async fn status(station: &mut Remote) -> Result<Status, Failure> {
    Ok(arm(station).await?.0.status)
}

/// What the arm tells next, and which dialect it speaks if that is known. A station that has just
/// been started is waited for until its arm tells something.
pub(crate) async fn arm(station: &mut Remote) -> Result<(ArmView, Option<Dialect>), Failure> {
    let mut missing = RemoteError::Silent.into();
    let until = Instant::now() + PATIENCE;
    while let Ok(state) = timeout_at(until, station.state()).await {
        let state = state?;
        match &state.arm {
            Some(arm) if state.link.phase == LinkPhase::Up => {
                return Ok((arm.clone(), state.dialect));
            }
            _ => missing = no_arm(&state),
        }
    }
    Err(missing)
}

/// What the arm tells when it has come to rest.
pub(crate) async fn rest(station: &mut Remote) -> Result<Status, Failure> {
    loop {
        let (arm, _) = arm(station).await?;
        if !arm.moving {
            return Ok(arm.status);
        }
    }
}

/// Waits until nothing is under way any more, or no arm is there to do anything: three states in a
/// row say so, for between two commands it looks like that, too.
pub(crate) async fn idle(station: &mut Remote) -> Result<(), Failure> {
    let mut idle = 0;
    while idle < 3 {
        let state = first_state(station).await?;
        if state.link.phase != LinkPhase::Up {
            return Ok(());
        }
        let moving = state.arm.as_ref().is_some_and(|it| it.moving);
        let busy = moving || state.queue.waiting + state.queue.under_way > 0;
        idle = if busy { 0 } else { idle + 1 };
    }
    Ok(())
}

fn no_arm(state: &State) -> Failure {
    let why = match (&state.link.problem, state.link.phase) {
        (Some(problem), _) => problem.clone(),
        (None, LinkPhase::Searching) => "no arm has been found yet".into(),
        (None, _) => "the arm says nothing".into(),
    };
    Failure::new(
        anyhow!("the station has no arm: {why}"),
        "`dobot watch` shows what the station waits for",
    )
}

const PATIENCE: Duration = Duration::from_secs(5);
/// A status.
const PAUSE: Duration = Duration::from_millis(80);
