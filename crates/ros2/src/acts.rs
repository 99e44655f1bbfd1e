//! What the arm is had to do, over a connection that takes control first and gives it back when it is dropped.

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

/// How an arm rests, and how often it says so.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stand {
    pub(crate) status: Status,
    /// The time from status to status.
    pub(crate) period: Duration,
}

/// Takes control, which is given back when the connection is dropped, and waits until the arm rests.
pub(crate) async fn take_at_rest(station: &mut StationClient) -> Result<Stand, String> {
    take(station).await?;
    let rest = timeout(PATIENCE, stands(station)).await;
    rest.unwrap_or_else(|_| Err("the arm still moves; wait until it rests".to_owned()))
}

/// How the arm stands, as soon as it does.
async fn stands(station: &mut StationClient) -> Result<Stand, String> {
    loop {
        let state = station.first_state().await.map_err(|it| match it.hint() {
            Some(hint) => format!("{it}; {hint}"),
            None => it.to_string(),
        })?;
        if let Some(arm) = state.arm.filter(|it| !it.moving) {
            let dialect = state.dialect.unwrap_or(Dialect::FIRMWARE_1_1);
            return Ok(Stand {
                status: arm.status,
                period: dialect.status_period(),
            });
        }
    }
}

/// Takes control.
pub(crate) async fn take(station: &mut StationClient) -> Result<(), String> {
    let taken = station.request(Request::TakeLease).await;
    taken.map(drop).map_err(|it| refused(&it))
}

/// Goes to a target, and waits until the arm rests there; the arm is stopped where this comes to an end first.
pub(crate) async fn go(
    station: &mut StationClient,
    target: &Target,
    ending: &mut watch::Receiver<bool>,
) -> Result<String, String> {
    let command = target.command(&take_at_rest(station).await?.status);
    let request = Request::Command { command };
    let reply = station.request_at_rest(request).await;
    let Reply::Accepted { command, .. } = reply.map_err(|it| refused(&it))? else {
        return Ok("done".to_owned());
    };
    tokio::select! {
        done = station.finished(command) => done.map_err(|it| refused(&it))?,
        () = ended(ending) => {
            stop(station, "the program for ROS 2 was ended").await?;
            return Err("this was ended first; the arm is stopped".to_owned());
        }
    }
    Ok("the arm is there".to_owned())
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
    done.map_err(|it| refused(&it))?;
    // The next target sets the pump as it is then.
    timeout(PATIENCE, shown(station, on))
        .await
        .map_err(|_| "no status shows that the pump was switched".to_owned())??;
    Ok(format!(
        "the pump is switched {}",
        if on { "on" } else { "off" }
    ))
}

/// Until a status shows the pump so.
async fn shown(station: &mut StationClient, on: bool) -> Result<(), String> {
    loop {
        let state = station.state().await.map_err(|it| refused(&it))?;
        if state.arm.is_some_and(|it| it.status.suction == on) {
            return Ok(());
        }
    }
}

/// Closes or opens the gripper, where the arm stands.
pub(crate) async fn gripper(
    station: &mut StationClient,
    closed: bool,
    ending: &mut watch::Receiver<bool>,
) -> Result<String, String> {
    let Stand { status, .. } = take_at_rest(station).await?;
    let target = Target {
        place: TargetPlace::Joints([status.base_deg, status.rear_deg, status.fore_deg]),
        servo_deg: None,
        mode: MovingMode::MovJ,
        suction: None,
        gripper_deg: Some(if closed { -GRIPPER_DEG } else { GRIPPER_DEG }),
        pause_s: 0.0,
    };
    go(station, &target, ending).await?;
    Ok(format!(
        "the gripper is {}",
        if closed { "closed" } else { "open" }
    ))
}

