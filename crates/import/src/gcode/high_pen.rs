//! Detection of a pen that draws at high Z, on machines whose Z points down.

use super::ink_rule::{InkRule, SAME_HEIGHT_MM};
use super::machine::{Move, MoveKind};

/// The heights of rapid moves, and the numbers of lines above and below.
#[derive(Debug, Default)]
pub(super) struct HighStatistics {
    /// The height of the first travel with a known height.
    rapids_mm: Option<f64>,
    /// The height of the first line above it.
    lines_mm: Option<f64>,
    above: u32,
    others: u32,
    /// Whether travels or the lines above have several heights.
    is_mixed: bool,
}

impl HighStatistics {
    /// Handles a move along X or Y.
    pub(super) fn count(&mut self, motion: &Move) {
        let Some(z_mm) = motion.z_mm else {
            return;
        };
        if motion.kind == MoveKind::Rapid {
            let first_mm = *self.rapids_mm.get_or_insert(z_mm);
            self.is_mixed |= !is_same(first_mm, z_mm);
            return;
        }
        if self
            .rapids_mm
            .is_some_and(|motion| z_mm > motion && !is_same(motion, z_mm))
        {
            let first_mm = *self.lines_mm.get_or_insert(z_mm);
            self.is_mixed |= !is_same(first_mm, z_mm);
            self.above = self.above.saturating_add(1);
        } else {
            self.others = self.others.saturating_add(1);
        }
    }

    /// Whether the pen draws at high Z: all travels have one height, and most lines have another
    /// above it.
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
