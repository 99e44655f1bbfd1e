//! The timeline of a drawing, with which a page can show any moment.

mod thin;

use dobot_arm::TICK_S;
use dobot_plan::Plan;
use schemars::JsonSchema;
use serde::Serialize;

use crate::output::estimate::{Estimate, PassFigures};
use crate::output::trace::{Ink, Trace, TracePoint};

/// The timeline of a drawing, for a page on which a person can move to any moment.
///
/// All numbers are millimetres in the base frame (X forward, Y to the left, Z up) and seconds from
/// the start. Tables are stored as columns of equal length, which is far smaller than named rows.
///
/// **Position at time `t`.** The path is straight between rows, at constant speed. Find the last
/// row `i` with `path.t_s[i] <= t` (binary search; the column never decreases) and interpolate with
/// the share `(t - t_s[i]) / (t_s[i + 1] - t_s[i])` to row `i + 1`; the drawing ends at the last
/// row. The result is within 0.05 mm of the tool. The paper shows all lines up to row `i`, and the
/// piece from row `i` to the tool if row `i + 1` has ink 1. The pen or the laser leaves ink at that
/// time if row `i + 1` has ink 1.
///
/// **Move at time `t`.** Find the last row of `moves` with `from_s <= t` in the same way. A move
/// ends when the next one begins, the last one at `duration_s`.
///
/// **Drawing.** Iterate over the path: a row with ink 2 begins a line (a dot if no other row
/// follows), a row with ink 1 continues it, a row with ink 0 ends it. The colour of a line is that
/// of its pass (of the move at its time), or derived from `error_mm`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Timeline {
    /// The version of this format: 1. A page refuses unknown versions.
    pub version: u32,
    /// The duration of the drawing.
    pub duration_s: f64,
    /// The sampling interval; `path` contains only the necessary samples.
    pub tick_s: f64,
    /// The bounds of the path: minimum and maximum of X, Y and Z.
    pub bounds_mm: [[f64; 2]; 3],
    /// The passes in order.
    pub passes: Vec<PassFigures>,
    /// The moves of the tool, in order.
    pub moves: Moves,
    /// The path of the tool and its ink.
    pub path: Path,
}

/// The moves of the tool, one row each.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Moves {
    /// The names of the numbers in `kind`.
    pub kinds: [&'static str; 8],
    /// The kind of move, as an index in `kinds`.
    pub kind: Vec<u8>,
    /// The pass, as an index in `passes`.
    pub pass: Vec<u32>,
    /// The stroke, from 0, counted through all passes.
    pub stroke: Vec<u32>,
    /// The start time.
    pub from_s: Vec<f64>,
}

/// The path of the tool, one row per relevant moment.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Path {
    /// The time.
    pub t_s: Vec<f64>,
    /// Forward.
    pub x_mm: Vec<f64>,
    /// To the left.
    pub y_mm: Vec<f64>,
    /// Up.
    pub z_mm: Vec<f64>,
    /// 0: no ink; 1: a line from the row before; 2: a dot, which may begin a line.
    pub ink: Vec<u8>,
    /// The distance of the ink from the wanted path; 0 without ink.
    pub error_mm: Vec<f64>,
}

impl Trace<'_> {
    /// Returns the timeline.
    #[must_use]
    pub fn timeline(&self) -> Timeline {
        let Estimate { time_s, passes, .. } = self.estimate();
        Timeline {
            version: 1,
            duration_s: rounded(time_s, MILLI),
            tick_s: TICK_S,
            bounds_mm: bounds_mm(&self.moments),
            passes: passes.into_iter().map(figures).collect(),
            moves: Moves::of(
                self.plan,
                self.ends.iter().map(|&end| self.moments[end].t_s),
            ),
            path: Path::of(thin::thin(&self.moments)),
        }
    }
}

impl Moves {
    /// Combines vectors of the same kind and stroke to moves.
    pub(crate) fn of(plan: &Plan, ends_s: impl Iterator<Item = f64>) -> Self {
        let mut moves = Self {
            kinds: KINDS,
            ..Self::default()
        };
        let (mut last, mut from_s) = (None, 0.0);
        for (vector, end_s) in plan.moves.iter().zip(ends_s) {
            let what = (vector.kind, vector.stroke);
            if last.replace(what) != Some(what) {
                moves.kind.push(vector.kind as u8);
                moves.pass.push(vector.pass);
                moves.stroke.push(vector.stroke);
                moves.from_s.push(rounded(from_s, MILLI));
            }
            from_s = end_s;
        }
        moves
    }
}

impl Path {
    pub(crate) fn of<'a>(moments: impl Iterator<Item = &'a TracePoint>) -> Self {
        let mut path = Self::default();
        for moment in moments {
            path.t_s.push(rounded(moment.t_s, MILLI));
            path.x_mm.push(rounded(moment.position.x.0, CENTI));
            path.y_mm.push(rounded(moment.position.y.0, CENTI));
            path.z_mm.push(rounded(moment.position.z.0, CENTI));
            path.error_mm.push(rounded(moment.error_mm, MILLI));
            path.ink.push(match moment.ink {
                Ink::None => 0,
                Ink::Line => 1,
                Ink::Begin => 2,
            });
        }
        path
    }
}

pub(crate) fn bounds_mm(moments: &[TracePoint]) -> [[f64; 2]; 3] {
    let axes: [fn(&TracePoint) -> f64; 3] = [
        |moment| moment.position.x.0,
        |moment| moment.position.y.0,
        |moment| moment.position.z.0,
    ];
    axes.map(|axis| {
        let along = || moments.iter().map(axis);
        let least = along().fold(f64::INFINITY, f64::min);
        let most = along().fold(f64::NEG_INFINITY, f64::max);
        [least, most].map(|mm| rounded(mm, CENTI))
    })
}

pub(crate) fn figures(pass: PassFigures) -> PassFigures {
    PassFigures {
        ink_mm: rounded(pass.ink_mm, CENTI),
        travel_mm: rounded(pass.travel_mm, CENTI),
        time_s: rounded(pass.time_s, MILLI),
        error_mm: rounded(pass.error_mm, MILLI),
        ..pass
    }
}

/// Rounds to a number of parts of one, without negative zero.
pub(crate) fn rounded(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts + 0.0
}

/// The names in the order of [`MoveKind`](dobot_plan::MoveKind).
const KINDS: [&str; 8] = [
    "travel", "lower", "draw", "lift", "run-up", "burn", "run-out", "brake",
];
pub(crate) const MILLI: f64 = 1000.0;
const CENTI: f64 = 100.0;
