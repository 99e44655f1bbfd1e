//! The ways to move.

use crate::{ArmPlace, JogTrajectory, JointMove, Jump, LineMove, Stroke};
use dobot_arm::{Degrees, Millimeters, Pose, Tool, Unreachable};

use super::lifts::Lifts;

/// How an arm gets somewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion {
    /// Not at all.
    Still,
    Joints(JointMove),
    /// A line, and the rotation that the tool has at its end.
    Line(LineMove, Degrees),
    Jump(Jump),
    Lifts(Lifts),
    /// A stroke with the rotation kept, and with the height if that is held.
    Stroke {
        stroke: Stroke,
        rotation: Degrees,
        held_z: Option<Millimeters>,
    },
    /// Until told otherwise.
    Jog(JogTrajectory),
    /// The end of a jog.
    RunDown(JogTrajectory),
}

impl Motion {
    /// Where the arm is after a time, if it moves.
    pub(crate) fn place_at(&self, t_s: f64, tool: Tool) -> Option<Result<ArmPlace, Unreachable>> {
        Some(match self {
            Self::Still => return None,
            Self::Joints(it) => Ok(ArmPlace::at_joints(it.joints_at(t_s), tool)),
            Self::Lifts(it) => Ok(ArmPlace::at_joints(it.joints_at(t_s), tool)),
            Self::Line(it, turned) => {
                let mut pose = it.pose_at(t_s);
                if t_s >= it.duration_s() {
                    pose.rotation = *turned;
                }
                ArmPlace::at_pose(pose, tool)
            }
            Self::Jump(it) => ArmPlace::at_pose(it.pose_at(t_s), tool),
            Self::Stroke {
                stroke,
                rotation,
                held_z,
            } => {
                let mut position = stroke.position_at(t_s);
                position.z = held_z.unwrap_or(position.z);
                let pose = Pose {
                    position,
                    rotation: *rotation,
                };
                ArmPlace::at_pose(pose, tool)
            }
            Self::Jog(it) | Self::RunDown(it) => it.place_at(t_s),
        })
    }

    /// How long it takes, in seconds; `None` for one that goes on until told otherwise.
    pub(crate) const fn duration_s(&self) -> Option<f64> {
        match self {
            Self::Still => Some(0.0),
            Self::Joints(it) => Some(it.duration_s()),
            Self::Line(it, _) => Some(it.duration_s()),
            Self::Jump(it) => Some(it.duration_s()),
            Self::Lifts(it) => Some(it.duration_s()),
            Self::Stroke { stroke, .. } => Some(stroke.duration_s()),
            Self::Jog(_) => None,
            Self::RunDown(it) => Some(it.change_s()),
        }
    }
}
