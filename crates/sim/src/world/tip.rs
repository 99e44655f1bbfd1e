//! The tip of the tool.

use dobot_arm::{Joints, forward};
use dobot_geometry::Point;

use super::Tool;

/// Where the tip of the tool is and how the tool is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tip {
    pub(crate) at: Point,
    /// Above the table; below it where the tool is pressed down.
    pub(crate) height_mm: f64,
    /// From straight ahead, counter-clockwise.
    pub(crate) turn_deg: f64,
}

impl Tip {
    pub(crate) fn of(joints: &Joints, tool: &Tool) -> Self {
        let pose = forward(joints, tool.tool());
        Self {
            at: Point::new(pose.position.x.0, pose.position.y.0),
            height_mm: pose.position.z.0 - tool.down_z_mm,
            turn_deg: pose.rotation.0,
        }
    }
}
