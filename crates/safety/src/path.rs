//! A segment of a path on which the same quantities change evenly.

use dobot_arm::{Joints, Pose, Tool, Unreachable};
use dobot_motion::{ArmPlace, Interpolation, Trajectory};

/// A segment of a path; positions on it are given by a share, 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Path<'a> {
    /// A part of a trajectory, between two times in seconds.
    Trajectory {
        trajectory: &'a Trajectory,
        from_s: f64,
        to_s: f64,
        interpolation: Interpolation,
    },
    /// All joints turn evenly.
    Joints {
        from: Joints,
        to: Joints,
        tool: Tool,
    },
    /// The tool moves in a straight line.
    Line { from: Pose, to: Pose, tool: Tool },
}

impl Path<'_> {
    pub(crate) fn place_at(&self, share: f64) -> Result<ArmPlace, Unreachable> {
        match self {
            Self::Trajectory { trajectory, .. } => {
                trajectory.place_at(self.time_at(share).unwrap_or_default())
            }
            Self::Joints { from, to, tool } => {
                Ok(ArmPlace::at_joints(joints_between(from, to, share), *tool))
            }
            Self::Line { from, to, tool } => {
                let pose = Pose {
                    position: from.position + (to.position - from.position) * share,
                    rotation: from.rotation + (to.rotation - from.rotation) * share,
                };
                ArmPlace::at_pose(pose, *tool)
            }
        }
    }

    /// Returns the time since the command began, in seconds, if known.
    pub(crate) fn time_at(&self, share: f64) -> Option<f64> {
        match *self {
            Self::Trajectory { to_s, .. } if share >= 1.0 => Some(to_s),
            Self::Trajectory { from_s, to_s, .. } => Some(from_s + (to_s - from_s) * share),
            _ => None,
        }
    }

    pub(crate) const fn interpolation(&self) -> Interpolation {
        match self {
            Self::Trajectory { interpolation, .. } => *interpolation,
            Self::Joints { .. } => Interpolation::Joints,
            Self::Line { .. } => Interpolation::Line,
        }
    }
}

fn joints_between(from: &Joints, to: &Joints, share: f64) -> Joints {
    Joints {
        base: from.base + (to.base - from.base) * share,
        rear: from.rear + (to.rear - from.rear) * share,
        fore: from.fore + (to.fore - from.fore) * share,
        servo: from.servo + (to.servo - from.servo) * share,
    }
}
