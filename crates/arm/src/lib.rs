//! The original Dobot Arm: units, poses, tools, limits and kinematics.

#![no_std]

mod joints;
mod pose;
mod position;
mod tool;
mod units;

pub use joints::Joints;
pub use pose::Pose;
pub use position::Position;
pub use tool::Tool;
pub use units::{Degrees, Millimeters};
