//! What an arm tells of itself.

use dobot_arm::forward;
use dobot_wire::{Status, single};

use crate::Model;

impl Model {
    /// The status that the arm of this model sends.
    #[must_use]
    pub fn status(&self) -> Status {
        // The coordinates are those of the very angles that the status tells.
        let joints = self.place.joints;
        let pose = forward(&joints, self.tool);
        Status {
            x_mm: single(pose.position.x.0),
            y_mm: single(pose.position.y.0),
            z_mm: single(pose.position.z.0),
            rotation_deg: single(pose.rotation.0),
            base_deg: single(joints.base.0),
            rear_deg: single(joints.rear.0),
            fore_deg: single(joints.fore.0),
            servo_deg: single(joints.servo.0),
            suction: self.suction,
            gripper_deg: single(self.gripper_deg),
        }
    }
}
