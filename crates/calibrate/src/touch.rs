//! A touched point.

use dobot_arm::Joints;

/// A known point and the joint angles that the arm reported when its tool touched it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// The point on the sheet, in the calibrated frame: forward and to the left, in mm.
    pub place_mm: [f64; 2],
    /// The height above the paper, in mm: 0 on the paper, more on a block.
    pub height_mm: f64,
    /// The raw joint angles that the arm reported.
    pub raw: Joints,
}
