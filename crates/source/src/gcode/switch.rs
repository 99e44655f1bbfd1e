//! Whether M3 and M5 switch what draws, where the program tells no S.

use super::ink_rule::InkRule;
use super::machine::Move;

/// The lines at a working speed, while it is on and while it is off.
#[derive(Debug, Default)]
pub(super) struct SwitchStatistics {
    /// Whether it was on in the first line.
    first_is_on: Option<bool>,
    has_on: bool,
}

impl SwitchStatistics {
    /// Counts a move along X or Y.
    pub(super) fn count(&mut self, it: &Move) {
        if it.is_line() {
            let is_on = it.tool.is_on_without_power;
            self.first_is_on.get_or_insert(is_on);
            self.has_on |= is_on;
        }
    }

    /// It does where the program begins with a way while it is off. Otherwise nothing is known: some pens are up while M3
    /// holds.
    pub(super) fn rule(&self) -> InkRule {
        match self.first_is_on {
            Some(false) if self.has_on => InkRule::Switch,
            _ => InkRule::Plain,
        }
    }
}
