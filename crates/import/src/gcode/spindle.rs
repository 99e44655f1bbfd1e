//! Detection of a spindle instead of a laser on M3.

use super::machine::Move;

/// The use of a tool that M3 switches: a spindle keeps turning while Z goes up and comes down
/// again, a laser is off while it travels.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each happens by itself")]
pub(super) struct SpindleStatistics {
    /// Whether something was drawn.
    has_worked: bool,
    /// The number of the last drawing tool.
    number: Option<f64>,
    /// Whether it was off since.
    is_off: bool,
    /// Whether Z has gone up since something was first drawn.
    has_risen: bool,
    /// Whether it came down by a move along Z only, since something was last drawn.
    has_plunged: bool,
    /// Whether it turned meanwhile, and was not off since.
    has_plunged_on: bool,
    /// Whether it drew again after it was off, or without M3.
    is_switched: bool,
    /// Whether it did not come down since it was on.
    is_switched_below: bool,
    /// Whether it drew again after Z went up and came down.
    goes_up_and_down: bool,
    /// Whether it was not off meanwhile.
    stays_on: bool,
}

impl SpindleStatistics {
    /// Adds the rise of a move of any kind.
    pub(super) fn count_rise(&mut self, motion: &Move, rise_mm: f64) {
        self.has_risen |= rise_mm > 0.0 && self.has_worked;
        let plunges = rise_mm < 0.0 && motion.is_still() && self.has_risen;
        self.has_plunged |= plunges;
        self.has_plunged_on |= plunges && motion.tool.power.is_some();
    }

    /// Handles a move of any kind.
    pub(super) fn count(&mut self, motion: &Move) {
        if motion.tool.power.is_none() {
            (self.is_off, self.has_plunged_on) = (true, false);
        }
        if motion.is_line() && motion.tool.power.is_some() {
            self.work(motion);
        }
    }

    fn work(&mut self, motion: &Move) {
        let number = motion.tool.number;
        // A spindle is off while its tool is changed.
        let is_same = self.has_worked && self.number == number;
        let is_again = is_same && self.is_off;
        self.is_switched |= is_again || !motion.is_by_m3;
        self.is_switched_below |= is_again && !self.has_plunged_on || !motion.is_by_m3;
        self.stays_on |= self.has_plunged && !self.is_off;
        self.goes_up_and_down |= self.has_plunged;
        (self.has_worked, self.number) = (true, number);
        (self.is_off, self.has_plunged, self.has_plunged_on) = (false, false, false);
    }

    /// Whether it is a laser. M4 switches a laser off in G0 by itself. A spindle that is off
    /// between operations turns on its way down, and between cuts in at least one of them.
    pub(super) const fn is_spindle(&self) -> bool {
        let turns_on_its_way = self.stays_on && !self.is_switched_below;
        self.goes_up_and_down && (!self.is_switched || turns_on_its_way)
    }
}
