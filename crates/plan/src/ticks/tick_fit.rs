//! Speeds for a stock arm, which divides each vector into whole ticks (note N48).

use dobot_motion::TickStroke;
use dobot_wire::single;

use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::TICK_S;

/// Returns the tick count to try; [`TickStroke`] computes the actual one.
#[expect(
    clippy::cast_possible_truncation,
    reason = "what is too large is found untrue"
)]
fn count(value: f32) -> i16 {
    if value.is_finite() { value as i16 } else { 0 }
}

/// The target of a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickTarget {
    pub length_mm: f32,
    pub speeds: Speeds,
    /// The target duration in ticks, corrected by the errors of the vectors before.
    pub ticks: f64,
    /// The minimum number of ticks for the link.
    pub least_ticks: i16,
    /// Whether the arm rests afterwards.
    pub rests: bool,
    pub acceleration_mm_s2: f32,
    /// Possible other stored speeds, in mm/s, if it is unknown.
    pub possible_mm_s: Option<[f32; 3]>,
    pub wish: TickPreference,
}

/// The preferences for the ticks of a vector, independent of its length and speeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickPreference {
    pub objective: Objective,
    /// The weight of end speeds above the target.
    pub over: f64,
    /// The maximum speed in the packet, in mm/s.
    pub most_mm_s: f32,
    /// The minimum for that speed, in mm/s.
    pub least_mm_s: f32,
    /// The difference of end speeds, as a share of a tick's change, below which they are equal.
    pub same_share: f32,
}

/// The end speed and maximum speed in the packet, and the resulting execution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickFit {
    pub end_mm_s: f32,
    pub max_mm_s: f32,
    pub tick_stroke: TickStroke,
    pub cost: f64,
    /// The cost of accelerating to the target speed again afterwards.
    pub recovery: f64,
    /// Possible other speeds left, in mm/s, if it is unknown.
    pub possible_mm_s: Option<[f32; 3]>,
}

impl TickFit {
    /// Inserts the fit into a list, best first, if it is among the best and leaves a different
    /// speed.
    fn rank(self, fits: &mut Vec<Self>, same_share: f32) {
        let cost = self.cost + self.recovery;
        let place = fits.partition_point(|other| other.cost + other.recovery <= cost);
        if place == MAX_FITS
            || fits[..place]
                .iter()
                .any(|other| other.leaves_same_speed(&self, same_share))
        {
            return;
        }
        fits.insert(place, self);
        let mut i = place + 1;
        while i < fits.len() {
            if i == MAX_FITS || fits[i].leaves_same_speed(&self, same_share) {
                fits.remove(i);
            } else {
                i += 1;
            }
        }
    }

    /// Returns the number of ticks.
    pub(crate) fn ticks(&self) -> u32 {
        u32::from(self.tick_stroke.ticks().unsigned_abs())
    }

    /// Returns the duration, in s.
    pub(crate) fn duration_s(&self) -> f64 {
        f64::from(self.tick_stroke.ticks()) * f64::from(TICK_S)
    }

    /// Whether both fits are equal for the next vector.
    fn leaves_same_speed(&self, other: &Self, same_share: f32) -> bool {
        let apart_mm_s = (self.tick_stroke.end_mm_s - other.tick_stroke.end_mm_s).abs();
        self.ticks() == other.ticks() && apart_mm_s < same_share * self.tick_stroke.change_mm_s
    }
}

impl TickTarget {
    /// Returns the speeds closest to the target after a stored speed, followed by worse ones that
    /// leave different speeds to the next vector, best first.
    ///
    /// The controller computes tick counts from an end speed and a maximum speed. Therefore counts
    /// close to the target are tried, each with the two speeds that should produce it, and the
    /// actual execution is computed as in the controller.
    pub(crate) fn fits(&self, stored_mm_s: f32) -> Vec<TickFit> {
        let mut fits = Vec::with_capacity(MAX_FITS + 1);
        self.try_slower(stored_mm_s, &mut fits);
        self.try_faster(stored_mm_s, &mut fits);
        if self.rests && fits.first().is_none_or(|fit| self.creeps(fit)) {
            // At a rest the next vector may arrive late.
            let soon = Self {
                least_ticks: 1,
                ..*self
            };
            soon.try_slower(stored_mm_s, &mut fits);
            soon.try_faster(stored_mm_s, &mut fits);
        }
        if fits.is_empty() {
            fits.push(self.crawl(stored_mm_s));
        }
        fits
    }

