//! A virtual arm on the bench, and something to draw.

use dobot_client::Connection;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_draw::{
    Finished, Laser, Machine, Paper, Pass, Pen, Plan, Point, Progress, Sample, Stopped, Stroke,
    Tool, run,
};
use dobot_sim::{InProcess, Line, RECORDING_PERIOD, VirtualArm};

pub(crate) struct Bench {
    pub(crate) arm: Connection,
    twin: InProcess,
    /// What a person was asked.
    pub(crate) asked: Vec<String>,
    pub(crate) told: Vec<Progress>,
}

impl Bench {
    pub(crate) fn new(personality: Personality) -> Self {
        let controller = Controller::power_up(PowerUp::new(personality));
        let twin = InProcess::new(VirtualArm::new(controller, Line::STOCK));
        twin.arm().record(RECORDING_PERIOD);
        Self {
            arm: Connection::over_peer(twin.clone(), Some(personality.dialect())),
            twin,
            asked: Vec::new(),
            told: Vec::new(),
        }
    }

    pub(crate) async fn draw(&mut self, plan: &Plan) -> Result<Finished, Stopped> {
        self.draw_until(plan, usize::MAX).await
    }

    /// Somebody stops the drawing when so many vectors are over.
    pub(crate) async fn draw_until(
        &mut self,
        plan: &Plan,
        vectors: usize,
    ) -> Result<Finished, Stopped> {
        let enough = tokio::sync::Notify::new();
        let (asked, told) = (&mut self.asked, &mut self.told);
        let confirm = async |message: &str| asked.push(message.to_owned());
        let tell = |progress: Progress| {
            told.push(progress);
            if progress.vectors >= vectors {
                enough.notify_one();
            }
        };
        run(&mut self.arm, plan, confirm, enough.notified(), tell).await
    }

    pub(crate) fn samples(&self) -> Vec<Sample> {
        let arm = self.twin.arm();
        let sample = |it: &dobot_sim::Sample| Sample {
            at: it.at,
            position: it.position,
            laser: it.laser,
        };
        arm.samples().iter().map(sample).collect()
    }
}

pub(crate) const PAPER: Paper = Paper::level(-40.0);

pub(crate) fn line(points: &[(f64, f64)]) -> Stroke {
    Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
}

pub(crate) fn square(x: f64, y: f64, side: f64) -> Stroke {
    let corners = [
        (0.0, 0.0),
        (side, 0.0),
        (side, side),
        (0.0, side),
        (0.0, 0.0),
    ];
    line(&corners.map(|(dx, dy)| (x + dx, y + dy)))
}

pub(crate) fn pen(name: &str, strokes: Vec<Stroke>) -> Pass {
    Pass {
        name: name.to_owned(),
        ..Pass::new(Tool::Pen(Pen::default()), strokes)
    }
}

pub(crate) fn laser(strokes: Vec<Stroke>, times: u32) -> Pass {
    let laser = Laser {
        times,
        ..Laser::default()
    };
    Pass::new(Tool::Laser(laser), strokes)
}

pub(crate) fn plan(passes: &[Pass], personality: Personality) -> Plan {
    let machine = Machine::of(personality.dialect());
    Plan::new(passes, &PAPER, &machine).unwrap()
}
