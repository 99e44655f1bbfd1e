//! A virtual arm draws a plan: the estimate of what a real one will do is what this one did, under
//! the same rules.

use std::time::Duration;

use dobot_api::Request;
use dobot_controller::PowerUp;
use dobot_draw::{Estimate, InkLine, Prepared, Sample, Settings, Timeline, Trace};
use dobot_geometry::Stroke;
use dobot_host::StationClient;
use dobot_safety::Policy;
use dobot_sim::{RECORDING_PERIOD, VirtualArm};
use dobot_wire::{Dialect, MoveJoints, MovingMode, Status};
use indicatif::ProgressBar;

use super::execute::execute;
use crate::connect::personality_of;
use crate::control::{self, carry_out, take_control};
use crate::failure::Failure;
use crate::reach::client_name;

/// What a virtual arm did.
#[derive(Debug)]
pub(super) struct Carried {
    pub(super) estimate: Estimate,
    pub(super) timeline: Timeline,
    pub(super) ink: Vec<InkLine>,
    /// The wanted path was not drawn there, where that is worse than what was drawn astray.
    pub(super) deviation: dobot_geometry::Deviation,
}

impl Carried {
    /// Reads what the arm recorded; nothing where it never came to the plan's start.
    pub(super) fn of(arm: &VirtualArm, prepared: &Prepared, settings: &Settings) -> Option<Self> {
        let samples: Vec<Sample> = arm.samples().iter().map(sample).collect();
        let wanted = prepared.wanted();
        let trace = Trace::new(&prepared.plan, &settings.paper, &samples, &wanted).ok()?;
        let ink = trace.ink();
        let drawn: Vec<Stroke> = ink.iter().map(|it| it.stroke.clone()).collect();
        Some(Self {
            estimate: trace.estimate(),
            timeline: trace.timeline(),
            deviation: dobot_geometry::deviation(&wanted, &drawn),
            ink,
        })
    }
}

/// How long a virtual arm took, how long that was to take by the motion model, and what it did.
#[derive(Debug)]
pub(super) struct Rehearsed {
    pub(super) time: Duration,
    pub(super) planned_s: Option<f64>,
    pub(super) carried: Option<Carried>,
}

/// Has a virtual arm that speaks this dialect draw the plan, in no time, from where the real one
/// stands.
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
        take_control(&mut station).await?;
        // Where the policy does not let it stand there, the way from there is left out.
        let _ = carry_out(&mut station, standing(from).into()).await;
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
        carried: arm.and_then(|it| Carried::of(it, prepared, settings)),
    })
}

const fn standing(at: &Status) -> MoveJoints {
    MoveJoints::to([at.base_deg, at.rear_deg, at.fore_deg, at.servo_deg])
        .with_mode(MovingMode::MovJ)
}

fn sample(it: &dobot_sim::Sample) -> Sample {
    Sample {
        at: it.at,
        position: it.position,
        laser: it.laser,
    }
}
