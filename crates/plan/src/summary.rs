//! The figures of a plan.

use crate::{MoveKind, Plan};

/// The figures of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    /// How many strokes, each as often as it is drawn.
    pub strokes: usize,
    /// How many vectors, and so packets.
    pub vectors: usize,
    /// How far the pen goes down on the paper, or the laser burning, in mm.
    pub drawn_mm: f64,
    /// How far the tool goes between strokes, in mm.
    pub travelled_mm: f64,
    /// How long all of it takes, in seconds.
    pub duration_s: f64,
}

impl Plan {
    /// The figures of the plan.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let total = |which: fn(MoveKind) -> bool| {
            let vectors = self.moves.iter().filter(|it| which(it.kind));
            vectors.fold(0.0, |sum, it| sum + it.length_mm())
        };
        Summary {
            strokes: self.moves.last().map_or(0, |it| it.stroke as usize + 1),
            vectors: self.moves.len(),
            drawn_mm: total(MoveKind::marks),
            travelled_mm: total(|kind| matches!(kind, MoveKind::Travel)),
            duration_s: self.duration_s(),
        }
    }
}
