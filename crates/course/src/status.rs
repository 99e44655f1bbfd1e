//! What an arm tells of itself.

use dobot_arm::forward;
use dobot_wire::Status;

use crate::Model;

impl Model {
    /// The status that the arm of this model sends.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a status carries single precision"
    )]
    pub fn status(&self) -> Status {
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
