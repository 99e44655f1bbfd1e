//! Ramps: lines and arcs that also move along Z.

use super::machine::{Move, MoveKind};
use crate::arc::{Arc, SAME_MM};

/// The parts of a move above and below the paper, in order. Each has the height of its middle.
///
/// ```text
///   from \
///   ------\------  paper_mm
///          \  to
/// ```
///
/// Rapid moves are whole: their path is not defined. So are upright arcs.
pub(super) fn parts(motion: &Move, paper_mm: f64) -> [Option<Move>; 2] {
    let (Some(from_mm), Some(to_mm)) = (motion.from_z_mm, motion.z_mm) else {
        return [Some(*motion), None];
    };
    let is_upright = matches!(motion.kind, MoveKind::UprightArc { .. });
    if !motion.is_line() || is_upright || from_mm == to_mm {
        return [Some(*motion), None];
    }
    let share = (paper_mm - from_mm) / (to_mm - from_mm);
    let middle_mm = |a: f64, b: f64| Some(f64::midpoint(a, b));
    let length_mm = motion.from.distance(motion.to);
    let is_cut = share * length_mm > SAME_MM && (1.0 - share) * length_mm > SAME_MM;
    let mut first = *motion;
    first.z_mm = middle_mm(from_mm, to_mm);
    if !is_cut {
        return [Some(first), None];
    }
    let mut second = first;
    (first.z_mm, second.z_mm) = (middle_mm(from_mm, paper_mm), middle_mm(paper_mm, to_mm));
    let through = match motion.kind {
        MoveKind::Arc { center, sweep_rad } => {
            let part = |share: f64| MoveKind::Arc {
                center,
                sweep_rad: sweep_rad * share,
            };
            (first.kind, second.kind) = (part(share), part(1.0 - share));
            Arc::between(center, motion.from, sweep_rad, motion.to).at(share)
        }
        _ => motion.from.lerp(motion.to, share),
    };
    (first.to, second.from) = (through, through);
    [Some(first), Some(second)]
}
