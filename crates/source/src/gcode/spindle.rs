//! Whether what M3 switches is a spindle or a laser.

use super::machine::{Move, MoveKind};

/// How a tool that M3 switches is used: a spindle turns on while Z goes up and comes down again, a laser
/// is off on the way.
#[derive(Debug, Default)]
pub(super) struct SpindleStatistics {
    /// The number of the tool, once something was drawn with it.
    worked: Option<Option<f64>>,
    /// It was off since.
    is_off: bool,
    /// Z has gone up since something was drawn first.
    has_risen: bool,
    /// And came down by a move along Z alone, since something was drawn last.
    has_plunged: bool,
    /// It drew again after it was off, or not by M3.
    is_switched: bool,
    /// It drew again after Z went up and came down.
    goes_up_and_down: bool,
}

impl SpindleStatistics {
    /// Counts how far a move of any kind rises.
    pub(super) fn count_rise(&mut self, it: &Move, rise_mm: f64) {
        self.has_risen |= rise_mm > 0.0 && self.worked.is_some();
        self.has_plunged |= rise_mm < 0.0 && it.from == it.to && self.has_risen;
    }

    /// Counts a move of any kind.
    pub(super) fn count(&mut self, it: &Move) {
        self.is_off |= it.tool.power.is_none();
        let is_line = matches!(it.kind, MoveKind::Line | MoveKind::Arc { .. });
        if is_line && it.from != it.to && it.tool.power.is_some() {
            self.work(it);
        }
    }

    fn work(&mut self, it: &Move) {
        let number = it.tool.number;
        // A spindle is off while its tool is changed.
        self.is_switched |= self.is_off && self.worked == Some(number);
        self.is_switched |= !it.is_by_m3;
        self.goes_up_and_down |= self.has_plunged;
        self.worked = Some(number);
        (self.is_off, self.has_plunged) = (false, false);
    }

    /// A laser that M4 switches is off in G0 by itself.
    pub(super) const fn is_spindle(&self) -> bool {
        self.goes_up_and_down && !self.is_switched
    }
}
