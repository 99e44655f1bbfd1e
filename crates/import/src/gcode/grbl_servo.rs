//! Whether M3 turns the servo of a pen, which GRBL has in place of the spindle, and no laser of two powers.

use super::machine::{Move, MoveKind, ToolState};
use super::servo::{ServoCode, ServoStatistics, UpSource};

/// How M3 is used. A servo gets two angles by turns, each in a line of its own with M3, and holds one of them in all
/// moves; the program waits (G4) for it to turn, or has one of them in all that it does in haste (G0). A laser goes off
/// on its way, or has its power beside the moves.
#[derive(Debug, Default)]
pub(super) struct GrblServoStatistics {
    angles: ServoStatistics,
    /// The angle of the last move, and of the one before it that had another.
    held: Option<f64>,
    other: Option<f64>,
    /// How often it was turned between moves.
    turns: u32,
    /// The angle with which the program waited last.
    waited: Option<f64>,
    /// It did not wait for the servo to turn.
    is_hasty: bool,
    /// Something moved along X or Y without an angle since the first: nothing may move with one after that.
    is_off: bool,
    /// Something does not fit a servo.
    is_none: bool,
    /// With what it moved in haste, and with what at a working speed.
    rapids: Angles,
    feeds: Angles,
}

/// The angles of moves.
#[derive(Debug, Default)]
struct Angles {
    first: Option<f64>,
    is_mixed: bool,
}

impl Angles {
    fn count(&mut self, angle: f64) {
        self.is_mixed |= *self.first.get_or_insert(angle) != angle;
    }
}

impl GrblServoStatistics {
    /// Counts a move of any kind.
    pub(super) fn count(&mut self, it: &Move) {
        if it.kind == MoveKind::Dwell {
            self.waited = it.tool.angle(ServoCode::M3);
        }
        if it.stands() {
            return;
        }
        self.angles.count(it, ServoCode::M3);
        let Some(angle) = it.tool.angle(ServoCode::M3) else {
            self.is_off |= self.held.is_some();
            self.is_none |= it.tool.power.is_some();
            return;
        };
        // That of a laser at work may be told beside the moves.
        let own = (angle > 0.0).then_some(angle);
        self.is_none |= it.tool.power != own || self.is_off;
        match self.held.replace(angle) {
            Some(held) if held != angle => self.turn(held, angle),
            _ => {}
        }
        self.waited = None;
        match it.kind {
            MoveKind::Rapid => self.rapids.count(angle),
            _ => self.feeds.count(angle),
        }
    }

    fn turn(&mut self, from: f64, to: f64) {
        self.turns = self.turns.saturating_add(1);
        self.is_hasty |= self.waited != Some(to);
        self.is_none |= self.other.is_some_and(|other| other != to);
        self.other = Some(from);
    }

    /// The angle that is up, where it is a servo; `end` is the tool at the end of the program.
    pub(super) fn up(&self, text: &[u8], end: &ToolState) -> Option<(f64, UpSource)> {
        let is_mixed = self.rapids.is_mixed || self.feeds.is_mixed;
        let has_both = self.rapids.first.is_some() && self.feeds.first.is_some();
        let is_told_by_haste = has_both && !is_mixed && self.rapids.first != self.feeds.first;
        let fits = self.turns >= LEAST_TURNS && (!self.is_hasty || is_told_by_haste);
        let is_zero = |it: Option<f64>| it == Some(0.0);
        // A laser that is off at 0 draws the same; at 0 a pen is down only where nothing else is told.
        let has_zero = is_zero(self.held) || is_zero(self.other);
        let is_laser = has_zero && (!is_told_by_haste || is_zero(self.rapids.first));
        if self.is_none || !fits || is_laser {
            return None;
        }
        // M5 lets it rest in the end.
        let end = end.angle(ServoCode::M3).or(self.held);
        self.angles.up(text, ServoCode::M3, end)
    }
}

/// A laser may have another power once, for what it does next.
const LEAST_TURNS: u32 = 2;
