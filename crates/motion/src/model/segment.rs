//! How a trajectory runs: what changes evenly on which part of it.

use super::motion::Motion;
use crate::{JogAxis, Trajectory};

/// What changes evenly with the share of the way: all of it at one pace, whatever the pace is.
///
/// Whoever has to be sure of what lies between two places of a trajectory needs this.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bend {
    /// The tool's position and rotation: a straight line in space.
    Line,
    /// The tool's reach, height, base angle and rotation: across in a JUMP.
    Around,
    /// All four joint angles.
    Joints,
}

/// A part of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// When it ends, in seconds since the command began; it begins where the one before ends.
    pub until_s: f64,
    /// What changes evenly on it.
    pub bend: Bend,
}

impl Trajectory {
    /// The segments of the whole motion in their order. Those behind the last end where it ends,
    /// and a jog, which has no end, has none that lasts.
    #[must_use]
    pub fn segments(&self) -> [Segment; 3] {
        let whole = |until_s, bend| [Segment { until_s, bend }; 3];
        match &self.motion {
            Motion::Still | Motion::Jog(_) => whole(0.0, Bend::Joints),
            Motion::Joints(it) => whole(it.duration_s(), Bend::Joints),
            Motion::Stroke { stroke, .. } => whole(stroke.duration_s(), Bend::Line),
            Motion::RunDown(it) => whole(it.change_s(), bend_of(it.axis())),
            Motion::Lifts(it) => it.ends_s().map(|until_s| Segment {
                until_s,
                bend: Bend::Joints,
            }),
            Motion::Jump(it) => {
                let [up_s, across_s] = it.corners_s();
                [up_s, across_s, it.duration_s()].map(|until_s| Segment {
                    until_s,
                    bend: Bend::Around,
                })
            }
            Motion::Line(it, _) => turning_at_the_end(it.duration_s()),
        }
    }
}

/// Some arms turn the tool in one step when the line is over.
fn turning_at_the_end(duration_s: f64) -> [Segment; 3] {
    let line = Segment {
        until_s: duration_s.next_down().max(0.0),
        bend: Bend::Line,
    };
    let turn = Segment {
        until_s: duration_s,
        bend: Bend::Joints,
    };
    [line, turn, turn]
}

const fn bend_of(axis: JogAxis) -> Bend {
    match axis {
        JogAxis::X | JogAxis::Y | JogAxis::Z => Bend::Line,
        JogAxis::Base | JogAxis::Rear | JogAxis::Fore | JogAxis::Servo | JogAxis::Gripper => {
            Bend::Joints
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use dobot_arm::{Joints, Tool};
    use dobot_wire::{Command, Dialect, MoveTo, MovingMode};

    use super::*;
    use crate::{ArmPlace, Model};

    fn trajectory(dialect: Dialect, mode: MovingMode) -> Trajectory {
        let here = ArmPlace::at_joints(Joints::new(-20.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let target = Command::from(MoveTo {
            rotation_deg: 40.0,
            mode,
            ..MoveTo::to(200.0, 80.0, 0.0)
        });
        Model::standing(dialect, here).trajectory(&target).unwrap()
    }

    #[test]
    fn the_last_segment_ends_where_the_motion_does() {
        for dialect in Dialect::ALL {
            for mode in [MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ] {
                let trajectory = trajectory(dialect, mode);
                let [_, _, last] = trajectory.segments();
                assert_eq!(Some(last.until_s), trajectory.motion_s());
            }
        }
    }

    #[test]
    fn a_jump_is_highest_above_both_of_its_ends_where_its_corners_are() {
        for dialect in Dialect::ALL {
            let trajectory = trajectory(dialect, MovingMode::Jump);
            let z_mm = |t_s| trajectory.place_at(t_s).unwrap().pose.position.z.0;
            let [up, across, down] = trajectory.segments();
            let height_mm = f64::from(dialect.default_jump_height_mm);
            let tops = if dialect.jumps_by_joints {
                [z_mm(0.0) + height_mm, height_mm]
            } else {
                [height_mm; 2]
            };
            for (segment, top_mm) in [up, across].into_iter().zip(tops) {
                let found = z_mm(segment.until_s);
                assert!(
                    (found - top_mm).abs() < 1e-5,
                    "found {found}, expected {top_mm}, tolerance 1e-5"
                );
            }
            assert!(up.until_s < across.until_s && across.until_s < down.until_s);
        }
    }

    #[test]
    fn a_tool_that_turns_when_the_line_is_over_does_so_on_a_segment_of_its_own() {
        let trajectory = trajectory(Dialect::FIRMWARE_1_1, MovingMode::MovL);
        let [line, turn, _] = trajectory.segments();
        let rotation_deg = |t_s| trajectory.place_at(t_s).unwrap().pose.rotation.0;
        assert_eq!(rotation_deg(line.until_s), -20.0);
        assert_eq!(rotation_deg(turn.until_s), 40.0);
        assert_eq!((line.bend, turn.bend), (Bend::Line, Bend::Joints));
    }
}
