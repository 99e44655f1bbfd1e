//! The kinds of motion.

use crate::{ArmPlace, JogTrajectory, JointMove, Jump, LineMove, Stroke};
use dobot_arm::{Degrees, Millimeters, Pose, Position, Tool, Unreachable};

use super::lifts::Lifts;
use super::stretched_move::StretchedMove;

/// The motion of an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion {
    /// No motion.
    Rest,
    Joints(JointMove),
    /// Joints of a stock arm, each with its own ramps.
    Stretched(StretchedMove),
    /// A line, and the rotation of the tool at its end.
    Line(LineMove, Degrees),
    Jump(Jump),
    Lifts(Lifts),
    /// A stroke with constant rotation and, if held, constant height.
    Stroke {
        stroke: Stroke,
        rotation: Degrees,
        held_z: Option<Millimeters>,
    },
    /// A jog until its release.
    Jog(JogTrajectory),
    /// The end of a jog.
    RunDown(JogTrajectory),
}

impl Motion {
    /// Returns the position at a time, if the arm moves.
    pub(crate) fn place_at(&self, t_s: f64, tool: Tool) -> Option<Result<ArmPlace, Unreachable>> {
        Some(match self {
            Self::Rest => return None,
            Self::Joints(movement) => Ok(ArmPlace::at_joints(movement.joints_at(t_s), tool)),
            Self::Stretched(movement) => Ok(ArmPlace::at_joints(movement.joints_at(t_s), tool)),
            Self::Lifts(lifts) => Ok(ArmPlace::at_joints(lifts.joints_at(t_s), tool)),
            Self::Line(line, turned) => {
                let mut pose = line.pose_at(t_s);
                if t_s >= line.duration_s() {
                    pose.rotation = *turned;
                }
                ArmPlace::at_pose(pose, tool)
            }
            Self::Jump(jump) => ArmPlace::at_pose(jump.pose_at(t_s), tool),
            Self::Stroke {
                stroke,
                rotation,
                held_z,
            } => {
                let mut position = stroke.position_at(t_s);
                position.z = held_z.unwrap_or(position.z);
                ArmPlace::at_pose(turned(position, *rotation), tool)
            }
            Self::Jog(jog) | Self::RunDown(jog) => jog.place_at(t_s),
        })
    }

    /// Returns the duration, in seconds; `None` for a jog.
    pub(crate) const fn duration_s(&self) -> Option<f64> {
        match self {
            Self::Rest => Some(0.0),
            Self::Joints(movement) => Some(movement.duration_s()),
            Self::Stretched(movement) => Some(movement.duration_s()),
            Self::Line(line, _) => Some(line.duration_s()),
            Self::Jump(jump) => Some(jump.duration_s()),
            Self::Lifts(lifts) => Some(lifts.duration_s()),
            Self::Stroke { stroke, .. } => Some(stroke.duration_s()),
            Self::Jog(_) => None,
            Self::RunDown(jog) => Some(jog.change_s()),
        }
    }
}

const fn turned(position: Position, rotation: Degrees) -> Pose {
    Pose { position, rotation }
}
