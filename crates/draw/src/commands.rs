//! A plan in the words of the protocol.

use dobot_wire::{
    Command, Configuration, EndEffector, JointJog, JointJogAxis, MoveTo, MovingMode, WriteMode,
    WriteVector,
};

use crate::plan::{Plan, PlannedVector};

impl Plan {
    /// All that the arm is told for this drawing, in order: laser off, a tool like a pen, the
    /// acceleration, to the start, and the vectors.
    pub fn commands(&self) -> impl Iterator<Item = Command> {
        approach(self)
            .into_iter()
            .chain([to_start(self).into()])
            .chain(self.moves.iter().map(|vector| write(vector).into()))
    }
}

/// What has to be told before the arm goes to the start.
pub(crate) fn approach(plan: &Plan) -> [Command; 3] {
    let pen = Configuration::EndEffector {
        tool: EndEffector::SuctionCup,
    };
    let acceleration = Configuration::Writing {
        acceleration_mm_s2: single(plan.acceleration_mm_s2()),
    };
    [LASER_OFF.into(), pen.into(), acceleration.into()]
}

/// To where the first vector begins.
pub(crate) fn to_start(plan: &Plan) -> MoveTo {
    let [x_mm, y_mm, z_mm] = plan.start.map(single);
    MoveTo {
        x_mm,
        y_mm,
        z_mm,
        rotation_deg: y_mm.atan2(x_mm).to_degrees(),
        suction: false,
        mode: MovingMode::Jump,
        gripper_deg: 0.0,
        pause_s: 0.0,
    }
}

/// The packet's contents for a planned vector (state 4; Table 2.6).
pub(crate) const fn write(vector: &PlannedVector) -> WriteVector {
    WriteVector {
        mode: WriteMode::Writing,
        x_mm: vector.x_mm,
        y_mm: vector.y_mm,
        z_mm: vector.z_mm,
        laser: false,
        start_speed_mm_s: vector.start_speed_mm_s,
        end_speed_mm_s: vector.end_speed_mm_s,
        max_speed_mm_s: vector.max_speed_mm_s,
        stop: false,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
pub(crate) const fn single(value: f64) -> f32 {
    value as f32
}

pub(crate) const LASER_OFF: JointJog = JointJog {
    axis: JointJogAxis::LaserOff,
    speed_percent: 0.0,
};

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::{LinkRate, Pen, Point, Stroke};

    #[test]
    fn a_drawing_begins_with_the_laser_off_and_goes_to_its_start_before_it_draws() {
        let stroke = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(210.0, 0.0)]);
        let plan = Plan::new(&[stroke], &Pen::default(), LinkRate { period_s: 0.0 }).unwrap();
        let commands: Vec<_> = plan.commands().collect();
        assert_eq!(commands[0], LASER_OFF.into());
        let moves = |it: &Command| matches!(it, Command::MoveTo(_) | Command::WriteVector(_));
        let first = commands.iter().find(|it| moves(it)).unwrap();
        match first {
            Command::MoveTo(to) => assert_eq!((to.x_mm, to.y_mm), (200.0, 0.0)),
            other => panic!("{other:?}"),
        }
        assert_eq!(commands.len(), 4 + plan.moves.len());
    }
}
