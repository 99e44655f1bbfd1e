//! Detection of a pen servo on the spindle output of GRBL (M3).

use super::machine::{Move, MoveKind, ToolState};
use super::servo::{ServoCode, ServoStatistics, UpSource};

/// The use of M3. A servo alternates between two angles, each on a separate line with M3, and keeps
/// one of them in all moves; the program waits (G4) for it to turn, or has one of the angles in all
/// rapid moves (G0). A laser is off while it travels, or has its power on the lines of moves.
#[derive(Debug, Default)]
pub(super) struct GrblServoStatistics {
    angles: ServoStatistics,
    /// The angle of the last move, and of the last move with another angle.
    held: Option<f64>,
    other: Option<f64>,
    /// The number of turns between moves.
    turns: u32,
    /// The angle of the last wait.
    waited: Option<f64>,
    /// Whether it did not wait for the servo to turn.
    is_hasty: bool,
    /// Whether something moved along X or Y without an angle after the first angle: after that
    /// nothing may move with one.
    is_off: bool,
    /// Whether something does not fit a servo.
    is_none: bool,
    /// The angle of rapid moves, and of moves at a feed rate.
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
    /// Handles a move of any kind.
    pub(super) fn count(&mut self, motion: &Move) {
        if motion.kind == MoveKind::Dwell {
            self.waited = motion.tool.angle(ServoCode::M3);
        }
        if motion.is_still() {
            return;
        }
        self.angles.count(motion, ServoCode::M3);
        let Some(angle) = motion.tool.angle(ServoCode::M3) else {
            self.is_off |= self.held.is_some();
            self.is_none |= motion.tool.power.is_some();
            return;
        };
        // The power of a laser may be on the lines of moves.
        let own = (angle > 0.0).then_some(angle);
        self.is_none |= motion.tool.power != own || self.is_off;
        match self.held.replace(angle) {
            Some(held) if held != angle => self.turn(held, angle),
            _ => {}
        }
        self.waited = None;
        match motion.kind {
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

    /// The angle of the raised pen, if it is a servo; `end` is the tool at the end of the program.
    pub(super) fn up(&self, text: &[u8], end: &ToolState) -> Option<(f64, UpSource)> {
        let is_mixed = self.rapids.is_mixed || self.feeds.is_mixed;
        let has_both = self.rapids.first.is_some() && self.feeds.first.is_some();
        let differs_by_haste = has_both && !is_mixed && self.rapids.first != self.feeds.first;
        let fits = self.turns >= MIN_TURNS && (!self.is_hasty || differs_by_haste);
        let is_zero = |x: Option<f64>| x == Some(0.0);
        // A laser that is off at 0 draws the same; 0 lowers a pen only without another indication.
        let has_zero = is_zero(self.held) || is_zero(self.other);
        let is_laser = has_zero && (!differs_by_haste || is_zero(self.rapids.first));
        if self.is_none || !fits || is_laser {
            return None;
        }
        // M5 relaxes it at the end.
        let end = end.angle(ServoCode::M3).or(self.held);
        self.angles.up(text, ServoCode::M3, end)
    }
}

/// A laser may once have another power for what follows.
const MIN_TURNS: u32 = 2;
