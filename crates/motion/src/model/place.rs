//! Where the arm is.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, Unreachable, forward, inverse};
use dobot_wire::{Status, single};

/// Joint angles and the pose that they lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPlace {
    /// The joint angles.
    pub joints: Joints,
    /// The tool's place and turn.
    pub pose: Pose,
}

impl ArmPlace {
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
    /// This is geometry only: whether the arm may be there is told by [`ArmPlace::check`].
    ///
    /// # Errors
    ///
    /// [`Unreachable`] where the arm is too short or too long for it, or a number is not finite.
    pub fn at_pose(pose: Pose, tool: Tool) -> Result<Self, Unreachable> {
        inverse(&pose, tool).map(|joints| Self { joints, pose })
    }

    /// The status of an arm that stands here, with the pump off and the gripper at 0.
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

    /// Whether the arm may be here, and the rounding of a stock arm could bring it out.
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
        signs.into_iter().any(|it| beside(it).is_err())
    }
}

/// More than single precision loses of an angle or a place, in degrees, mm and parts.
const ROUNDING: f64 = 1e-3;

/// A position by the numbers of a packet.
pub(crate) fn position(x_mm: f32, y_mm: f32, z_mm: f32) -> Position {
    Position::new(x_mm.into(), y_mm.into(), z_mm.into())
}
