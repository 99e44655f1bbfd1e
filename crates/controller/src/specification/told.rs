//! What the arm tells of itself.

use dobot_arm::forward;
use dobot_course::Model;
use dobot_wire::Status;

#[expect(
    clippy::cast_possible_truncation,
    reason = "a status carries single precision"
)]
pub(crate) fn status(model: &Model) -> Status {
    // The coordinates are those of the very angles that the status tells.
    let joints = model.place.joints;
    let pose = forward(&joints, model.tool);
    Status {
        x_mm: pose.position.x.0 as f32,
        y_mm: pose.position.y.0 as f32,
        z_mm: pose.position.z.0 as f32,
        rotation_deg: pose.rotation.0 as f32,
        base_deg: joints.base.0 as f32,
        rear_deg: joints.rear.0 as f32,
        fore_deg: joints.fore.0 as f32,
        servo_deg: joints.servo.0 as f32,
        suction: model.suction,
        gripper_deg: model.gripper_deg as f32,
    }
}
