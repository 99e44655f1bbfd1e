//! Recovery: finds the last completed command by where the arm rests.

use dobot_arm::Position;
use dobot_motion::Model;
use dobot_wire::Command;

use crate::Window;
use crate::ends::{End, Located, SPACING_MM, Walk};

/// Returns the progress of an arm that rests at `rest`, once everything it was given is over.
///
/// `model` is the arm before command `window.completed` ([`model_at`](crate::model_at)), and
/// `lift_mm` the height by which the pen may have been lifted after the last command. The arm may
/// rest at the start of the window or at the end of one of its commands; the nearest of these
/// positions counts if it is within [`NEAR_MM`] and three times closer than the next one.
///
/// Commands without motion leave no trace and are sent again, which has no effect.
///
/// # Errors
///
/// [`Unclear`] if no position is close enough, or two are. A window made by [`window_end`] is clear
/// if it has more than one command.
pub fn locate(
    commands: &[Command],
    window: &Window,
    model: &Model,
    lift_mm: Option<f32>,
    rest: Position,
) -> Result<Located, Unclear> {
    let commands = &commands[..window.upto.min(commands.len())];
    let mut walk = Walk::new(commands, window.completed, model, lift_mm);
    let mut ends: Vec<End> = walk.start().collect();
    while let Some(more) = walk.step() {
        ends.extend(more);
    }
    let nearest = plainest(&ends, nearest(ends.iter(), rest), commands);
    let others = ends
        .iter()
        .filter(|end| end.located != nearest.located && !end.is_equivalent_to(&nearest, commands));
    judge(rest, nearest, others.copied().min_by(by_distance(rest)))
}

/// Returns the end of a window that begins at `completed` and has at most `most` commands: the
/// command before the first one whose end is unknown or coincides with another end. One command is
/// always allowed.
///
/// `model` is the arm before command `completed`. Commands given earlier stay given, even if this
/// window is shorter.
///
/// ```text
///    .--- 3 ---.
///    4         2     a closed path: ends 0 and 4 are one place, so a window that begins
///    |         |     at 0 reaches up to 4 and does not hold the command that closes it
///   0,4 -- 1 --'
/// ```
#[must_use]
pub fn window_end(
    commands: &[Command],
    completed: usize,
    model: &Model,
    lift_mm: Option<f32>,
    most: usize,
) -> usize {
    let last = completed.saturating_add(most).min(commands.len());
    let mut walk = Walk::new(&commands[..last], completed, model, lift_mm);
    let mut ends: Vec<End> = walk.start().collect();
    let mut upto = completed;
    while let Some(more) = walk.step() {
        let before = ends.len();
        ends.extend(more);
        let (before, more) = ends.split_at(before);
        let is_clear = |end: &End| {
            let mut before = before.iter();
            before.all(|earlier| earlier.is_distinct_from(end, commands))
        };
        if !more.iter().all(is_clear) {
            break;
        }
        upto += 1;
    }
    upto.max((completed + 1).min(last))
}

/// Why the progress of an arm cannot be determined.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unclear {
    /// The arm rests where no command ends.
    #[error(
        "the arm rests {distance_mm:.3} mm from the nearest position where it may have stopped, \
         {nearest}; up to {NEAR_MM} mm are allowed: move it there, or state how far it got"
    )]
    Nowhere {
        /// The nearest position.
        nearest: End,
        /// The distance to it.
        distance_mm: f64,
    },

    /// The arm rests where either of two commands may have ended.
    #[error(
        "the arm rests {nearest_mm:.3} mm from {nearest} and {second_mm:.3} mm from {second}, too \
         close to both to decide: state which it is"
    )]
    Between {
        /// The nearest position.
        nearest: End,
        /// The distance to it.
        nearest_mm: f64,
        /// The next one.
        second: End,
        /// The distance to it.
        second_mm: f64,
    },
}

fn judge(rest: Position, nearest: End, second: Option<End>) -> Result<Located, Unclear> {
    let nearest_mm = nearest.distance_mm(rest);
    // A position that is not a number is close to nothing.
    if nearest_mm.is_nan() || nearest_mm > NEAR_MM {
        return Err(Unclear::Nowhere {
            nearest,
            distance_mm: nearest_mm,
        });
    }
    let Some(second) = second else {
        return Ok(nearest.located);
    };
    let second_mm = second.distance_mm(rest);
    if second_mm >= CLEARLY * nearest_mm && second_mm - nearest_mm >= SPACING_MM / 2.0 {
        return Ok(nearest.located);
    }
    Err(Unclear::Between {
        nearest,
        nearest_mm,
        second,
        second_mm,
    })
}

fn nearest<'a>(ends: impl Iterator<Item = &'a End>, rest: Position) -> End {
    let ends = ends.copied();
    ends.min_by(by_distance(rest))
        .expect("a walk has a start at least")
}

/// Of two equivalent ends, returns the one that lowers no pen.
fn plainest(ends: &[End], nearest: End, commands: &[Command]) -> End {
    let same = ends
        .iter()
        .filter(|end| end.is_equivalent_to(&nearest, commands));
    let plain = same.filter(|end| !end.located.lifted).copied().next();
    plain.unwrap_or(nearest)
}

fn by_distance(rest: Position) -> impl Fn(&End, &End) -> std::cmp::Ordering {
    move |a, b| a.distance_mm(rest).total_cmp(&b.distance_mm(rest))
}

/// The largest distance between a position and the one where the arm rests, in millimetres.
pub const NEAR_MM: f64 = 0.5;
/// How many times farther away the second nearest position must be.
const CLEARLY: f64 = 3.0;
