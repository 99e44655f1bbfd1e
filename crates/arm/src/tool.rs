//! The end effectors of the arm.

use crate::Millimeters;

/// What is mounted at the end of the arm (Table 3.9, state 9, mode 4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tool {
    /// The suction cup; the pen holder has the same reach.
    #[default]
    SuctionCup,
    /// The gripper.
    Gripper,
    /// The laser.
    Laser,
}

impl Tool {
    /// The horizontal distance from the wrist to the tool's centre.
    #[must_use]
    pub const fn reach(self) -> Millimeters {
        match self {
            Self::SuctionCup | Self::Gripper => Millimeters(55.07),
            Self::Laser => Millimeters(49.57),
        }
    }
}
