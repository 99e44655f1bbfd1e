//! Detection of M3 and M5 as switches of the drawing tool, in programs without S.

use super::ink_rule::InkRule;
use super::machine::Move;

/// The numbers of lines at a feed rate, while it is on and while it is off.
#[derive(Debug, Default)]
pub(super) struct SwitchStatistics {
    /// Whether it was on in the first line.
    first_is_on: Option<bool>,
    pub(super) has_on: bool,
}

impl SwitchStatistics {
    /// Handles a move along X or Y.
    pub(super) fn count(&mut self, motion: &Move) {
        if motion.is_line() {
            let is_on = motion.tool.is_on_without_power;
            self.first_is_on.get_or_insert(is_on);
            self.has_on |= is_on;
        }
    }

    /// Whether M3 switches the drawing tool: it does for a laser, and for a pen if the program
    /// starts with a line while it is off. Otherwise nothing is known: some pens are up while M3 is
    /// active.
    pub(super) fn rule(&self, burns: bool) -> Option<InkRule> {
        let is_known = burns || self.first_is_on == Some(false);
        (is_known && self.has_on).then_some(InkRule::Switch)
    }
}
