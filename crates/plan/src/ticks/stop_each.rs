//! Vectors that each begin and end at rest, for an arm with unknown initial speed.

use dobot_wire::{WriteVector, single};

use crate::ArmLimits;
use crate::ticks::ticker::is_rapid;

/// Returns the vectors at `share` of their maximum speeds, at most as planned, each from rest to
/// rest. A stock arm executes their lengths to 0.02 mm with any residual speed below a tick's
/// change (note N48).
///
/// ```text
///   speed of a tick               kept from before:      each has the largest speed k + 0.45 steps:
///   k steps  |    ______             none ____           k ticks faster, k ticks slower, whatever
///            |  _/      \_         nearly one ....       is kept, so that no less than that is
///      none  |_/..........\_                             left, and never less than none
/// ```
///
/// With a maximum speed below half a step, the arm would continue at its residual speed for minutes
/// or forever (note N51), so the minimum is one step, and speeds in between are rounded down. A
/// vector in laser mode with the laser off cannot accelerate, so the one before it does not end at
/// rest. Vectors planned from rest to rest are unchanged at a share of 1.
#[must_use]
pub fn stop_each(vectors: &[WriteVector], share: f64, arm_limits: &ArmLimits) -> Vec<WriteVector> {
    let next = vectors.iter().skip(1).map(Some).chain([None]);
    let pairs = vectors.iter().zip(next);
    pairs
        .map(|(vector, next)| {
            if share >= 1.0 && rests(vector) {
                return *vector;
            }
            let wanted_mm_s = f64::from(vector.max_speed_mm_s) * share.min(1.0);
            let max_speed_mm_s = if is_rapid(vector) {
                single(wanted_mm_s)
            } else {
                single(arm_limits.rest_to_rest_mm_s(wanted_mm_s))
            };
            let continues = arm_limits.has_ticks && !is_rapid(vector) && next.is_some_and(is_rapid);
            WriteVector {
                start_speed_mm_s: 0.0,
                end_speed_mm_s: if continues { max_speed_mm_s } else { 0.0 },
                max_speed_mm_s,
                ..*vector
            }
        })
        .collect()
}

/// Whether the vector begins and ends at rest.
fn rests(vector: &WriteVector) -> bool {
    vector.start_speed_mm_s == 0.0 && vector.end_speed_mm_s == 0.0
}

#[cfg(test)]
mod tests {
    use dobot_motion::TickStroke;
    use dobot_wire::WriteMode;
    use proptest::prelude::*;

    use super::*;

    const STOCK: ArmLimits = ArmLimits {
        has_ticks: true,
        acceleration_mm_s2: 100.0,
        joint_speed_deg_s: 100.0,
        nearest_mm: 0.0,
        corner_deviation_mm: 0.1,
        link: crate::LinkRate { period_s: 0.08 },
    };

    /// Returns the executed vectors of a stock arm with this residual speed.
    fn tick_strokes(
        vectors: &[WriteVector],
        mut kept_mm_s: f32,
        arm_limits: &ArmLimits,
    ) -> Vec<TickStroke> {
        let tick_stroke = |vector: &WriteVector| {
            let factor = if is_rapid(vector) { 100.0 } else { 1.0 };
            let tick_stroke = TickStroke::of(
                vector.x_mm,
                kept_mm_s,
                vector.end_speed_mm_s,
                vector.max_speed_mm_s,
                factor * single(arm_limits.acceleration_mm_s2),
            );
            kept_mm_s = tick_stroke.end_mm_s;
            tick_stroke
        };
        vectors.iter().map(tick_stroke).collect()
    }

