//! The acceleration of a motion, measured from sampled positions.

use dobot_motion::TickStroke;

use crate::path::vector::length;
use crate::speed::lookahead::ChainVector;
use crate::speed::speeds::{Ramps, Speeds};
use crate::ticks::TICK_S;

/// A chain in motion: time and position of its corners.
#[derive(Debug)]
pub(crate) struct SampledMotion<'a> {
    chain: &'a [ChainVector],
    speeds: &'a [Speeds],
    ramps: Vec<Ramps>,
    acceleration_mm_s2: f64,
    /// The start of each vector, time in s and position in mm, followed by the end of the chain.
    begins: Vec<(f64, [f64; 3])>,
}

impl<'a> SampledMotion<'a> {
    pub(crate) fn new(
        chain: &'a [ChainVector],
        speeds: &'a [Speeds],
        acceleration_mm_s2: f64,
    ) -> Self {
        let mut begins = Vec::with_capacity(chain.len() + 1);
        let (mut t_s, mut place) = (0.0, [0.0; 3]);
        begins.push((t_s, place));
        for (run, speeds) in chain.iter().zip(speeds) {
            t_s += speeds.duration_s;
            place = on(place, run, run.length_mm);
            begins.push((t_s, place));
        }
        let pairs = chain.iter().zip(speeds);
        let ramps = pairs.map(|(run, speeds)| speeds.ramps(run.length_mm, acceleration_mm_s2));
        Self {
            ramps: ramps.collect(),
            chain,
            speeds,
            acceleration_mm_s2,
            begins,
        }
    }

    /// Returns the allowed share of the sampled acceleration at the corner after each vector; 1
    /// unless the share is below `least`.
    ///
    /// Only corners within the sampling window of a changed vector are examined.
    pub(crate) fn shares(&self, least: f64, changed: &[bool]) -> Vec<f64> {
        let mut shares = vec![1.0_f64; self.chain.len()];
        let allowed_mm = sampled_limit_mm(self.acceleration_mm_s2);
        let most_mm2 = (allowed_mm / least).powi(2);
        for corner in self.corners_near(changed) {
            let at_s = self.begins[corner].0;
            for share_of_window in AROUND {
                let t_s = at_s + share_of_window * WINDOW_S;
                let moments = [-WINDOW_S, 0.0, WINDOW_S];
                let [before, now, after] = moments.map(|moment_s| self.at(t_s + moment_s, corner));
                let turned_mm2 = squared(change(before, now, after));
                // Compare squares first: most samples are within the limit and need no root.
                if turned_mm2 > most_mm2 {
                    let seen = &mut shares[self.nearest(t_s, corner) - 1];
                    *seen = seen.min(allowed_mm / turned_mm2.sqrt());
                }
            }
        }
        shares
    }

    /// Returns the corners within the sampling window of a changed vector.
    fn corners_near(&self, changed: &[bool]) -> impl Iterator<Item = usize> {
        let mut near = vec![false; self.chain.len()];
        for vector in (0..near.len()).filter(|&vector| changed[vector]) {
            let [from_s, to_s] = [self.begins[vector].0, self.begins[vector + 1].0];
            let from = self
                .begins
                .partition_point(|begin| begin.0 < from_s - AROUND_S);
            let to = self
                .begins
                .partition_point(|begin| begin.0 <= to_s + AROUND_S);
            near[from.max(1)..to.min(self.chain.len())].fill(true);
        }
        near.into_iter()
            .enumerate()
            .filter(|corner| corner.1)
            .map(|corner| corner.0)
    }

    /// Returns the tool position at a time close to a corner. Before the chain the tool moves
    /// straight, after it the tool rests.
    fn at(&self, t_s: f64, near: usize) -> [f64; 3] {
        let last = self.chain.len() - 1;
        let mut i = near.min(last);
        while i > 0 && self.begins[i].0 > t_s {
            i -= 1;
        }
        while i < last && self.begins[i + 1].0 <= t_s {
            i += 1;
        }
        let (begin_s, place) = self.begins[i];
        let (run, speeds) = (&self.chain[i], &self.speeds[i]);
        let since_s = t_s - begin_s;
        let covered_mm = if since_s < 0.0 {
            since_s * speeds.start_mm_s
        } else if since_s >= speeds.duration_s {
            run.length_mm
        } else {
            self.ramps[i].distance_mm(since_s)
        };
        on(place, run, covered_mm)
    }

