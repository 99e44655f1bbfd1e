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
    /// It turned meanwhile, and was not off since.
    has_plunged_on: bool,
    /// It drew again after it was off, or not by M3.
    is_switched: bool,
    /// And it did not come down since it was on.
    is_switched_below: bool,
    /// It drew again after Z went up and came down.
    goes_up_and_down: bool,
    /// And was not off meanwhile.
    stays_on: bool,
}

impl SpindleStatistics {
    /// Counts how far a move of any kind rises.
    pub(super) fn count_rise(&mut self, it: &Move, rise_mm: f64) {
        self.has_risen |= rise_mm > 0.0 && self.has_worked;
        let plunges = rise_mm < 0.0 && it.stands() && self.has_risen;
        self.has_plunged |= plunges;
        self.has_plunged_on |= plunges && it.tool.power.is_some();
    }

    /// Counts a move of any kind.
    pub(super) fn count(&mut self, it: &Move) {
        if it.tool.power.is_none() {
            (self.is_off, self.has_plunged_on) = (true, false);
        }
        if it.is_line() && it.tool.power.is_some() {
            self.work(it);
        }
    }

    fn work(&mut self, it: &Move) {
        let number = it.tool.number;
        // A spindle is off while its tool is changed.
        let is_same = self.has_worked && self.number == number;
        let is_again = is_same && self.is_off;
        self.is_switched |= is_again || !it.is_by_m3;
        self.is_switched_below |= is_again && !self.has_plunged_on || !it.is_by_m3;
        self.stays_on |= self.has_plunged && !self.is_off;
        self.goes_up_and_down |= self.has_plunged;
        (self.has_worked, self.number) = (true, number);
        (self.is_off, self.has_plunged, self.has_plunged_on) = (false, false, false);
    }

    /// A laser that M4 switches is off in G0 by itself. A spindle that is off between operations turns on its way down,
    /// and from one cut to the next in at least one of them.
    pub(super) const fn is_spindle(&self) -> bool {
        let turns_on_its_way = self.stays_on && !self.is_switched_below;
        self.goes_up_and_down && (!self.is_switched || turns_on_its_way)
    }
}
