//! A virtual arm draws a plan: the estimate of what a real one will do is what this one did.

use dobot_client::Connection;
use dobot_draw::{
    Estimate, Finished, InkLine, Plan, Prepared, Progress, Sample, Settings, Stopped, Stroke,
    Timeline, Trace,
};
use dobot_sim::{InProcess, RECORDING_PERIOD};
use dobot_wire::Dialect;

use crate::connect::{speaker, virtual_arm};

/// What a virtual arm did.
#[derive(Debug)]
pub(super) struct Carried {
    pub(super) estimate: Estimate,
    pub(super) timeline: Timeline,
    pub(super) ink: Vec<InkLine>,
    /// The wanted path was not drawn there, where that is worse than what was drawn astray.
    pub(super) deviation: dobot_draw::Deviation,
}

impl Carried {
    /// Reads what the arm recorded; nothing where it never came to the plan's start.
    pub(super) fn of(arm: &InProcess, prepared: &Prepared, settings: &Settings) -> Option<Self> {
        let samples: Vec<Sample> = arm.arm().samples().iter().map(sample).collect();
        let wanted = prepared.wanted();
        let trace = Trace::new(&prepared.plan, &settings.paper, &samples, &wanted).ok()?;
        let ink = trace.ink();
        let drawn: Vec<Stroke> = ink.iter().map(|it| it.stroke.clone()).collect();
        Some(Self {
            estimate: trace.estimate(),
            timeline: trace.timeline(),
            deviation: dobot_draw::deviation(&wanted, &drawn),
            ink,
        })
    }
}

/// Has a virtual arm that speaks this dialect draw the plan, in no time.
pub(super) async fn rehearse(
    prepared: &Prepared,
    settings: &Settings,
    dialect: Dialect,
) -> Result<(Finished, Option<Carried>), Stopped> {
    let arm = InProcess::new(virtual_arm(speaker(dialect)));
    let mut connection = Connection::over_peer(arm.clone(), Some(dialect));
    arm.arm().record(RECORDING_PERIOD);
    let finished = draw(&mut connection, &prepared.plan).await?;
    let carried = Carried::of(&arm, prepared, settings);
    Ok((finished, carried))
}

async fn draw(arm: &mut Connection, plan: &Plan) -> Result<Finished, Stopped> {
    let nobody = std::future::pending();
    dobot_draw::run(arm, plan, async |_: &str| {}, nobody, |_: Progress| {}).await
}

fn sample(it: &dobot_sim::Sample) -> Sample {
    Sample {
        at: it.at,
        position: it.position,
        laser: it.laser,
    }
}
