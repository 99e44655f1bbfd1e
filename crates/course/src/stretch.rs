//! How a course runs: what changes evenly on which part of it.

use crate::way::Way;
use crate::{Course, JogAxis};

/// What changes evenly with the share of the way: all of it at one pace, whatever the pace is.
///
/// Whoever has to be sure of what lies between two places of a course needs this.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bend {
    /// The tool's position and rotation: a straight line in space.
    Line,
    /// The tool's reach, height, base angle and rotation: across in a JUMP.
    Around,
    /// All four joint angles.
    Joints,
}

/// A part of a course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// When it ends, in seconds since the command began; it begins where the one before ends.
    pub until_s: f64,
    /// What changes evenly on it.
    pub bend: Bend,
}

impl Course {
    /// The stretches of the whole motion in their order. Those behind the last end where it ends,
    /// and a jog, which has no end, has none that lasts.
    #[must_use]
    pub fn stretches(&self) -> [Stretch; 3] {
        let whole = |until_s, bend| [Stretch { until_s, bend }; 3];
        match &self.way {
            Way::Still | Way::Jog(_) => whole(0.0, Bend::Joints),
            Way::Joints(it) => whole(it.duration_s(), Bend::Joints),
            Way::Stroke { stroke, .. } => whole(stroke.duration_s(), Bend::Line),
            Way::RunDown(it) => whole(it.change_s(), bend_of(it.axis())),
            Way::Lifts(it) => it.ends_s().map(|until_s| Stretch {
                until_s,
                bend: Bend::Joints,
            }),
            Way::Jump(it) => {
                let [up_s, across_s] = it.corners_s();
                [up_s, across_s, it.duration_s()].map(|until_s| Stretch {
                    until_s,
                    bend: Bend::Around,
                })
            }
            Way::Line(it, _) => turning_at_the_end(it.duration_s()),
        }
    }
}

/// Some arms turn the tool in one step when the line is over.
fn turning_at_the_end(duration_s: f64) -> [Stretch; 3] {
    let line = Stretch {
        until_s: duration_s.next_down().max(0.0),
        bend: Bend::Line,
    };
    let turn = Stretch {
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
