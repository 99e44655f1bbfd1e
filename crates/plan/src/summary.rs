//! Statistics of a plan.

use crate::{MoveKind, Plan};

/// Statistics of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Summary {
    /// The number of strokes, counting repetitions.
    pub strokes: usize,
    /// The number of vectors, which is the number of packets.
    pub vectors: usize,
    /// The length drawn or burned, in mm.
    pub drawn_mm: f64,
    /// The length travelled between strokes, in mm.
    pub travelled_mm: f64,
    /// The duration, in seconds.
    pub duration_s: f64,
}

impl Plan {
    /// Returns the statistics of the plan.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let total = |which: fn(MoveKind) -> bool| {
            let vectors = self.moves.iter().filter(|vector| which(vector.kind));
            vectors.fold(0.0, |sum, vector| sum + vector.length_mm())
        };
        Summary {
            strokes: self
                .moves
                .last()
                .map_or(0, |vector| vector.stroke as usize + 1),
            vectors: self.moves.len(),
            drawn_mm: total(MoveKind::marks),
            travelled_mm: total(|kind| matches!(kind, MoveKind::Travel)),
            duration_s: self.duration_s(),
        }
    }
}