    /// Whether the fit takes far too long, because no tick counts match the link's minimum closely.
    fn creeps(&self, fit: &TickFit) -> bool {
        f64::from(fit.tick_stroke.ticks()) > 2.0 * self.ticks.max(self.least_ticks.into())
    }

    /// Tries fits without accelerating ticks: the initial speed is free, up to the stored speed
    /// plus one step.
    fn try_slower(&self, stored_mm_s: f32, fits: &mut Vec<TickFit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let wanted = self.ticks.max(f64::from(self.least_ticks));
        if wanted > MAX_TICKS {
            return;
        }
        let about = count(single(wanted));
        for ticks in (about - 1).max(1).max(self.least_ticks)..=(about + 2).max(self.least_ticks) {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks);
            if even_mm_s > stored_mm_s + change {
                continue;
            }
            // Rounding in the controller may shift the count, so neighbouring counts are tried too.
            let about = self.slowing(ticks, change);
            for down in (about - 2).max(0)..=(about + 2).min(ticks) {
                let downs = f32::from(down);
                let sum = change * downs * (downs + 1.0) / 2.0;
                let begin = (50.0 * self.length_mm + sum) / f32::from(ticks) * (1.0 - SPARE);
                let max = begin.min(stored_mm_s);
                self.consider(stored_mm_s, max - (downs - NEAR) * change, max, fits);
            }
        }
    }

    /// Returns the number of decelerating ticks at the end if the vector has this many ticks, ends
    /// at the target speed, and does not accelerate.
    ///
    /// All n ticks together cover `50 L = n b - c d (d + 1) / 2`, with the initial speed b, a
    /// change c for each of d decelerating ticks, and the end speed `b - c d`: a quadratic equation
    /// for d.
    fn slowing(&self, ticks: i16, change: f32) -> i16 {
        let twice = 2.0 * f32::from(ticks) - 1.0;
        let faster = 50.0 * self.length_mm - f32::from(ticks) * single(self.speeds.end_mm_s);
        let root = (twice * twice - 8.0 * faster / change).max(0.0).sqrt();
        count((0.5 * (twice - root)).clamp(0.0, f32::from(ticks)))
    }

    /// Tries fits with accelerating ticks, from the stored speed.
    fn try_faster(&self, stored_mm_s: f32, fits: &mut Vec<TickFit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let [peak, end] = [self.speeds.peak_mm_s, self.speeds.end_mm_s].map(single);
        let up = count(((peak - stored_mm_s) / change).clamp(0.0, 3000.0));
        let down = count(((peak - end) / change).clamp(0.0, 3000.0));
        // Before a rest the end speed is 0, whatever counts are intended.
        let downs = if self.rests {
            down..=down
        } else {
            (down - 3).max(0)..=down + 2
        };
        let slower = match (self.rests, self.wish.over > 1.0) {
            (true, _) => 4,
            (false, true) => 8,
            (false, false) => 3,
        };
        let fewest = (up - slower).max(1);
        for up in fewest..=up + 2 {
            for down in downs.clone() {
                for near in if self.rests { &NEARS[..] } else { &[NEAR] } {
                    let max = stored_mm_s + (f32::from(up) - near) * change;
                    let end = max - (f32::from(down) - NEAR) * change;
                    self.consider(stored_mm_s, end, max, fits);
                }
            }
        }
    }

    fn consider(&self, stored_mm_s: f32, end_mm_s: f32, max_mm_s: f32, fits: &mut Vec<TickFit>) {
        let slow_mm_s = max_mm_s.min(self.wish.most_mm_s);
        let end_mm_s = if self.rests {
            0.0
        } else {
            end_mm_s.min(slow_mm_s).max(MIN_END_MM_S)
        };
        // Such a vector could not end above the least end speed.
        if slow_mm_s < MIN_END_MM_S {
            return;
        }
        let max_mm_s = slow_mm_s.max(self.wish.least_mm_s);
        let tick_stroke = self.tick_stroke(stored_mm_s, end_mm_s, max_mm_s);
        let creeps = !self.rests && tick_stroke.end_mm_s < MIN_LEFT_MM_S;
        // The processor counts in 16 bits and misinterprets larger values (note N51); the corrected
        // speed must not be used for this check.
        let even_mm_s = tick_stroke.top_mm_s - tick_stroke.correction_mm_s;
        let is_endless =
            tick_stroke.counts[1] > 0 && 50.0 * self.length_mm >= f32::from(i16::MAX) * even_mm_s;
        if !tick_stroke.is_exact() || tick_stroke.ticks() < self.least_ticks || creeps || is_endless
        {
            return;
        }
        let possible_mm_s = self.possible_ends_mm_s(end_mm_s, max_mm_s, &tick_stroke);
        let apart_mm_s = |mm_s: &f32| (mm_s - tick_stroke.end_mm_s).abs();
        let unsure_mm_s = possible_mm_s.iter().flatten().map(apart_mm_s);
        // An unknown initial speed carries over to all later vectors, so certainty is worth many
        // ticks.
        let unsure = UNSURE * f64::from(unsure_mm_s.fold(0.0, f32::max) / tick_stroke.change_mm_s);
        let cost = self.cost(stored_mm_s, &tick_stroke) + self.slow_burn_cost(slow_mm_s) + unsure;
        let fit = TickFit {
            end_mm_s,
            max_mm_s,
            tick_stroke,
            cost,
            recovery: self.recovery(&tick_stroke),
            possible_mm_s,
        };
        fit.rank(fits, self.wish.same_share);
    }

    fn cost(&self, stored_mm_s: f32, tick_stroke: &TickStroke) -> f64 {
        let steps = |mm_s: f64| mm_s / f64::from(tick_stroke.change_mm_s);
        let over = steps(f64::from(tick_stroke.end_mm_s) - self.speeds.end_mm_s);
        let above = steps(f64::from(tick_stroke.top_mm_s) - self.speeds.limit_mm_s).max(0.0);
        match self.wish.objective {
            Objective::Even => self.deviation(stored_mm_s, tick_stroke, over) + 4.0 * above * above,
            Objective::Fast => {
                let kept = if self.rests {
                    OVER_AT_REST * (over - FREE_AT_REST_STEPS).max(0.0).powi(3)
                } else {
                    OVER * (over - FREE_STEPS).max(0.0).powi(2) + LESS * over.max(0.0)
                };
                f64::from(tick_stroke.ticks()) + self.wish.over * kept + ABOVE * above * above
            }
        }
    }

    /// Returns the cost of burning slower than is safe, unless that is requested.
    fn slow_burn_cost(&self, max_mm_s: f32) -> f64 {
        let is_wanted = self.wish.objective == Objective::Fast
            || self.speeds.peak_mm_s < f64::from(SAFE_BURN_MM_S);
        if is_wanted || max_mm_s >= SAFE_BURN_MM_S {
            0.0
        } else {
            SLOW_BURN_COST
        }
    }

    /// Returns the squared deviation from the target, in steps of speed: being too fast counts more
    /// than being too slow.
    fn deviation(&self, stored_mm_s: f32, tick_stroke: &TickStroke, over: f64) -> f64 {
        let late = f64::from(tick_stroke.ticks()) - self.ticks;
        let brakes = tick_stroke.counts[0] == 0 && tick_stroke.counts[1] == 0;
        let first = tick_stroke.first_mm_s - if brakes { tick_stroke.change_mm_s } else { 0.0 };
        let jump = f64::from((first - stored_mm_s) / tick_stroke.change_mm_s).abs();
        let jump = (jump - 1.0).max(0.0);
        let weight = if over > 0.0 {
            8.0 * self.wish.over
        } else {
            0.5
        };
        late * late + weight * over * over + 2.0 * jump * jump
    }

    /// Returns the ticks lost until the arm has the target speed v again, with full acceleration:
    /// `(v - end)2 / (2 a v)`.
    fn recovery(&self, tick_stroke: &TickStroke) -> f64 {
        if self.wish.objective == Objective::Even || self.rests {
            return 0.0;
        }
        let wanted_mm_s = self.speeds.end_mm_s;
        let missing_mm_s = (wanted_mm_s - f64::from(tick_stroke.end_mm_s)).max(0.0);
        missing_mm_s * missing_mm_s
            / (2.0 * f64::from(tick_stroke.change_mm_s) * wanted_mm_s.max(1.0))
    }

    /// Returns the fastest constant speed with which the vector has its full length, if no other
    /// speeds do; failing that, whatever the arm makes of the maximum speed.
    fn crawl(&self, stored_mm_s: f32) -> TickFit {
        let change = self.acceleration_mm_s2 * TICK_S;
        let mut fits = Vec::new();
        for ticks in self.least_ticks.max(1)..i16::MAX {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks) * (1.0 - SPARE);
            for max in [
                even_mm_s.min(stored_mm_s.max(MIN_END_MM_S)),
                even_mm_s + 0.49 * change,
            ] {
                self.consider(stored_mm_s, max, max, &mut fits);
            }
            if let Some(&fit) = fits.first() {
                return fit;
            }
        }
        // With less than half a step the arm would keep its speed forever.
        let max_mm_s = single(self.speeds.limit_mm_s).max(1.5 * change);
        let max_mm_s = max_mm_s.clamp(self.wish.least_mm_s, self.wish.most_mm_s);
        let tick_stroke = self.tick_stroke(stored_mm_s, 0.0, max_mm_s);
        TickFit {
            end_mm_s: 0.0,
            max_mm_s,
            tick_stroke,
            cost: f64::INFINITY,
            recovery: 0.0,
            possible_mm_s: self.possible_ends_mm_s(0.0, max_mm_s, &tick_stroke),
        }
    }

    /// Returns the possible speeds left by the vector if its initial speed is unknown; `None` if
    /// they all agree.
    fn possible_ends_mm_s(
        &self,
        end_mm_s: f32,
        max_mm_s: f32,
        tick_stroke: &TickStroke,
    ) -> Option<[f32; 3]> {
        let possible = |stored_mm_s| self.tick_stroke(stored_mm_s, end_mm_s, max_mm_s);
        let ends_mm_s = self.possible_mm_s?.map(|mm_s| possible(mm_s).end_mm_s);
        let is_same = |mm_s: &f32| (mm_s - tick_stroke.end_mm_s).abs() <= KNOWN_MM_S;
        (!ends_mm_s.iter().all(is_same)).then_some(ends_mm_s)
    }

    /// Returns the execution with these speeds.
    fn tick_stroke(&self, stored_mm_s: f32, end_mm_s: f32, max_mm_s: f32) -> TickStroke {
        let (length_mm, acceleration_mm_s2) = (self.length_mm, self.acceleration_mm_s2);
        TickStroke::of(
            length_mm,
            stored_mm_s,
            end_mm_s,
            max_mm_s,
            acceleration_mm_s2,
        )
    }
}

