//! Whether a pen is down where Z is high, as with machines whose Z points down.

use super::ink_rule::{InkRule, SAME_HEIGHT_MM};
use super::machine::{Move, MoveKind};

/// At which heights it travels in haste, and how many lines lie above and below.
#[derive(Debug, Default)]
pub(super) struct HighStatistics {
    /// The height of the first travel of known height.
    rapids_mm: Option<f64>,
    /// And of the first line above it.
    lines_mm: Option<f64>,
    above: u32,
    others: u32,
    /// Travels or lines above have several heights.
    is_mixed: bool,
}

impl HighStatistics {
    /// Counts a move along X or Y.
    pub(super) fn count(&mut self, it: &Move) {
        let Some(z_mm) = it.z_mm else {
            return;
        };
        if it.kind == MoveKind::Rapid {
            let first_mm = *self.rapids_mm.get_or_insert(z_mm);
            self.is_mixed |= !is_same(first_mm, z_mm);
            return;
        }
        if self
            .rapids_mm
            .is_some_and(|it| z_mm > it && !is_same(it, z_mm))
        {
            let first_mm = *self.lines_mm.get_or_insert(z_mm);
            self.is_mixed |= !is_same(first_mm, z_mm);
            self.above = self.above.saturating_add(1);
        } else {
            self.others = self.others.saturating_add(1);
        }
    }

    /// It is where all travels have one height, and most lines have another above it.
    pub(super) fn rule(&self) -> Option<InkRule> {
        let (rapids_mm, lines_mm) = (self.rapids_mm?, self.lines_mm?);
        let is_high = !self.is_mixed && self.above > self.others;
        is_high.then_some(InkRule::HighPen {
            above_mm: f64::midpoint(rapids_mm, lines_mm),
        })
    }
}

fn is_same(a_mm: f64, b_mm: f64) -> bool {
    (a_mm - b_mm).abs() < SAME_HEIGHT_MM
}
