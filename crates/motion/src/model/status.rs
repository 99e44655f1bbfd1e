//! The status that an arm sends.

use dobot_wire::{Status, single};

use crate::{ArmPlace, Model};

impl Model {
    /// The status that the arm of this model sends.
    #[must_use]
    pub fn status(&self) -> Status {
        // The coordinates are those of the very angles that the status tells.
        Status {
            suction: self.suction,
            gripper_deg: single(self.gripper_deg),
            ..ArmPlace::at_joints(self.place.joints, self.tool).status()
        }
    }
}
