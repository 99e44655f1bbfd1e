//! A point that the tool has touched.

use dobot_arm::Joints;

/// A known point, and what the arm said when its tool touched it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Where the point is on the sheet, which is the true frame: forward and to the left, in mm.
    pub place_mm: [f64; 2],
    /// How high above the paper it is, in mm: 0 on the paper itself, more on a block of known height.
    pub height_mm: f64,
    /// The joint angles that the arm stated.
    pub raw: Joints,
}
