//! Actions of the arm, over a connection that takes control first and releases it when it is
//! dropped.

use std::time::Duration;

use dobot_api::{JobPhase, JobView, Jog, RemoteError, Reply, Request, State, StationEvent};
use dobot_host::{JobWatch, StationClient, Target, TargetPlace};
use dobot_wire::{Dialect, JointJog, JointJogAxis, MovingMode, Status};
use tokio::sync::watch;
use tokio::time::timeout;

use crate::follow_plan::FollowPlan;
use crate::goal::{Fault, FaultCode, Wanted, rad};
use crate::joints::{JOINTS, degrees_of};
use crate::station::refused;

/// The state of an arm at rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stand {
    pub(crate) status: Status,
    pub(crate) dialect: Dialect,
}

/// Takes control, which is released when the connection is dropped, and waits until the arm is at
/// rest.
pub(crate) async fn take_at_rest(station: &mut StationClient) -> Result<Stand, String> {
    take(station).await?;
    let rest = timeout(PATIENCE, state_at_rest(station)).await;
    rest.unwrap_or_else(|_| Err("the arm is still moving; wait until it is at rest".to_owned()))
}

/// Waits until the arm is at rest, and returns its state.
async fn state_at_rest(station: &mut StationClient) -> Result<Stand, String> {
    let mut dialect = None;
    let rest = station.rest_with_events(|event| {
        if let StationEvent::State(state) = event {
            dialect = state.dialect;
        }
    });
    let arm = rest.await.map_err(|error| match error.hint() {
        Some(hint) => format!("{error}; {hint}"),
        None => error.to_string(),
    })?;
    Ok(Stand {
        status: arm.status,
        dialect: dialect.unwrap_or(Dialect::FIRMWARE_1_1),
    })
}

/// Takes control.
pub(crate) async fn take(station: &mut StationClient) -> Result<(), String> {
    let taken = station.request(Request::TakeLease).await;
    taken.map(drop).map_err(|error| refused(&error))
}

/// Moves to a target, and waits until the arm is at rest there; the arm is stopped if this is
/// interrupted.
pub(crate) async fn go(
    station: &mut StationClient,
    target: &Target,
    ending: &mut watch::Receiver<bool>,
) -> Result<String, String> {
    let command = target.command(&take_at_rest(station).await?.status);
    let request = Request::Command { command };
    let reply = station.request_at_rest(request).await;
    let Reply::Accepted { command, .. } = reply.map_err(|error| refused(&error))? else {
        return Ok("done".to_owned());
    };
    tokio::select! {
        done = station.finished(command) => done.map_err(|error| refused(&error))?,
        () = ended(ending) => {
            stop(station, "the ROS 2 node was shut down").await?;
            return Err("the node was shut down; the arm is stopped".to_owned());
        }
    }
    Ok("the arm has reached the target".to_owned())
}

/// Switches the pump.
pub(crate) async fn suction(station: &mut StationClient, on: bool) -> Result<String, String> {
    let axis = if on {
        JointJogAxis::SuctionOn
    } else {
        JointJogAxis::SuctionOff
    };
    take(station).await?;
    let jog = Jog::Joint(JointJog::new(axis, 0.0));
    let done = station.request(Request::Jog { jog }).await;
    done.map_err(|error| refused(&error))?;
    // The next target uses the pump state of the last status.
    timeout(PATIENCE, shown(station, on))
        .await
        .map_err(|_| "no status confirms that the pump was switched".to_owned())??;
    Ok(format!(
        "the pump is switched {}",
        if on { "on" } else { "off" }
    ))
}

/// Waits until a status confirms the pump state.
async fn shown(station: &mut StationClient, on: bool) -> Result<(), String> {
    loop {
        let state = station.state().await.map_err(|error| refused(&error))?;
        if state.arm.is_some_and(|arm| arm.status.suction == on) {
            return Ok(());
        }
    }
}

/// Turns the gripper to an angle at the current position, -90 (closed) to 90 degrees (open).
pub(crate) async fn gripper(
    station: &mut StationClient,
    angle_deg: f32,
    ending: &mut watch::Receiver<bool>,
) -> Result<String, String> {
    let Stand { status, .. } = take_at_rest(station).await?;
    let target = Target {
        place: TargetPlace::Joints([status.base_deg, status.rear_deg, status.fore_deg]),
        servo_deg: None,
        mode: MovingMode::MovJ,
        suction: None,
        gripper_deg: Some(angle_deg),
        pause_s: 0.0,
    };
    go(station, &target, ending).await?;
    Ok(format!("the gripper is at {angle_deg:.1} degrees"))
}

