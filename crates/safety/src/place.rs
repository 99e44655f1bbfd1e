//! The check of a single position.

use dobot_arm::{Calibration, Tool};
use dobot_motion::ArmPlace;

use crate::effective_rules::EffectiveRules;
use crate::{Policy, Violation};

impl Policy {
    /// Checks that an arm with this calibration and tool may stand at a raw position, however it
    /// gets there.
    ///
    /// # Errors
    ///
    /// [`Violation`] with the first rule that is broken there.
    pub fn check_place(
        &self,
        place: &ArmPlace,
        tool: Tool,
        arm: &Calibration,
    ) -> Result<(), Violation> {
        let rules = EffectiveRules::new(self, tool, *arm, false);
        let point = rules.point_at(0.0, *place);
        let broken = rules.broken_at(&point).next();
        broken.map_or(Ok(()), |broken| Err(Violation::of_place(&broken, &point)))
    }
}
