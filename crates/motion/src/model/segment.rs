//! The interpolation of a trajectory in each of its segments.

use super::motion::Motion;
use super::stretched_move::Stretching;
use crate::{JogAxis, Trajectory};

/// The quantities that are interpolated linearly, all with the same timing unless stated.
///
/// Code that must know every position between two points of a trajectory needs this.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interpolation {
    /// The tool's position and rotation: a straight line in space.
    Line,
    /// The tool's reach, height, base angle and rotation: across in a JUMP.
    Around,
    /// All four joint angles.
    Joints,
    /// All four joint angles, each with timing of its own.
    Stretched(Stretching),
}

/// A part of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The end, in seconds since the start of the command; each segment begins at the end of the
    /// one before.
    pub until_s: f64,
    /// The interpolated quantities.
    pub interpolation: Interpolation,
}

impl Segment {
    const fn new(until_s: f64, interpolation: Interpolation) -> Self {
        Self {
            until_s,
            interpolation,
        }
    }
}

impl Trajectory {
    /// Returns the segments of the whole motion in order. Unused segments end at the end of the
    /// last one, and a jog, which has no end, has segments without duration.
    #[must_use]
    pub fn segments(&self) -> [Segment; 3] {
        let whole = |until_s, interpolation| [Segment::new(until_s, interpolation); 3];
        match &self.motion {
            Motion::Rest | Motion::Jog(_) => whole(0.0, Interpolation::Joints),
            Motion::Joints(movement) => whole(movement.duration_s(), Interpolation::Joints),
            Motion::Stretched(movement) => whole(
                movement.duration_s(),
                Interpolation::Stretched(movement.stretching()),
            ),
            Motion::Stroke { stroke, .. } => whole(stroke.duration_s(), Interpolation::Line),
            Motion::RunDown(jog) => whole(jog.change_s(), interpolation_of(jog.axis())),
            Motion::Lifts(lifts) => lifts.segments(),
            Motion::Jump(jump) => {
                let [up_s, across_s] = jump.corners_s();
                [up_s, across_s, jump.duration_s()]
                    .map(|until_s| Segment::new(until_s, Interpolation::Around))
            }
            Motion::Line(line, _) => turning_at_the_end(line.duration_s()),
        }
    }
}

/// Some arms rotate the tool in one step at the end of the line.
fn turning_at_the_end(duration_s: f64) -> [Segment; 3] {
    let line = Segment::new(duration_s.next_down().max(0.0), Interpolation::Line);
    let turn = Segment::new(duration_s, Interpolation::Joints);
    [line, turn, turn]
}

const fn interpolation_of(axis: JogAxis) -> Interpolation {
    match axis {
        JogAxis::X | JogAxis::Y | JogAxis::Z => Interpolation::Line,
        JogAxis::Base | JogAxis::Rear | JogAxis::Fore | JogAxis::Servo | JogAxis::Gripper => {
            Interpolation::Joints
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
        assert_eq!(
            (line.interpolation, turn.interpolation),
            (Interpolation::Line, Interpolation::Joints)
        );
    }
}
