//! The position of the arm.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, Unreachable, forward, inverse};
use dobot_wire::{Status, single};

/// Joint angles and the matching pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPlace {
    /// The joint angles.
    pub joints: Joints,
    /// The position and rotation of the tool.
    pub pose: Pose,
}

impl ArmPlace {
    /// Returns the position of these joint angles with a tool.
    #[must_use]
    pub fn at_joints(joints: Joints, tool: Tool) -> Self {
        Self {
            joints,
            pose: forward(&joints, tool),
        }
    }

    /// Returns the position of a pose.
    ///
    /// This is geometry only; [`ArmPlace::check`] checks the limits.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] if the arm is too short or too long, or a number is not finite.
    pub fn at_pose(pose: Pose, tool: Tool) -> Result<Self, Unreachable> {
        inverse(&pose, tool).map(|joints| Self { joints, pose })
    }

    /// Returns the status of an arm at rest here, with the pump off and the gripper at 0.
    #[must_use]
    pub fn status(&self) -> Status {
        let Self { joints, pose } = self;
        Status {
            x_mm: single(pose.position.x.0),
            y_mm: single(pose.position.y.0),
            z_mm: single(pose.position.z.0),
            rotation_deg: single(pose.rotation.0),
            base_deg: single(joints.base.0),
            rear_deg: single(joints.rear.0),
            fore_deg: single(joints.fore.0),
            servo_deg: single(joints.servo.0),
            suction: false,
            gripper_deg: 0.0,
        }
    }

    /// Returns the position that a status reports.
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

    /// Checks the limits of a stock arm.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] with the first limit that is exceeded.
    pub fn check(&self) -> Result<(), Unreachable> {
        Limits::STOCK.check_at(&self.joints, self.pose.position)
    }

    /// Whether the position is within the limits, but the rounding of a stock arm could move it
    /// outside.
    pub(crate) fn is_at_limit(&self) -> bool {
        let beside = |[rear, fore]: [f64; 2]| {
            let Joints { base, servo, .. } = self.joints;
            let joints = Joints {
                base: base + Degrees(rear * ROUNDING),
                rear: self.joints.rear + Degrees(rear * ROUNDING),
                fore: self.joints.fore + Degrees(fore * ROUNDING),
                servo: servo + Degrees(rear * ROUNDING),
            };
            let Position { x, y, z } = self.pose.position;
            let farther = 1.0 + fore * ROUNDING;
            let position = Position::new(x.0 * farther, y.0 * farther, z.0 + rear * ROUNDING);
            Limits::STOCK.check_at(&joints, position)
        };
        let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        signs.into_iter().any(|sign| beside(sign).is_err())
    }
}

/// More than the single-precision rounding of an angle or a position, in degrees, mm and parts.
const ROUNDING: f64 = 1e-3;

/// Returns a position from the numbers of a packet.
pub(crate) fn position(x_mm: f32, y_mm: f32, z_mm: f32) -> Position {
    Position::new(x_mm.into(), y_mm.into(), z_mm.into())
}
