//! The figures of a plan.

use crate::{MoveKind, Plan, PlannedVector};

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
    /// The least and the most that the laser burns on a millimetre of a vector, where 1 is what the
    /// burn speed gives; nothing for a pen.
    pub burn_share: Option<[f64; 2]>,
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
            burn_share: self.burn_share(),
        }
    }

    /// The laser burns for longer where it is slower.
    fn burn_share(&self) -> Option<[f64; 2]> {
        let burned = self.moves.iter().filter(|it| it.kind == MoveKind::Burn);
        burned.fold(None, |share, vector| {
            let wanted = self.burn_speed_mm_s(vector)?;
            let burned = wanted * f64::from(vector.duration_s) / vector.length_mm();
            let [least, most] = share.unwrap_or([f64::INFINITY, 0.0]);
            Some([least.min(burned), most.max(burned)])
        })
    }

    fn burn_speed_mm_s(&self, vector: &PlannedVector) -> Option<f64> {
        match self.passes[vector.pass as usize].tool {
            super::DrawingTool::Laser(laser) => Some(laser.burn_speed_mm_s),
            super::DrawingTool::Pen(_) => None,
        }
    }
}
