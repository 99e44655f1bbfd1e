//! Whether the arm may be somewhere at all.

use dobot_arm::Tool;
use dobot_trajectory::ArmPlace;

use crate::fence::Fence;
use crate::{Policy, Violation};

impl Policy {
    /// Whether the arm may stand at a place with a tool; how it gets there is another question.
    #[must_use]
    pub fn allows(&self, place: &ArmPlace, tool: Tool) -> bool {
        self.check_place(place, tool).is_ok()
    }

    /// The same, with the rule that forbids it.
    ///
    /// # Errors
    ///
    /// [`Violation`] with the first rule that is broken there.
    pub fn check_place(&self, place: &ArmPlace, tool: Tool) -> Result<(), Violation> {
        let fence = Fence::new(self, tool, false);
        let stop = fence.stop(0.0, *place);
        let broken = fence.broken_at(&stop).next();
        broken.map_or(Ok(()), |it| Err(Violation::of_place(&it, &stop)))
    }
}