/// Stops the arm, with or without control, and returns a text with the time until it is at rest.
pub(crate) async fn stop(station: &mut StationClient, reason: &str) -> Result<String, String> {
    let reason = Some(reason.to_owned());
    let reply = station.request(Request::Stop { reason }).await;
    let within_s = match reply.map_err(|error| refused(&error))? {
        Reply::Stopping {
            delivered: false, ..
        } => {
            return Err(
                "the stop was NOT DELIVERED: there is no link to the arm; switch it off by hand"
                    .to_owned(),
            );
        }
        Reply::Stopping { rests_within_s, .. } => rests_within_s,
        _ => 0.0,
    };
    Ok(format!(
        "the arm is at rest within {within_s:.2} s; a person must check it and reset the stop, on the station's page or with `dobot stop --reset`"
    ))
}

/// The outcome of a trajectory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Followed {
    /// The arm has reached its end.
    Done(String),
    /// It was cancelled, and the arm holds where it came to rest.
    Held(String),
}

/// Runs a trajectory as a job, with control; `see` gets each state and the time since the job
/// started, in seconds. On cancellation or shutdown the arm holds.
pub(crate) async fn follow(
    station: &mut StationClient,
    wanted: &Wanted,
    plan: FollowPlan,
    cancelled: &mut watch::Receiver<bool>,
    mut see: impl FnMut(&State, f64),
) -> Result<Followed, Fault> {
    if plan.job.commands.is_empty() {
        return Ok(Followed::Done(format!(
            "the arm is already there; {}",
            plan.summary
        )));
    }
    let no_job = |error: &RemoteError| Fault::invalid(refused(error));
    let job = station
        .submit(plan.job)
        .await
        .map_err(|error| no_job(&error))?;
    let started = station.request_at_rest(Request::StartJob { job }).await;
    if let Err(error) = started {
        station.remove_unstarted(job).await;
        return Err(no_job(&error));
    }
    let mut watch = JobWatch::new(job);
    let mut began_s = None;
    loop {
        let event = tokio::select! {
            event = station.next() => event.map_err(|error| no_job(&error))?,
            () = ended(cancelled) => return hold(station, job, watch).await,
        };
        match event {
            StationEvent::State(state) => {
                let runs = |view: &JobView| view.job == job && view.phase == JobPhase::Running;
                if state.job.as_ref().is_some_and(runs) {
                    see(&state, state.at_s - *began_s.get_or_insert(state.at_s));
                }
            }
            StationEvent::Notice(notice) => match watch.handle_notice(&notice) {
                None => {}
                Some((JobPhase::Done, _)) => {
                    check_end(station, wanted).await?;
                    return Ok(Followed::Done(plan.summary));
                }
                Some((_, text)) => {
                    // A paused job could be resumed later, unexpectedly.
                    station.request(Request::CancelJob { job }).await.ok();
                    return Err(Fault::invalid(format!("the station ended the job: {text}")));
                }
            },
        }
    }
}

/// Ends a job, and waits until the arm holds.
async fn hold(
    station: &mut StationClient,
    job: u64,
    mut watch: JobWatch,
) -> Result<Followed, Fault> {
    let fault = |error: &RemoteError| Fault::invalid(refused(error));
    let cancelled = station.request(Request::CancelJob { job }).await;
    cancelled.map_err(|error| fault(&error))?;
    let rest = async {
        loop {
            if let StationEvent::Notice(notice) = station.next().await?
                && let Some((_, text)) = watch.handle_notice(&notice)
            {
                return Ok::<_, RemoteError>(text);
            }
        }
    };
    match timeout(PATIENCE, rest).await {
        Ok(Ok(text)) => Ok(Followed::Held(text)),
        Ok(Err(error)) => Err(fault(&error)),
        Err(_) => Err(Fault::invalid(
            "the arm was commanded to hold, but is not at rest",
        )),
    }
}

/// Checks the joints against the goal tolerance.
async fn check_end(station: &mut StationClient, wanted: &Wanted) -> Result<(), Fault> {
    if wanted.end_deg == [None; 4] {
        return Ok(());
    }
    let Stand { status, .. } = state_at_rest(station).await.map_err(Fault::invalid)?;
    let (found, end) = (degrees_of(&status), wanted.at(f64::INFINITY));
    for joint in 0..4 {
        let off = (found[joint] - end[joint]).abs();
        if let Some(allowed) = wanted.end_deg[joint].filter(|end_deg| off > *end_deg) {
            let (name, off, allowed) = (JOINTS[joint], rad(off), rad(allowed));
            return Err(Fault::new(
                FaultCode::GoalToleranceViolated,
                format!("{name} is {off} rad off; goal_tolerance allows {allowed} rad"),
            ));
        }
    }
    Ok(())
}

/// Waits for the shutdown.
pub(crate) async fn ended(ending: &mut watch::Receiver<bool>) {
    if ending.wait_for(|allowed| *allowed).await.is_err() {
        // The sender is gone: there will be no shutdown.
        std::future::pending::<()>().await;
    }
}

/// The range of the gripper in each direction.
pub(crate) const GRIPPER_DEG: f32 = 90.0;
/// The maximum time until an arm is at rest.
const PATIENCE: Duration = Duration::from_secs(10);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
