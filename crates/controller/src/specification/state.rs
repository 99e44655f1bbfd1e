//! The state of the arm.

use dobot_arm::{Joints, Limits, Pose, Tool, Unreachable, forward};
use dobot_wire::Status;

/// Where the arm is and what its tools do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    pub(crate) place: Place,
    pub(crate) tool: Tool,
    pub(crate) suction: bool,
    pub(crate) laser: bool,
    pub(crate) gripper_deg: f64,
}

/// Joint angles and the pose that they lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    pub(crate) joints: Joints,
    pub(crate) pose: Pose,
}

impl Place {
    pub(crate) fn at_joints(joints: Joints, tool: Tool) -> Self {
        Self {
            joints,
            pose: forward(&joints, tool),
        }
    }

    pub(crate) fn check(&self) -> Result<(), Unreachable> {
        Limits::STOCK.check_at(&self.joints, self.pose.position)
    }
}

impl State {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a status carries single precision"
    )]
    pub(crate) fn status(&self) -> Status {
        // The coordinates are those of the very angles that the status tells.
        let joints = self.place.joints;
        let pose = forward(&joints, self.tool);
        Status {
            x_mm: pose.position.x.0 as f32,
            y_mm: pose.position.y.0 as f32,
            z_mm: pose.position.z.0 as f32,
            rotation_deg: pose.rotation.0 as f32,
            base_deg: joints.base.0 as f32,
            rear_deg: joints.rear.0 as f32,
            fore_deg: joints.fore.0 as f32,
            servo_deg: joints.servo.0 as f32,
            suction: self.suction,
            gripper_deg: self.gripper_deg as f32,
        }
    }
}
