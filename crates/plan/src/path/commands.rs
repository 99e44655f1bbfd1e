//! The commands of a plan.

use dobot_arm::Limits;
use dobot_wire::{
    Command, Configuration, JointJog, JointJogAxis, MoveTo, WriteMode, WriteVector, single,
};

use crate::{MoveKind, Plan, PlannedVector};

impl Plan {
    /// Returns all commands of the drawing in order: laser off, tool, acceleration, move to the
    /// start, and the vectors; for a laser, laser off again at the end.
    pub fn commands(&self) -> impl Iterator<Item = Command> {
        approach(self)
            .into_iter()
            .chain([to_start(self).into()])
            .chain(self.moves.iter().map(|vector| write(vector).into()))
            .chain(self.burns().then(|| LASER_OFF.into()))
    }

    /// Returns the breaks: the index in [`commands`](Self::commands) of the command that must wait,
    /// and the message to the person.
    pub fn breaks_in_commands(&self) -> impl Iterator<Item = (usize, &str)> {
        let breaks = self.breaks.iter();
        breaks.map(|pause| (self.command_of(pause.before), pause.message.as_str()))
    }

    /// Returns the index in [`commands`](Self::commands) of a vector.
    #[must_use]
    pub const fn command_of(&self, vector: usize) -> usize {
        APPROACH_LEN + 1 + vector
    }
}

/// Returns the commands before the move to the start.
pub(crate) fn approach(plan: &Plan) -> [Command; APPROACH_LEN] {
    let tool = Configuration::EndEffector {
        tool: plan.passes[0].tool.tool().into(),
    };
    let acceleration = Configuration::Writing {
        acceleration_mm_s2: single(plan.arm_limits().acceleration_mm_s2),
    };
    [LASER_OFF.into(), tool.into(), acceleration.into()]
}

/// Returns the move to the start of the first vector. The tool keeps its rotation on all vectors,
/// so the servo turns against the base: it starts at its centre, unless that brings it too close to
/// a limit somewhere.
pub(crate) fn to_start(plan: &Plan) -> MoveTo {
    let [x_mm, y_mm, z_mm] = plan.start.map(single);
    let begin_deg = y_mm.atan2(x_mm).to_degrees();
    let [least_deg, most_deg] = base_span_deg(plan);
    let turns_deg = (most_deg - begin_deg).max(begin_deg - least_deg);
    let is_far = f64::from(turns_deg) > SERVO_DEG;
    MoveTo {
        rotation_deg: if is_far {
            0.5 * (least_deg + most_deg)
        } else {
            begin_deg
        },
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
}

/// Returns the range of the base angle, in degrees; no path leads behind the base.
fn base_span_deg(plan: &Plan) -> [f32; 2] {
    let places = std::iter::once(plan.start).chain(plan.positions());
    let bases_deg = places.map(|[x, y, _]| single(y.atan2(x).to_degrees()));
    bases_deg.fold([f32::INFINITY, f32::NEG_INFINITY], |[least, most], deg| {
        [least.min(deg), most.max(deg)]
    })
}

/// Returns the packet of a planned vector (state 4; Table 2.6).
///
/// A stock arm switches the laser only in laser mode and otherwise leaves it unchanged (note N48).
/// Therefore the vector after a stroke is also in laser mode, with the laser off. All others are in
/// writing mode, because laser mode with the laser off accelerates a hundredfold.
pub(crate) const fn write(vector: &PlannedVector) -> WriteVector {
    let mode = match vector.kind {
        MoveKind::Burn | MoveKind::RunOut => WriteMode::Laser,
        _ => WriteMode::Writing,
    };
    WriteVector {
        mode,
        x_mm: vector.x_mm,
        y_mm: vector.y_mm,
        z_mm: vector.z_mm,
        laser: matches!(vector.kind, MoveKind::Burn),
        start_speed_mm_s: vector.start_speed_mm_s,
        end_speed_mm_s: vector.end_speed_mm_s,
        max_speed_mm_s: vector.max_speed_mm_s,
        stop: false,
    }
}

pub(crate) const LASER_OFF: JointJog = JointJog::new(JointJogAxis::LaserOff, 0.0);

const APPROACH_LEN: usize = 3;
/// The range of the servo to both sides of its centre, less a margin for rounding.
const SERVO_DEG: f64 = Limits::STOCK.servo.max.0 - 1.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::{ArmLimits, DrawingTool, Paper, Pass};
    use dobot_geometry::{Point, Stroke};

    #[test]
    fn a_drawing_begins_with_the_laser_off_and_goes_to_its_start_before_it_draws() {
        let stroke = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(210.0, 0.0)]);
        let pass = Pass::new(DrawingTool::default(), vec![stroke]);
        let plan = Plan::new(&[pass], &Paper::default(), &ArmLimits::default()).unwrap();
        let commands: Vec<_> = plan.commands().collect();
        assert_eq!(commands[0], LASER_OFF.into());
        let moves =
            |command: &Command| matches!(command, Command::MoveTo(_) | Command::WriteVector(_));
        let first = commands.iter().find(|command| moves(command)).unwrap();
        match first {
            Command::MoveTo(to) => assert_eq!((to.x_mm, to.y_mm), (200.0, 0.0)),
            other => panic!("{other:?}"),
        }
        assert_eq!(commands.len(), 4 + plan.moves.len());
    }

    #[test]
    fn a_drawing_around_half_the_base_begins_with_the_servo_turned() {
        // Dots 220 mm from the axis, at these base angles.
        let rotation_deg = |bases_deg: &[f64]| {
            let dot = |deg: &f64| {
                let (sin, cos) = deg.to_radians().sin_cos();
                Stroke::open(vec![Point::new(220.0 * cos, 220.0 * sin)])
            };
            let strokes = bases_deg.iter().map(dot).collect();
            let pass = Pass::new(DrawingTool::default(), strokes);
            let plan = Plan::new(&[pass], &Paper::default(), &ArmLimits::default()).unwrap();
            to_start(&plan).rotation_deg
        };
        // The servo turns from 65 to -65 degrees instead of from 0 to -130.
        assert!((rotation_deg(&[-60.0, 0.0, 70.0]) - 5.0).abs() < 0.01);
        assert!((rotation_deg(&[20.0, -60.0, 70.0]) - 20.0).abs() < 0.01);
    }
}
