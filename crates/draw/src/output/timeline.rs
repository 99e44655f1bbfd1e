//! A drawing to look at before it is made: what a page needs to show any moment of it.

mod thin;

use dobot_arm::TICK_S;
use dobot_plan::Plan;
use schemars::JsonSchema;
use serde::Serialize;

use crate::output::estimate::{Estimate, PassFigures};
use crate::output::trace::{Ink, Trace, TracePoint};

/// A drawing in time, for a page that lets a person go to any moment of it.
///
/// All numbers are millimetres in the base frame (X forward, Y to the left, Z up) and seconds from
/// the beginning. Tables are columns of one length, which is far smaller than rows with names.
///
/// **What is at time `t`.** The path is straight from row to row, at even speed. Find the last row
/// `i` with `path.t_s[i] <= t` (binary search, the column rises or stays) and go the share
/// `(t - t_s[i]) / (t_s[i + 1] - t_s[i])` of the way to row `i + 1`; at the last row the drawing is
/// over. The tool is never farther than 0.05 mm from there. On the paper are all lines up to row
/// `i`, and the piece from row `i` to the tool if row `i + 1` has ink 1. The pen or the laser leaves
/// ink just then if row `i + 1` has ink 1.
///
/// **Which move is it.** Find the last row of `moves` with `from_s <= t`, in the same way: it ends
/// where the next one begins, the last one at `duration_s`.
///
/// **What to draw.** Go through the path: a row with ink 2 begins a line (it is a dot, if none
/// follows), a row with ink 1 goes on with it, a row with ink 0 ends it. The colour of a line is
/// that of its pass (of the move at its time), or comes from `error_mm`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Timeline {
    /// What this looks like: 1. A page refuses what it does not know.
    pub version: u32,
    /// How long the drawing takes.
    pub duration_s: f64,
    /// How often the arm was looked at; only what is needed is kept in `path`.
    pub tick_s: f64,
    /// What holds all of the path: the least and the most of X, Y and Z.
    pub bounds_mm: [[f64; 2]; 3],
    /// The passes in their order.
    pub passes: Vec<PassFigures>,
    /// What the tool does, one after the other.
    pub moves: Moves,
    /// Where the tool is, and what it leaves.
    pub path: Path,
}

/// What the tool does, one row for each.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Moves {
    /// What the numbers in `kind` mean.
    pub kinds: [&'static str; 8],
    /// What it does, as an index in `kinds`.
    pub kind: Vec<u8>,
    /// In which pass, as an index in `passes`.
    pub pass: Vec<u32>,
    /// For which stroke, from 0, counted through all passes.
    pub stroke: Vec<u32>,
    /// When it begins.
    pub from_s: Vec<f64>,
}

/// Where the tool is, one row for each moment that matters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Path {
    /// When.
    pub t_s: Vec<f64>,
    /// Forward.
    pub x_mm: Vec<f64>,
    /// To the left.
    pub y_mm: Vec<f64>,
    /// Up.
    pub z_mm: Vec<f64>,
    /// 0: no ink; 1: a line from the row before to here; 2: a dot, with which a line may begin.
    pub ink: Vec<u8>,
    /// How far the ink here lies from the wanted path; 0 where there is none.
    pub error_mm: Vec<f64>,
}

impl Trace<'_> {
    /// The drawing in time.
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
    /// Vectors of the same kind and stroke are one move.
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
        |it| it.position.x.0,
        |it| it.position.y.0,
        |it| it.position.z.0,
    ];
    axes.map(|axis| {
        let along = || moments.iter().map(axis);
        let least = along().fold(f64::INFINITY, f64::min);
        let most = along().fold(f64::NEG_INFINITY, f64::max);
        [least, most].map(|it| rounded(it, CENTI))
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

/// To so many parts of one; never the zero with a minus.
pub(crate) fn rounded(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts + 0.0
}

/// In the order of [`MoveKind`](dobot_plan::MoveKind).
const KINDS: [&str; 8] = [
    "travel", "lower", "draw", "lift", "run-up", "burn", "run-out", "brake",
];
pub(crate) const MILLI: f64 = 1000.0;
const CENTI: f64 = 100.0;
