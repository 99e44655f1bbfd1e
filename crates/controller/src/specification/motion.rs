//! The motion that is going on.

use core::time::Duration;

use dobot_arm::{Degrees, Pose, Tool, Unreachable, inverse};
use dobot_motion::{JointMove, Jump, LineMove, Stroke};

use super::jog::Jog;
use super::state::Place;

/// A motion that is going on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Running {
    pub(crate) motion: Motion,
    pub(crate) began: Duration,
    /// When it is over; never, for a jog whose button is held.
    pub(crate) ends: Duration,
    pub(crate) then: Then,
    /// Where a jog leads until the next tick, as far as it was looked ahead already.
    pub(crate) ahead: Option<(Duration, Place)>,
}

/// The ways to move.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Motion {
    Joints(JointMove),
    Line(LineMove),
    Jump(Jump),
    Stroke { stroke: Stroke, rotation: Degrees },
    Jog(Jog),
    Pause,
}

/// What happens when a motion is over.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Then {
    Nothing,
    /// Set the tool, then wait (Table 3.7).
    SetTool {
        suction: bool,
        gripper_deg: f64,
        pause: Duration,
    },
    /// Write mode: the laser goes off unless another vector follows at once (note N36).
    EndStroke,
}

impl Running {
    /// Where the arm is at a time; `None` while it stands.
    pub(crate) fn place_at(&self, at: Duration, tool: Tool) -> Option<Result<Place, Unreachable>> {
        if let Some((_, place)) = self.ahead.filter(|(when, _)| *when == at) {
            return Some(Ok(place));
        }
        self.motion
            .place_at(at.saturating_sub(self.began).as_secs_f64(), tool)
    }
}

impl Motion {
    pub(crate) fn place_at(&self, t_s: f64, tool: Tool) -> Option<Result<Place, Unreachable>> {
        Some(match self {
            Self::Joints(it) => Ok(Place::at_joints(it.joints_at(t_s), tool)),
            Self::Line(it) => place(it.pose_at(t_s), tool),
            Self::Jump(it) => place(it.pose_at(t_s), tool),
            Self::Stroke { stroke, rotation } => place(
                Pose {
                    position: stroke.position_at(t_s),
                    rotation: *rotation,
                },
                tool,
            ),
            Self::Jog(it) => return it.place_at(t_s, tool),
            Self::Pause => return None,
        })
    }

    /// How long it takes; `None` for one that goes on until told otherwise.
    pub(crate) const fn duration_s(&self) -> Option<f64> {
        match self {
            Self::Joints(it) => Some(it.duration_s()),
            Self::Line(it) => Some(it.duration_s()),
            Self::Jump(it) => Some(it.duration_s()),
            Self::Stroke { stroke, .. } => Some(stroke.duration_s()),
            Self::Jog(_) | Self::Pause => None,
        }
    }
}

fn place(pose: Pose, tool: Tool) -> Result<Place, Unreachable> {
    inverse(&pose, tool).map(|joints| Place { joints, pose })
}
