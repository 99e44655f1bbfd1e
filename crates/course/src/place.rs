//! Where the arm is.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, Unreachable, forward, inverse};
use dobot_wire::Status;

/// Joint angles and the pose that they lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The joint angles.
    pub joints: Joints,
    /// The tool's place and turn.
    pub pose: Pose,
}

impl Place {
    /// Where these joint angles bring a tool.
    #[must_use]
    pub fn at_joints(joints: Joints, tool: Tool) -> Self {
        Self {
            joints,
            pose: forward(&joints, tool),
        }
    }

    /// The place of a pose.
    ///
    /// This is geometry only: whether the arm may be there is told by [`Place::check`].
    ///
    /// # Errors
    ///
    /// [`Unreachable`] where the arm is too short or too long for it, or a number is not finite.
    pub fn at_pose(pose: Pose, tool: Tool) -> Result<Self, Unreachable> {
        inverse(&pose, tool).map(|joints| Self { joints, pose })
    }

    /// The place that a status tells.
    #[must_use]
    pub fn of_status(status: &Status) -> Self {
        let [base, rear, fore, servo] = [
            status.base_deg,
            status.rear_deg,
            status.fore_deg,
            status.servo_deg,
        ]
        .map(f64::from);
        Self {
            joints: Joints::new(base, rear, fore, servo),
            pose: Pose {
                position: position(status.x_mm, status.y_mm, status.z_mm),
                rotation: Degrees(status.rotation_deg.into()),
            },
        }
    }

    /// Whether the arm may be here, by the limits of a stock arm.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] with the first limit that is exceeded.
    pub fn check(&self) -> Result<(), Unreachable> {
        Limits::STOCK.check_at(&self.joints, self.pose.position)
    }
}

/// A position by the numbers of a packet.
pub(crate) fn position(x_mm: f32, y_mm: f32, z_mm: f32) -> Position {
    Position::new(x_mm.into(), y_mm.into(), z_mm.into())
}
