//! Simulation of a plan: a virtual arm draws it under the same rules, as an estimate for a real one.

use std::time::Duration;

use dobot_api::Request;
use dobot_controller::PowerUp;
use dobot_draw::{Estimate, InkLine, Prepared, Sample, Settings, Timeline, Trace};
use dobot_geometry::Stroke;
use dobot_host::{StationClient, personality_of};
use dobot_safety::Policy;
use dobot_sim::{RECORDING_PERIOD, VirtualArm};
use dobot_wire::{Dialect, MoveJoints, MovingMode, Status};
use indicatif::ProgressBar;

use super::execute::execute;
use crate::control::{self, run_command, take_control};
use crate::failure::Failure;
use crate::reach::client_name;

/// The result of a virtual arm.
#[derive(Debug)]
pub(super) struct Carried {
    pub(super) estimate: Estimate,
    pub(super) timeline: Timeline,
    pub(super) ink: Vec<InkLine>,
    /// The deviation of the drawn path from the wanted one.
    pub(super) deviation: dobot_geometry::Deviation,
}

impl Carried {
    /// Evaluates the recording of the arm; `None` if it never reached the start of the plan.
    pub(super) fn of(arm: &VirtualArm, prepared: &Prepared, settings: &Settings) -> Option<Self> {
        let samples: Vec<Sample> = arm.samples().iter().map(sample).collect();
        let wanted = prepared.wanted();
        let trace = Trace::new(&prepared.plan, &settings.paper, &samples, &wanted).ok()?;
        let ink = trace.ink();
        let drawn: Vec<Stroke> = ink.iter().map(|line| line.stroke.clone()).collect();
        Some(Self {
            estimate: trace.estimate(),
            timeline: trace.timeline(),
            deviation: dobot_geometry::deviation(&wanted, &drawn),
            ink,
        })
    }
}

/// The duration of a simulation, the duration by the motion model, and the result.
#[derive(Debug)]
pub(super) struct Rehearsed {
    pub(super) time: Duration,
    pub(super) planned_s: Option<f64>,
    pub(super) carried: Option<Carried>,
}

/// Lets a virtual arm with a dialect draw a plan in virtual time, starting where the real one is.
pub(super) async fn rehearse(
    prepared: &Prepared,
    settings: &Settings,
    dialect: Dialect,
    policy: Policy,
    from: Option<&Status>,
    bar: &ProgressBar,
) -> Result<Rehearsed, Failure> {
    let power_up = PowerUp::new(personality_of(dialect));
    let name = client_name("draw");
    let mut station = StationClient::with_virtual_arm(power_up, policy, &name);
    control::status(&mut station).await?;
    if let Some(from) = from {
        go_to_start(&mut station, from).await?;
    }
    let calibration = settings.calibration.clone().map(Box::new);
    station.request(Request::Calibrate { calibration }).await?;
    if let Some(arm) = station.virtual_arm_mut() {
        arm.record(RECORDING_PERIOD);
    }
    let executed = execute(&mut station, &prepared.plan, "estimate", None, bar).await;
    let arm = station.virtual_arm();
    Ok(Rehearsed {
        time: executed.outcome?,
        planned_s: executed.planned_s,
        carried: arm.and_then(|arm| Carried::of(arm, prepared, settings)),
    })
}

/// Brings the virtual arm to where the real one is.
async fn go_to_start(station: &mut StationClient, from: &Status) -> Result<(), Failure> {
    take_control(station).await?;
    // If the policy forbids that position, the way from there is omitted.
    let _ = run_command(station, standing(from).into()).await;
    Ok(())
}

const fn standing(at: &Status) -> MoveJoints {
    MoveJoints::to([at.base_deg, at.rear_deg, at.fore_deg, at.servo_deg])
        .with_mode(MovingMode::MovJ)
}

fn sample(sample: &dobot_sim::Sample) -> Sample {
    Sample {
        at: sample.at,
        position: sample.position,
        laser: sample.laser,
    }
}
