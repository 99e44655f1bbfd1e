//! The lengths of the arm.

use dobot_arm::{FOREARM, REAR_ARM};

use crate::part::{CRANK_MM, FOOT_MM, FRONT_ROD_AT_MM, REAR_ROD_AT_MM};

/// The lengths of the arm that it takes to draw it, in mm. X is forward in the plane of the arm, and Z up.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "schema", derive(serde::Serialize, schemars::JsonSchema))]
pub struct Dimensions {
    /// From the pivot of the rear arm to the elbow.
    pub rear_arm_mm: f64,
    /// From the elbow to the wrist.
    pub forearm_mm: f64,
    /// From the pivot of the crank to its end, and from the elbow to the tail of the forearm.
    pub crank_mm: f64,
    /// From the pivot of the rear arm to where the rear rod is held, and from the elbow to the same: X and Z.
    pub rear_rod_at_mm: [f64; 2],
    /// From the elbow to where the front rod is held, and from the wrist to the same: X and Z.
    pub front_rod_at_mm: [f64; 2],
    /// How high the pivot of the rear arm is above what the arm stands on (Figure 3.1).
    pub pivot_above_table_mm: f64,
}

impl Dimensions {
    /// Those of the arm as it was sold.
    pub const STOCK: Self = Self {
        rear_arm_mm: REAR_ARM.0,
        forearm_mm: FOREARM.0,
        crank_mm: CRANK_MM,
        rear_rod_at_mm: REAR_ROD_AT_MM,
        front_rod_at_mm: FRONT_ROD_AT_MM,
        pivot_above_table_mm: FOOT_MM,
    };
}
