//! Whether lines at Z 0 are drawn while others are below: by a pen on uneven paper, or a mill that
//! engraves.

use super::ink_rule::SAME_HEIGHT_MM;
use super::machine::Move;

/// The moves of a file at Z 0.
#[derive(Debug, Default)]
pub(super) struct ZeroStatistics {
    visit: Visit,
    /// Whether lines at a feed rate are there.
    pub(super) has_lines: bool,
    /// Whether the tool came down there from above, drew a line, and went up again.
    has_visits: bool,
    /// Whether lines at a feed rate slope to it or from it, as in a relief, whose untouched surface
    /// it is.
    has_slopes: bool,
}

/// The progress of an isolated line at Z 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Visit {
    #[default]
    Away,
    Down,
    Drawn,
}

impl ZeroStatistics {
    /// Handles a move of any kind between these heights, in mm.
    pub(super) fn count(&mut self, motion: &Move, from_mm: f64, to_mm: f64) {
        let (is_still, is_line) = (motion.is_still(), motion.is_line());
        let slopes = is_line && from_mm != to_mm;
        self.has_slopes |= slopes && (is_zero(from_mm) || is_zero(to_mm));
        let is_above = |z_mm: f64| z_mm >= SAME_HEIGHT_MM;
        self.visit = match self.visit {
            Visit::Away if is_still && is_above(from_mm) && is_zero(to_mm) => Visit::Down,
            Visit::Down if is_line && is_zero(to_mm) => Visit::Drawn,
            visit if is_zero(to_mm) => visit,
            visit => {
                self.has_visits |= visit == Visit::Drawn && is_still && is_above(to_mm);
                Visit::Away
            }
        };
        self.has_lines |= is_line && is_zero(to_mm);
    }

    /// Whether lines there are drawn, not travels.
    pub(super) const fn has_ink(&self) -> bool {
        self.has_visits && !self.has_slopes
    }
}

fn is_zero(z_mm: f64) -> bool {
    (0.0..SAME_HEIGHT_MM).contains(&z_mm)
}
