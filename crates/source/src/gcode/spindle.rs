//! Whether what M3 switches is a spindle or a laser.

use super::machine::Move;

/// How a tool that M3 switches is used: a spindle turns on while Z goes up and comes down again, a laser
/// is off on the way.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each happens by itself")]
pub(super) struct SpindleStatistics {
    /// Something was drawn.
    has_worked: bool,
    /// The number of the tool that drew last.
    number: Option<f64>,
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
        self.has_risen |= rise_mm > 0.0 && self.has_worked;
        self.has_plunged |= rise_mm < 0.0 && it.stands() && self.has_risen;
    }

    /// Counts a move of any kind.
    pub(super) fn count(&mut self, it: &Move) {
        self.is_off |= it.tool.power.is_none();
        if it.is_line() && it.tool.power.is_some() {
            self.work(it);
        }
    }

    fn work(&mut self, it: &Move) {
        let number = it.tool.number;
        // A spindle is off while its tool is changed.
        self.is_switched |= self.has_worked && self.is_off && self.number == number;
        self.is_switched |= !it.is_by_m3;
        self.goes_up_and_down |= self.has_plunged;
        (self.has_worked, self.number) = (true, number);
        (self.is_off, self.has_plunged) = (false, false);
    }

    /// A laser that M4 switches is off in G0 by itself.
    pub(super) const fn is_spindle(&self) -> bool {
        self.goes_up_and_down && !self.is_switched
    }
}
