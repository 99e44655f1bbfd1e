//! When a file says that its laser is on, as GRBL has it in laser mode ($32=1).

use super::machine::{Move, MoveKind};

/// What a program has said of its laser so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LaserState {
    /// Whether M3, M4 or M106 hold; unknown before the first of them, M5 and M107.
    pub(super) is_on: Option<bool>,
    /// The S in force; unknown before the first one.
    pub(super) power: Option<f64>,
}

impl LaserState {
    /// Whether the program says nothing of a laser: a pen's, by Z or a servo, or one of moves alone.
    pub(super) const fn is_unknown(self) -> bool {
        self.is_on.is_none() && self.power.is_none()
    }

    /// Whether the laser is on with power, where `end` is the state at the end of the program: M3, M4 or M106 hold with S above
    /// 0, or without S in a program that has none.
    fn has_power(self, end: Self) -> bool {
        let power = self.power.map_or(end.power.is_none(), |s| s > 0.0);
        self.is_on == Some(true) && power
    }
}

/// The last word on what a laser burns: whatever the rule of the file is, it is dark where this says so.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaserSwitch {
    /// The state at the end of the program.
    pub(super) end: LaserState,
    /// Where the first line with power stands in the text.
    pub(super) first_line_at: Option<usize>,
    /// The height of the highest line with power.
    pub(super) highest_line_mm: f64,
    /// Z moves the tool into the work: what waits may be a spindle.
    pub(super) is_drill: bool,
}

impl LaserSwitch {
    /// Whether a move may burn. Moves in haste and along Z alone, and drilled holes, never do.
    pub(super) fn is_on(&self, it: &Move) -> bool {
        let is_powered = self.end.is_unknown() || it.laser.has_power(self.end);
        is_powered && (it.is_line() || it.kind == MoveKind::Dwell && !self.is_spindle_dwell(it))
    }

    /// Whether a spindle may turn up, or cut a hole clear, in this dwell.
    pub(super) fn is_spindle_dwell(&self, it: &Move) -> bool {
        let Some(first_at) = self.first_line_at else {
            return self.is_drill;
        };
        let is_above = it.z_mm.is_some_and(|z_mm| z_mm > self.highest_line_mm);
        self.is_drill || it.at < first_at || is_above
    }
}
