//! Where a command leads the arm: the motion model that client, safety and controller share.

#![no_std]

/// Joint angles and the pose that they lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Joint angles.
    pub joints: dobot_arm::Joints,
    /// The pose.
    pub pose: dobot_arm::Pose,
}