    #[test]
    fn the_slowest_vector_takes_seconds_for_any_residual_speed_of_a_stock_arm() {
        // 6 mm/s at 10 %. At the residual speed, 1.66 mm would take 50 * 1.66 / 0.0044 ticks: 375
        // s.
        let vector = WriteVector::by(1.664_266, 0.0, 0.0, 6.0);
        for kept_mm_s in [0.0, 5.418_604e-7, 0.004_43, 0.4, 1.9] {
            let slow = stop_each(&[vector], 0.1, &STOCK);
            let tick_stroke = tick_strokes(&slow, kept_mm_s, &STOCK)[0];
            assert!(
                (1..60).contains(&tick_stroke.ticks()),
                "{kept_mm_s}: {tick_stroke:?}"
            );
            assert!(tick_stroke.is_exact(), "{kept_mm_s}: {tick_stroke:?}");
        }
    }

    #[test]
    fn the_arm_coasts_after_a_laser_at_its_burning_speed() {
        let burn = WriteVector {
            mode: WriteMode::Laser,
            laser: true,
            start_speed_mm_s: 10.0,
            end_speed_mm_s: 10.0,
            ..WriteVector::by(5.0, 0.0, 0.0, 10.0)
        };
        let out = WriteVector {
            laser: false,
            x_mm: 0.5,
            ..burn
        };
        let tick_strokes = tick_strokes(&stop_each(&[burn, burn, out], 1.0, &STOCK), 1e-6, &STOCK);
        assert!(
            tick_strokes.iter().all(TickStroke::is_exact),
            "{tick_strokes:?}"
        );
        assert!(tick_strokes[2].ticks() <= 4, "{tick_strokes:?}");
    }

    #[test]
    fn a_vector_planned_from_rest_to_rest_is_unchanged() {
        let planned = [WriteVector::by(3.0, 1.0, 0.0, 41.0)];
        assert_eq!(stop_each(&planned, 1.0, &STOCK), planned);
    }

    #[test]
    fn an_arm_of_the_specification_moves_at_the_reported_low_speed() {
        let vector = WriteVector::by(1.6, 0.0, 0.0, 6.0);
        let slow = stop_each(&[vector], 0.1, &ArmLimits::default())[0];
        assert!((slow.max_speed_mm_s - 0.6).abs() < 1e-6, "{slow:?}");
        assert_eq!(slow.end_speed_mm_s, 0.0);
    }

    proptest! {
        #[test]
        fn a_stock_arm_ends_each_vector_at_its_place_and_soon(
            lengths_mm in prop::collection::vec(0.05..50.0_f32, 1..8),
            acceleration_mm_s2 in 20.0..200.0_f64,
            max_mm_s in 1.0..100.0_f32,
            share in 0.1..2.0_f64,
            kept in prop_oneof![0.0..0.9_f32, (-9.0..0.0_f32).prop_map(|power| 0.9 * 10.0_f32.powf(power))],
        ) {
            let arm_limits = ArmLimits { acceleration_mm_s2, ..STOCK };
            let step_mm_s = single(acceleration_mm_s2) * 0.02;
            // From the middle of a stroke.
            let vector = |length_mm: &f32| WriteVector {
                start_speed_mm_s: 1.0,
                ..WriteVector::by(*length_mm, 0.0, 0.0, max_mm_s)
            };
            let planned: Vec<_> = lengths_mm.iter().map(vector).collect();
            let vectors = stop_each(&planned, share, &arm_limits);
            for (vector, tick_stroke) in vectors.iter().zip(tick_strokes(&vectors, kept * step_mm_s, &arm_limits)) {
                // On a short vector, a residual speed remains if it exceeds a tenth of the maximum
                // speed.
                let most_ticks = 50.0 * vector.x_mm / (0.1 * step_mm_s) + 10.0;
                let off_mm = tick_stroke.length_mm() - vector.x_mm;
                prop_assert!(off_mm.abs() < 0.02, "{off_mm} mm: {vector:?}: {tick_stroke:?}");
                prop_assert!(tick_stroke.counts.iter().all(|count| *count >= 0), "{tick_stroke:?}");
                prop_assert!((1.0..=most_ticks).contains(&f32::from(tick_stroke.ticks())), "{vector:?}: {tick_stroke:?}");
            }
        }
    }
}
