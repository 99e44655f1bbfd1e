//! Which sample belongs to which vector.

use dobot_arm::Position;
use dobot_plan::{Plan, PlannedVector};

use super::{Sample, StartNotReached};

/// The last sample before the arm leaves the plan's start for the first time.
pub(super) fn beginning(plan: &Plan, samples: &[Sample]) -> Result<usize, StartNotReached> {
    let [x, y, z] = plan.start;
    let start = Position::new(x, y, z);
    let away_mm = |sample: &Sample| sample.position.distance(start).0;
    let Some(came) = samples.iter().position(|it| away_mm(it) <= AT_START_MM) else {
        let nearest_mm = samples.iter().map(away_mm).fold(f64::INFINITY, f64::min);
        let start = plan.start;
        return Err(StartNotReached { start, nearest_mm });
    };
    let there = samples[came..].iter().map(away_mm);
    let there: Vec<f64> = there.take_while(|&it| it <= AT_START_MM).collect();
    let nearest_mm = there.iter().copied().fold(f64::INFINITY, f64::min);
    let stays = there.iter().rposition(|&it| it <= nearest_mm + SAME_MM);
    Ok(came + stays.unwrap_or(0))
}

/// For each vector the sample at which it is over, as far as the samples go. The first sample is
/// where the first vector begins.
///
/// Vectors are increments: each is looked for from where the one before really ended, a certain way
/// behind it, so that a path that crosses itself does not mislead.
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

/// The sample nearest to `there` of those about `length_mm` behind `from`.
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
        if driven_mm >= length_mm * 0.5 - SAME_MM && best.is_none_or(|it| away_mm < it.1 - SAME_MM)
        {
            best = Some((i, away_mm));
        }
    }
    best.filter(|it| it.1 <= length_mm * 0.2 + SPARE_MM)
        .map(|it| it.0)
}

/// A corner is met to the rounding of joints to poses.
const SAME_MM: f64 = 1e-4;
const AT_START_MM: f64 = 0.1;
/// An arm that ends its vectors in whole ticks may leave them so far off.
const SPARE_MM: f64 = 0.5;
