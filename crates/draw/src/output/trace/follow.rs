//! Assignment of samples to vectors.

use dobot_arm::Position;
use dobot_plan::{Plan, PlannedVector};

use super::{Sample, StartNotReached};

/// Returns the last sample before the arm first leaves the start of the plan.
pub(super) fn beginning(plan: &Plan, samples: &[Sample]) -> Result<usize, StartNotReached> {
    let [x, y, z] = plan.start;
    let start = Position::new(x, y, z);
    let away_mm = |sample: &Sample| sample.position.distance(start).0;
    let Some(arrived) = samples
        .iter()
        .position(|sample| away_mm(sample) <= AT_START_MM)
    else {
        let nearest_mm = samples.iter().map(away_mm).fold(f64::INFINITY, f64::min);
        let start = plan.start;
        return Err(StartNotReached { start, nearest_mm });
    };
    let there = samples[arrived..].iter().map(away_mm);
    let there: Vec<f64> = there.take_while(|&mm| mm <= AT_START_MM).collect();
    let nearest_mm = there.iter().copied().fold(f64::INFINITY, f64::min);
    let stays = there.iter().rposition(|&mm| mm <= nearest_mm + SAME_MM);
    Ok(arrived + stays.unwrap_or(0))
}

/// Returns the sample at which each vector ends, as far as the samples go. The first sample is the
/// start of the first vector.
///
/// Vectors are increments: each end is searched for from the actual end of the one before, at about
/// the right distance along the path, so that self-intersections do not mislead.
pub(super) fn ends(plan: &Plan, samples: &[Sample]) -> Vec<usize> {
    let mut here = 0;
    let end = |vector: &PlannedVector| {
        let [x, y, z] = vector.increments();
        let there = samples[here].position + Position::new(x, y, z);
        here = end_of(samples, here, there, vector.length_mm())?;
        Some(here)
    };
    plan.moves.iter().map_while(end).collect()
}

/// Returns the sample closest to `there` among those about `length_mm` after `from`.
fn end_of(samples: &[Sample], from: usize, there: Position, length_mm: f64) -> Option<usize> {
    let mut driven_mm = 0.0;
    let mut best: Option<(usize, f64)> = None;
    let mut before = samples[from].position;
    for (i, sample) in samples.iter().enumerate().skip(from) {
        driven_mm += before.distance(sample.position).0;
        before = sample.position;
        if driven_mm > length_mm * 1.5 + SPARE_MM {
            break;
        }
        let away_mm = sample.position.distance(there).0;
        if driven_mm >= length_mm * 0.5 - SAME_MM
            && best.is_none_or(|best| away_mm < best.1 - SAME_MM)
        {
            best = Some((i, away_mm));
        }
    }
    best.filter(|best| best.1 <= length_mm * 0.2 + SPARE_MM)
        .map(|best| best.0)
}

/// Corners match within the rounding from joints to poses.
const SAME_MM: f64 = 1e-4;
const AT_START_MM: f64 = 0.1;
/// An arm that ends its vectors in whole ticks may miss their ends by this distance.
const SPARE_MM: f64 = 0.5;