    /// Returns the corner closest in time.
    fn nearest(&self, t_s: f64, near: usize) -> usize {
        let corners = 1..self.chain.len();
        let away_s = |corner: usize| (self.begins[corner].0 - t_s).abs();
        let mut nearest = near;
        while corners.contains(&(nearest - 1)) && away_s(nearest - 1) < away_s(nearest) {
            nearest -= 1;
        }
        while corners.contains(&(nearest + 1)) && away_s(nearest + 1) < away_s(nearest) {
            nearest += 1;
        }
        nearest
    }
}

/// A chain in ticks: the tool position at each tick.
#[derive(Debug)]
pub(crate) struct TickPositions {
    /// The positions, in mm from the start.
    places: Vec<[f64; 3]>,
    /// The tick at which each vector ends.
    ends: Vec<usize>,
}

impl Default for TickPositions {
    fn default() -> Self {
        Self {
            places: vec![[0.0; 3]],
            ends: Vec::new(),
        }
    }
}

impl TickPositions {
    /// Appends a vector as executed by the arm.
    pub(crate) fn push(&mut self, run: &ChainVector, tick_stroke: &TickStroke) {
        let begin = self.places[self.places.len() - 1];
        self.places
            .extend(at_ticks(begin, run.direction, tick_stroke));
        self.ends.push(self.places.len() - 1);
    }

    /// Returns the shares as in [`SampledMotion::shares`]. The tool rests before and after the
    /// chain.
    pub(crate) fn shares(&self, acceleration_mm_s2: f64, least: f64) -> Vec<f64> {
        let mut shares = vec![1.0_f64; self.ends.len()];
        let allowed_mm = sampled_limit_mm(acceleration_mm_s2);
        let last = self.places.len() - 1;
        let corners = self.ends.split_last().map_or(&[][..], |split| split.1);
        let mut corner = 0;
        for tick in (0..=last).take_while(|_| !corners.is_empty()) {
            let away = |corner: usize| corners.get(corner).map(|end| end.abs_diff(tick));
            if away(corner + 1).is_some_and(|next| Some(next) <= away(corner)) {
                corner += 1;
            }
            let before = self.places[tick.saturating_sub(WINDOW_TICKS)];
            let after = self.places[(tick + WINDOW_TICKS).min(last)];
            let share = allowed_mm / second_difference(before, self.places[tick], after);
            if share < least {
                shares[corner] = shares[corner].min(share);
            }
        }
        shares
    }
}

/// Returns the tool position at each tick of a vector from a start and a direction.
pub(crate) fn at_ticks(
    begin: [f64; 3],
    direction: [f64; 3],
    tick_stroke: &TickStroke,
) -> impl Iterator<Item = [f64; 3]> {
    tick_stroke
        .speeds_mm_s()
        .scan(0.0, move |covered_mm, speed_mm_s| {
            *covered_mm += f64::from(speed_mm_s * TICK_S);
            Some([0, 1, 2].map(|i| begin[i] + *covered_mm * direction[i]))
        })
}

/// Returns the second difference of positions one window apart at this acceleration, in mm.
pub(crate) fn sampled_limit_mm(acceleration_mm_s2: f64) -> f64 {
    acceleration_mm_s2 * WINDOW_S * WINDOW_S
}

pub(crate) fn second_difference(before: [f64; 3], now: [f64; 3], after: [f64; 3]) -> f64 {
    length(change(before, now, after))
}

fn change(before: [f64; 3], now: [f64; 3], after: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| before[i] - 2.0 * now[i] + after[i])
}

fn squared([x, y, z]: [f64; 3]) -> f64 {
    x * x + y * y + z * z
}

fn on(place: [f64; 3], run: &ChainVector, way_mm: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| place[i] + way_mm * run.direction[i])
}

/// The sampling window: the status period of a stock arm.
pub(crate) const WINDOW_S: f64 = 0.08;
/// The sampling times around a corner, in windows.
const AROUND: [f64; 11] = [
    -0.9, -0.8, -0.65, -0.45, -0.25, 0.0, 0.25, 0.45, 0.65, 0.8, 0.9,
];
/// The maximum time between a corner and a vector sampled together with it: the sampling range
/// above plus one window.
const AROUND_S: f64 = 2.0 * WINDOW_S;
/// The sampling window in ticks.
pub(crate) const WINDOW_TICKS: usize = 4;
