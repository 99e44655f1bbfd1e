//! The state of a laser, as in the laser mode of GRBL ($32=1).

use dobot_geometry::CancelToken;

use super::block;
use super::machine::{Move, MoveKind};
use super::outputs::is_output;

/// The codes that switch the laser of a program on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LaserCodes {
    /// M3 and M4. M106 controls a fan.
    Spindle,
    /// M106: there is no M3 or M4.
    Fan,
    /// Those of outputs: there is no M3, M4 or M106.
    Outputs,
}

impl LaserCodes {
    /// Finds the codes of a program. Once it is cancelled, they do not matter.
    pub(super) fn of(text: &[u8], cancel: &CancelToken) -> Self {
        let (mut has_spindle, mut has_fan, mut has_outputs) = (false, false, false);
        // The program is run up to the same mistake.
        let _ = block::each(text, usize::MAX, |block| {
            has_spindle |= block.m.first(&[30, 40]).is_some();
            has_fan |= block.m.has(1060);
            has_outputs |= block.m.0.iter().any(|entry| is_output(entry.1));
            cancel.check().map_err(Into::into)
        });
        match (has_spindle, has_fan, has_outputs) {
            (true, ..) => Self::Spindle,
            (false, false, true) => Self::Outputs,
            _ => Self::Fan,
        }
    }
}

/// The laser state of a program at a line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LaserState {
    /// Whether M3, M4 or M106 is active, and each output on; unknown before the first of them, M5 and
    /// M107.
    pub(super) is_on: Option<bool>,
    /// The current S; unknown before the first one.
    pub(super) power: Option<f64>,
}

impl LaserState {
    /// Whether the program has no laser commands: it is for a pen with Z or a servo, or has moves
    /// only.
    pub(super) const fn is_unknown(self) -> bool {
        self.is_on.is_none() && self.power.is_none()
    }

    /// Whether it has power, but M5 or M107 holds.
    pub(super) fn is_switched_off(self) -> bool {
        self.is_on == Some(false) && self.power.is_some_and(|s| s > 0.0)
    }

    /// Whether the laser is on with power, where `end` is the state at the end of the program: M3,
    /// M4 or M106 is active with S above 0, or without S in a program that has none.
    fn has_power(self, end: Self) -> bool {
        let power = self.power.map_or(end.power.is_none(), |s| s > 0.0);
        self.is_on == Some(true) && power
    }
}

/// The final decision on a laser: whatever the rule of the file is, it is dark where this says so.
#[derive(Clone, Copy, Debug)]
pub(super) struct LaserSwitch {
    /// The state at the end of the program.
    pub(super) end: LaserState,
    /// The position of the first line with power in the text.
    pub(super) first_line_at: Option<usize>,
    /// The height of the highest line with power.
    pub(super) highest_line_mm: f64,
    /// Whether Z moves the tool into the work: a dwelling tool may be a spindle.
    pub(super) is_drill: bool,
}

impl LaserSwitch {
    /// Whether a move may burn. Rapid moves, moves along Z only and drilled holes never do.
    pub(super) fn is_on(&self, motion: &Move) -> bool {
        let is_powered = self.end.is_unknown() || motion.laser.has_power(self.end);
        is_powered
            && (motion.is_line()
                || motion.kind == MoveKind::Dwell && !self.is_spindle_dwell(motion))
    }

    /// Whether a spindle may spin up, or cut a hole clear, in this dwell.
    pub(super) fn is_spindle_dwell(&self, motion: &Move) -> bool {
        let Some(first_at) = self.first_line_at else {
            return self.is_drill;
        };
        let is_above = motion.z_mm.is_some_and(|z_mm| z_mm > self.highest_line_mm);
        self.is_drill || motion.at < first_at || is_above
    }
}