/// Stops the arm, whoever has control, and tells by when it rests.
pub(crate) async fn stop(station: &mut StationClient, reason: &str) -> Result<String, String> {
    let reason = Some(reason.to_owned());
    let reply = station.request(Request::Stop { reason }).await;
    let within_s = match reply.map_err(|it| refused(&it))? {
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
        "the arm rests within {within_s:.2} s; a person looks at it and resets the stop: on the station's page, or with `dobot stop --reset`"
    ))
}

/// How a trajectory ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Followed {
    /// The arm is at its end.
    Done(String),
    /// It was cancelled, and the arm holds where it came to rest.
    Held(String),
}

/// Follows a trajectory as a job, with control; `see` is shown every state, and how long the job has run in seconds. Where it is
/// cancelled or this is ended, the arm holds.
pub(crate) async fn follow(
    station: &mut StationClient,
    wanted: &Wanted,
    plan: FollowPlan,
    cancelled: &mut watch::Receiver<bool>,
    mut see: impl FnMut(&State, f64),
) -> Result<Followed, Fault> {
    if plan.job.commands.is_empty() {
        return Ok(Followed::Done(format!(
            "the arm stands there; {}",
            plan.told
        )));
    }
    let no_job = |it: &RemoteError| Fault::invalid(refused(it));
    let job = station.submit(plan.job).await.map_err(|it| no_job(&it))?;
    let started = station.request_at_rest(Request::StartJob { job }).await;
    if let Err(error) = started {
        station.remove_unstarted(job).await;
        return Err(no_job(&error));
    }
    let mut watch = JobWatch::new(job);
    let mut began_s = None;
    loop {
        let event = tokio::select! {
            event = station.next() => event.map_err(|it| no_job(&it))?,
            () = ended(cancelled) => return hold(station, job, watch).await,
        };
        match event {
            StationEvent::State(state) => {
                let runs = |it: &JobView| it.job == job && it.phase == JobPhase::Running;
                if state.job.as_ref().is_some_and(runs) {
                    see(&state, state.at_s - *began_s.get_or_insert(state.at_s));
                }
            }
            StationEvent::Notice(notice) => match watch.handle_notice(&notice) {
                None => {}
                Some((JobPhase::Done, _)) => {
                    check_end(station, wanted).await?;
                    return Ok(Followed::Done(plan.told));
                }
                Some((_, text)) => {
                    // One that is paused would go on later, when nobody expects it.
                    station.request(Request::CancelJob { job }).await.ok();
                    return Err(Fault::invalid(format!("the station ended it: {text}")));
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
    let fault = |it: &RemoteError| Fault::invalid(refused(it));
    let cancelled = station.request(Request::CancelJob { job }).await;
    cancelled.map_err(|it| fault(&it))?;
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
            "the arm was told to hold, and does not rest",
        )),
    }
}

/// Whether the joints are as near to the end as the goal wants them.
async fn check_end(station: &mut StationClient, wanted: &Wanted) -> Result<(), Fault> {
    if wanted.end_deg == [None; 4] {
        return Ok(());
    }
    let Stand { status, .. } = stands(station).await.map_err(Fault::invalid)?;
    let (found, end) = (degrees_of(&status), wanted.at(f64::INFINITY));
    for joint in 0..4 {
        let off = (found[joint] - end[joint]).abs();
        if let Some(allowed) = wanted.end_deg[joint].filter(|it| off > *it) {
            let (name, off, allowed) = (JOINTS[joint], rad(off), rad(allowed));
            return Err(Fault::new(
                FaultCode::GoalToleranceViolated,
                format!("{name} is {off} rad off; goal_tolerance allows {allowed} rad"),
            ));
        }
    }
    Ok(())
}

/// Until somebody wants it to end.
pub(crate) async fn ended(ending: &mut watch::Receiver<bool>) {
    if ending.wait_for(|it| *it).await.is_err() {
        // Nobody is left who could want it.
        std::future::pending::<()>().await;
    }
}

/// How far the gripper turns, either way.
const GRIPPER_DEG: f32 = 90.0;
/// How long an arm takes to come to rest, at the most.
const PATIENCE: Duration = Duration::from_secs(10);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
