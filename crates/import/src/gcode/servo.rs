//! Detection of a servo that lifts a pen, and of its raised angle.

use super::machine::{Move, MoveKind};
use crate::number::decimal;

/// The code that turns the servo.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ServoCode {
    M280,
    /// A beep elsewhere; the servo angle on the machines of Inkscape's extension Unicorn.
    M300,
    /// The speed of a spindle or the power of a laser elsewhere; the angle of a servo on the
    /// spindle output of GRBL.
    M3,
}

impl ServoCode {
    const fn name(self) -> &'static str {
        match self {
            Self::M280 => "M280",
            Self::M300 => "M300",
            Self::M3 => "M3",
        }
    }

    pub(super) const fn what(self) -> &'static str {
        match self {
            Self::M280 => "pen lifted by a servo (M280)",
            Self::M300 => "pen lifted by a servo (M300)",
            Self::M3 => "pen lifted by a servo (M3)",
        }
    }
}

/// The evidence for the raised angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum UpSource {
    /// A comment.
    Comment,
    /// The rapid moves.
    Rapids,
    /// The larger angle.
    Larger,
    /// The last angle: the file started with a move before the first angle.
    Last,
    /// The first move.
    First,
}

impl UpSource {
    pub(super) const fn reason(self) -> &'static str {
        match self {
            Self::Comment => "as a comment states",
            Self::Rapids => "the angle in G0 moves",
            Self::Larger => "because it is the largest angle",
            Self::Last => "the angle at the end of the program",
            Self::First => "the angle in the first move",
        }
    }
}

/// Statistics of the moves of a file and the servo angles.
#[derive(Debug, Default)]
pub(super) struct ServoStatistics {
    /// The angles of moves, in order.
    angles: Vec<AngleUse>,
    /// Whether something moved before the first angle.
    has_moved_before: bool,
}

/// The number of moves with an angle.
#[derive(Clone, Copy, Debug)]
struct AngleUse {
    angle: f64,
    rapids: u32,
    feeds: u32,
}

impl ServoStatistics {
    /// Handles a move along X or Y.
    pub(super) fn count(&mut self, motion: &Move, code: ServoCode) {
        let Some(angle) = motion.tool.angle(code) else {
            self.has_moved_before |= self.angles.is_empty();
            return;
        };
        let known = self.angles.iter().position(|motion| motion.angle == angle);
        let i = known.unwrap_or(self.angles.len());
        if i == MAX_ANGLES {
            return;
        }
        if known.is_none() {
            self.angles.push(AngleUse::new(angle));
        }
        let count = match motion.kind {
            MoveKind::Rapid => &mut self.angles[i].rapids,
            _ => &mut self.angles[i].feeds,
        };
        *count = count.saturating_add(1);
    }

    /// The raised angle, unless nothing moves with another one; `end` is the angle at the end of
    /// the program.
    pub(super) fn up(
        &self,
        text: &[u8],
        code: ServoCode,
        end: Option<f64>,
    ) -> Option<(f64, UpSource)> {
        let first = self.angles.first()?;
        let end = end.filter(|end| *end != first.angle);
        let last = end.filter(|_| self.has_moved_before);
        if self.angles.len() == 1 && last.is_none() {
            return None;
        }
        let angles = || self.angles.iter().map(|angle| angle.angle).chain(last);
        if let Some(up_angle) =
            commented_up(text, code).filter(|up| angles().any(|angle| angle == *up))
        {
            return Some((up_angle, UpSource::Comment));
        }
        // The first one with the largest share.
        let shares = || self.angles.iter().map(AngleUse::share_of_rapids);
        let most = shares().fold(0.0, f64::max);
        if shares().any(|share| share < most) {
            let up = self
                .angles
                .iter()
                .find(|angle| angle.share_of_rapids() == most)?;
            return Some((up.angle, UpSource::Rapids));
        }
        Some(match (code, last) {
            (ServoCode::M300, _) => (angles().fold(0.0, f64::max), UpSource::Larger),
            (ServoCode::M280 | ServoCode::M3, Some(last)) => (last, UpSource::Last),
            (ServoCode::M280 | ServoCode::M3, None) => (first.angle, UpSource::First),
        })
    }
}

impl AngleUse {
    const fn new(angle: f64) -> Self {
        Self {
            angle,
            rapids: 0,
            feeds: 0,
        }
    }

    fn share_of_rapids(&self) -> f64 {
        f64::from(self.rapids) / (f64::from(self.rapids) + f64::from(self.feeds))
    }
}

/// The raised angle according to a comment: `M300 S50 (pen up)`, `M280 P0 S90 ; up`.
fn commented_up(text: &[u8], code: ServoCode) -> Option<f64> {
    let mut lines = text.split(|byte| b"\r\n".contains(byte));
    lines.find_map(|line| {
        let comment = line.iter().position(|byte| b"(;".contains(byte))?;
        let (words, comment) = line.split_at(comment);
        let name = code.name().as_bytes();
        let is_named = |byte: &[u8]| {
            byte.strip_prefix(name)
                .is_some_and(|rest| !rest.first().is_some_and(u8::is_ascii_digit))
        };
        if !(0..words.len()).any(|i| is_named(&words[i..])) || !calls_up(comment) {
            return None;
        }
        let s = words.iter().position(|&byte| byte == b'S')?;
        decimal(&words[s + 1..]).map(|(angle, _)| angle)
    })
}

fn calls_up(comment: &[u8]) -> bool {
    let has = |word: &[u8]| {
        let mut words = comment.split(|byte| !byte.is_ascii_alphabetic());
        words.any(|found| found.eq_ignore_ascii_case(word))
    };
    has(b"up") && !has(b"down")
}

/// The largest number of different angles.
const MAX_ANGLES: usize = 16;
