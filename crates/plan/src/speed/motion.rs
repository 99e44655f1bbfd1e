//! The position over time of the fastest motion along a path.

use crate::DurationEstimator;
use crate::speed::lookahead::ChainVector;
use crate::speed::speeds::{Ramps, Speeds};

/// The fastest motion along a path of vectors, from rest to rest, without link, ticks and further
/// slowing of corners.
#[derive(Clone, Debug)]
pub struct Motion {
    vectors: Vec<MovingVector>,
    duration_s: f64,
}

/// One vector in motion.
#[derive(Clone, Copy, Debug)]
struct MovingVector {
    /// The start time.
    begin_s: f64,
    /// The start distance along the path.
    begin_mm: f64,
    length_mm: f64,
    ramps: Ramps,
    /// The duration with these speeds, in s.
    duration_s: f64,
    /// The factor by which it takes longer because its corners are rounded.
    slower: f64,
}

impl Motion {
    /// Creates the motion along vectors with these increments in mm, none of them zero. Each takes
    /// at least `least_s`.
    #[must_use]
    pub fn along(
        estimator: &DurationEstimator,
        least_s: f64,
        increments: impl Iterator<Item = [f64; 3]>,
    ) -> Self {
        let cornering = estimator.cornering;
        let chain: Vec<ChainVector> = increments
            .map(|increment| ChainVector::of(increment, estimator.speed_mm_s))
            .collect();
        let mut junctions = Vec::with_capacity(chain.len() + 1);
        cornering.speeds(0.0, &chain, &mut junctions);
        let (mut begin_s, mut begin_mm) = (0.0, 0.0);
        let vectors = junctions.windows(2).zip(&chain).map(|(ends, run)| {
            let [start, end] = [0, 1].map(|i| ends[i].speed_mm_s());
            let speeds = Speeds::of(
                run.length_mm,
                [start, end, run.limit_mm_s],
                run.limit_mm_s,
                cornering.acceleration_mm_s2,
            );
            let took_s = cornering.duration_s(&ends[0], run, &ends[1]).max(least_s);
            let vector = MovingVector {
                begin_s,
                begin_mm,
                length_mm: run.length_mm,
                ramps: speeds.ramps(run.length_mm, cornering.acceleration_mm_s2),
                duration_s: speeds.duration_s,
                slower: took_s / speeds.duration_s,
            };
            begin_s += took_s;
            begin_mm += run.length_mm;
            vector
        });
        Self {
            vectors: vectors.collect(),
            duration_s: begin_s,
        }
    }

    /// Returns the total duration, in s.
    #[must_use]
    pub const fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// Returns the distance along the path at a time, in mm.
    #[must_use]
    pub fn covered_mm(&self, t_s: f64) -> f64 {
        let after = self.vectors.partition_point(|vector| vector.begin_s <= t_s);
        after.checked_sub(1).map_or(0.0, |i| {
            let vector = &self.vectors[i];
            let since_s = ((t_s - vector.begin_s) / vector.slower).min(vector.duration_s);
            let covered_mm = vector.ramps.distance_mm(since_s);
            vector.begin_mm + covered_mm.min(vector.length_mm)
        })
    }

    /// Returns the time at a distance along the path, in s.
    #[must_use]
    pub fn reached_s(&self, covered_mm: f64) -> f64 {
        let after = self
            .vectors
            .partition_point(|vector| vector.begin_mm <= covered_mm);
        after.checked_sub(1).map_or(0.0, |i| {
            let vector = &self.vectors[i];
            let along_mm = (covered_mm - vector.begin_mm).min(vector.length_mm);
            let since_s = vector.ramps.reached_s(along_mm);
            vector.begin_s + vector.slower * since_s.min(vector.duration_s)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArmLimits, DrawingTool};

    #[test]
    fn a_line_is_run_at_its_acceleration_and_speed() {
        // 40 mm at 40 mm/s and 100 mm/s2, in two vectors: 0.4 s up and 0.4 s down over 8 mm each,
        // 0.6 s between.
        let estimator = DurationEstimator::of(&ArmLimits::default(), &DrawingTool::default());
        let motion = Motion::along(
            &estimator,
            0.0,
            [[30.0, 0.0, 0.0], [10.0, 0.0, 0.0]].into_iter(),
        );
        assert!((motion.duration_s() - 1.4).abs() < 1e-9);
        let moments = [
            (0.0, 0.0),
            (0.2, 2.0),
            (0.4, 8.0),
            (0.9, 28.0),
            (1.2, 38.0),
            (1.4, 40.0),
        ];
        for (t_s, covered_mm) in moments {
            assert!((motion.covered_mm(t_s) - covered_mm).abs() < 1e-9, "{t_s}");
            assert!(
                (motion.reached_s(covered_mm) - t_s).abs() < 1e-9,
                "{covered_mm}"
            );
        }
        assert!((motion.covered_mm(9.0) - 40.0).abs() < 1e-9);
    }
}
