//! Whether the arm may be somewhere at all.

use dobot_arm::Tool;
use dobot_course::Place;

use crate::Policy;
use crate::fence::Fence;

impl Policy {
    /// Whether the arm may stand at a place with a tool; how it gets there is another question.
    #[must_use]
    pub fn allows(&self, place: &Place, tool: Tool) -> bool {
        let fence = Fence::new(self, tool, false);
        let stop = fence.stop(0.0, *place);
        fence.broken_at(&stop).next().is_none()
    }
}