/// The share by which initial speeds are lowered and corrections limited, for rounding.
const SPARE: f32 = 1e-5;
/// The position of packet speeds within a step, so that they round to the intended counts.
pub(crate) const NEAR: f32 = 0.4;
/// The steps by which a vector may end above the target without cost; the sampled ticks show
/// whether that is too fast.
const FREE_STEPS: f64 = 1.0;
/// The cost in ticks of one more step above that; squared.
const OVER: f64 = 0.3;
/// The cost in ticks of each step above the target, even below that.
const LESS: f64 = 0.1;
/// The free steps before a rest, where the residual speed immediately enters the next vector, in
/// another direction, and its correction adds to it.
const FREE_AT_REST_STEPS: f64 = 0.3;
/// The cost in ticks of one more residual step there; cubed, because the next vector corrects
/// anything up to half a step.
const OVER_AT_REST: f64 = 26.0;
/// The cost in ticks of a step of the top speed above the limit; squared.
const ABOVE: f64 = 2.0;
/// A slower laser may set things on fire: the policy's default minimum and a margin.
const SAFE_BURN_MM_S: f32 = 1.001;
/// The policy's default minimum for the maximum speed of a burning vector, in mm/s.
pub const MIN_BURN_MM_S: f32 = 1.0;
/// Exceeds every other cost: a vector takes up to [`MAX_TICKS`], and lateness counts squared.
const SLOW_BURN_COST: f64 = 1e10;
/// The cost, in squared ticks, of a step of uncertainty in the next vector's initial speed.
const UNSURE: f64 = 10_000.0;
/// The deviation below which a speed counts as known, in mm/s.
const KNOWN_MM_S: f32 = 0.04;
/// The limit of a stock arm's counter (note N51).
const MAX_TICKS: f64 = 32_000.0;
/// The maximum number of fits returned.
pub(crate) const MAX_FITS: usize = 30;
/// The positions of the maximum speed within a step before a rest: it determines the number of
/// ticks that decelerate to 0.
const NEARS: [f32; 4] = [-0.4, 0.0, 0.2, 0.4];
/// The minimum end speed of a vector that does not rest, in mm/s: 0 means a rest.
pub(crate) const MIN_END_MM_S: f32 = 0.01;
/// The minimum speed left to the next vector, in mm/s: after a laser it would creep (note N48).
pub(crate) const MIN_LEFT_MM_S: f32 = 0.1;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn target(length_mm: f32, [start, end, max]: [f64; 3], rests: bool) -> TickTarget {
        let end = if rests { 0.0 } else { end };
        let speeds = Speeds::of(length_mm.into(), [start, end, max], max, 100.0);
        TickTarget {
            length_mm,
            speeds,
            ticks: speeds.duration_s / f64::from(TICK_S),
            least_ticks: 1,
            rests,
            acceleration_mm_s2: 100.0,
            possible_mm_s: None,
            wish: TickPreference {
                objective: Objective::Fast,
                over: 1.0,
                most_mm_s: single(max),
                least_mm_s: 0.0,
                same_share: 0.25,
            },
        }
    }

    #[test]
    fn an_arm_that_brakes_for_a_corner_may_first_continue_and_then_brake() {
        // From 40 mm/s with 2 mm/s less each tick: 13 ticks at b and 18 that brake cover 15.9 mm =
        // (31 b - 18 * 19) / 50 with b = 36.7 mm/s, which leaves 0.7 mm/s.
        let wanted = target(15.9, [40.0, 0.5, 40.0], false);
        let fits = wanted.fits(40.0);
        let found = fits
            .iter()
            .find(|fit| fit.tick_stroke.counts == [0, 13, 18]);
        let left_mm_s = found.expect("among the choices").tick_stroke.end_mm_s;
        assert!((left_mm_s - 0.68).abs() < 0.01, "{left_mm_s}");
    }

    proptest! {
        #[test]
        fn every_vector_has_its_planned_length(
            length_mm in 0.012..150.0_f32,
            stored in prop_oneof![0.0..60.0_f32, (-9.0..0.0_f32).prop_map(|power| 10.0_f32.powf(power))],
            end in 0.0..60.0_f64,
            max in 0.1..80.0_f64,
            rests: bool,
        ) {
            let max = max.max(stored.into()).max(end);
            // The limit of the ticker: less cannot be reached from rest.
            let most_mm_s = single(max.max(3.0));
            let wanted = target(length_mm, [stored.into(), end, max], rests);
            let wish = TickPreference { most_mm_s, ..wanted.wish };
            let fit = TickTarget { wish, ..wanted }.fits(stored)[0];
            prop_assert!(fit.tick_stroke.is_exact(), "{fit:?}");
            prop_assert_eq!(fit.end_mm_s == 0.0, rests);
            prop_assert!(fit.max_mm_s > 0.0 && fit.max_mm_s <= most_mm_s, "{fit:?}");
            // At least the target, or a tenth of a tick's change.
            let slowest_mm_s = wanted.speeds.max_mm_s.min(0.2);
            let most_s = f64::from(length_mm) / slowest_mm_s + 2.0;
            prop_assert!(f64::from(fit.tick_stroke.ticks()) * 0.02 <= most_s, "{fit:?}");
        }

        #[test]
        fn a_vector_to_rest_does_not_creep_on_any_slow_link(
            length_mm in 0.012..10.0_f32,
            stored in (-9.0..0.0_f32).prop_map(|power| 10.0_f32.powf(power)),
            max in 0.2..80.0_f64,
            least_ticks in 1..6_i16,
            evenly: bool,
        ) {
            let max = max.max(stored.into());
            let wanted = target(length_mm, [stored.into(), 0.0, max], true);
            let objective = if evenly { Objective::Even } else { Objective::Fast };
            let wish = TickPreference { most_mm_s: single(max.max(3.0)), objective, ..wanted.wish };
            let fit = TickTarget { least_ticks, wish, ..wanted }.fits(stored)[0];
            prop_assert!(fit.tick_stroke.is_exact(), "{fit:?}");
            // Twice the target duration, and a few ticks.
            let most_s = 2.0 * f64::from(length_mm) / max.min(0.2) + 2.0;
            prop_assert!(fit.duration_s() <= most_s, "{fit:?}");
        }
    }
}
