//! The status that an arm sends.

use dobot_wire::{Status, single};

use crate::{ArmPlace, Model};

impl Model {
    /// Returns the status of the arm with this model.
    #[must_use]
    pub fn status(&self) -> Status {
        // The coordinates match exactly the angles in the status.
        Status {
            suction: self.suction,
            gripper_deg: single(self.gripper_deg),
            ..ArmPlace::at_joints(self.place.joints, self.tool).status()
        }
    }
}
