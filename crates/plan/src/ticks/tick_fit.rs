//! Speeds for a stock arm, which cuts each vector into whole ticks (note N48).

use dobot_motion::TickStroke;
use dobot_wire::single;

use crate::speed::objective::Objective;
use crate::speed::speeds::Speeds;
use crate::ticks::tick::TICK_S;

/// How many ticks to try: what the processor makes of them is told by [`TickStroke`].
#[expect(
    clippy::cast_possible_truncation,
    reason = "what is too large is found untrue"
)]
fn count(value: f32) -> i16 {
    if value.is_finite() { value as i16 } else { 0 }
}

/// What a vector should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickTarget {
    pub length_mm: f32,
    pub speeds: Speeds,
    /// How long it should take, what the vectors before were too long or too short included, in
    /// ticks.
    pub ticks: f64,
    /// How many ticks the link needs at the least.
    pub least_ticks: i16,
    /// The arm is to rest behind it.
    pub rests: bool,
    pub acceleration_mm_s2: f32,
    /// What may be stored instead, in mm/s, where that is not known.
    pub possible_mm_s: Option<[f32; 3]>,
    pub wish: TickPreference,
}

/// What is wanted of the ticks of a vector, whatever its length and its speeds are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickPreference {
    pub objective: Objective,
    /// How many times as much an end speed above the one wanted counts.
    pub over: f64,
    /// No packet may tell a larger speed, in mm/s.
    pub most_mm_s: f32,
    /// Nor a smaller one.
    pub least_mm_s: f32,
    /// End speeds with so little of a tick's change between them are the same.
    pub same_share: f32,
}

/// The end speed and the largest speed for the packet, and what becomes of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickFit {
    pub end_mm_s: f32,
    pub max_mm_s: f32,
    pub tick_stroke: TickStroke,
    pub cost: f64,
    /// What it costs to be as fast as wanted again behind it.
    pub recovery: f64,
    /// What it may leave instead, in mm/s, where that is not known.
    pub possible_mm_s: Option<[f32; 3]>,
}

impl TickFit {
    /// Puts it among others, the best first, if it is one of the best and leaves another speed.
    fn rank(self, fits: &mut Vec<Self>, same_share: f32) {
        let cost = self.cost + self.recovery;
        let place = fits.partition_point(|other| other.cost + other.recovery <= cost);
        if place == MOST_FITS
            || fits[..place]
                .iter()
                .any(|it| it.leaves_same_speed(&self, same_share))
        {
            return;
        }
        fits.insert(place, self);
        let mut i = place + 1;
        while i < fits.len() {
            if i == MOST_FITS || fits[i].leaves_same_speed(&self, same_share) {
                fits.remove(i);
            } else {
                i += 1;
            }
        }
    }

    /// How many ticks it takes.
    pub(crate) fn ticks(&self) -> u32 {
        u32::from(self.tick_stroke.ticks().unsigned_abs())
    }

    /// How long it takes, in s.
    pub(crate) fn duration_s(&self) -> f64 {
        f64::from(self.tick_stroke.ticks()) * f64::from(TICK_S)
    }

    /// Whether the next vector would not tell them from each other.
    fn leaves_same_speed(&self, other: &Self, same_share: f32) -> bool {
        let apart_mm_s = (self.tick_stroke.end_mm_s - other.tick_stroke.end_mm_s).abs();
        self.ticks() == other.ticks() && apart_mm_s < same_share * self.tick_stroke.change_mm_s
    }
}

impl TickTarget {
    /// The speeds that come nearest to the wish, behind a vector that left this speed; then those that
    /// are worse and leave another speed to the next vector, the best first.
    ///
    /// The controller takes an end speed and a largest one, and finds counts of ticks. So counts
    /// near to those wanted are tried, each with the two speeds that should lead to it; what
    /// really becomes of them is calculated as the controller does.
    pub(crate) fn fits(&self, stored_mm_s: f32) -> Vec<TickFit> {
        let mut fits = Vec::with_capacity(MOST_FITS + 1);
        self.try_slower(stored_mm_s, &mut fits);
        self.try_faster(stored_mm_s, &mut fits);
        if self.rests && fits.first().is_none_or(|it| self.creeps(it)) {
            // At a rest the next vector may come late.
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

    /// Whether it takes ever so long, since no counts of ticks take just as long as the link needs.
    fn creeps(&self, fit: &TickFit) -> bool {
        f64::from(fit.tick_stroke.ticks()) > 2.0 * self.ticks.max(self.least_ticks.into())
    }

    /// No tick accelerates: the begin speed is free, up to the one that is stored and one step.
    fn try_slower(&self, stored_mm_s: f32, fits: &mut Vec<TickFit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let wanted = self.ticks.max(f64::from(self.least_ticks));
        if wanted > MOST_TICKS {
            return;
        }
        let about = count(single(wanted));
        for ticks in (about - 1).max(1).max(self.least_ticks)..=(about + 2).max(self.least_ticks) {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks);
            if even_mm_s > stored_mm_s + change {
                continue;
            }
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

    /// How many of so many ticks slow down, the last ones, if the vector ends as fast as wanted and none accelerates.
    ///
    /// All ticks n together go `50 L = n b - c d (d + 1) / 2` with the begin speed b, a change c for each tick that slows down and d of
    /// these, and the end speed is `b - c d`: a quadratic equation for d.
    fn slowing(&self, ticks: i16, change: f32) -> i16 {
        let twice = 2.0 * f32::from(ticks) - 1.0;
        let faster = 50.0 * self.length_mm - f32::from(ticks) * single(self.speeds.end_mm_s);
        let root = (twice * twice - 8.0 * faster / change).max(0.0).sqrt();
        count((0.5 * (twice - root)).clamp(0.0, f32::from(ticks)))
    }

    /// Some ticks accelerate, from the speed that is stored.
    fn try_faster(&self, stored_mm_s: f32, fits: &mut Vec<TickFit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let [peak, end] = [self.speeds.peak_mm_s, self.speeds.end_mm_s].map(single);
        let up = count(((peak - stored_mm_s) / change).clamp(0.0, 3000.0));
        let down = count(((peak - end) / change).clamp(0.0, 3000.0));
        // Before a rest the end speed is 0, whatever the counts are meant to be.
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
            end_mm_s.min(slow_mm_s).max(LEAST_END_MM_S)
        };
        if slow_mm_s < LEAST_END_MM_S {
            return;
        }
        let max_mm_s = slow_mm_s.max(self.wish.least_mm_s);
        let tick_stroke = self.tick_stroke(stored_mm_s, end_mm_s, max_mm_s);
        let creeps = !self.rests && tick_stroke.end_mm_s < LEAST_LEFT_MM_S;
        // The processor counts in sixteen bits, and takes what is more for something else (note N51): what it corrects then
        // is no speed to count with.
        let even_mm_s = tick_stroke.top_mm_s - tick_stroke.correction_mm_s;
        let is_endless =
            tick_stroke.counts[1] > 0 && 50.0 * self.length_mm >= f32::from(i16::MAX) * even_mm_s;
        if !tick_stroke.is_exact() || tick_stroke.ticks() < self.least_ticks || creeps || is_endless
        {
            return;
        }
        let possible_mm_s = self.possible_ends_mm_s(end_mm_s, max_mm_s, &tick_stroke);
        let apart_mm_s = |it: &f32| (it - tick_stroke.end_mm_s).abs();
        let unsure_mm_s = possible_mm_s.iter().flatten().map(apart_mm_s);
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

    /// What it costs to burn slower than any laser should, where that is not wanted.
    fn slow_burn_cost(&self, max_mm_s: f32) -> f64 {
        let is_wanted = self.wish.objective == Objective::Fast
            || self.speeds.peak_mm_s < f64::from(SAFE_BURN_MM_S);
        if is_wanted || max_mm_s >= SAFE_BURN_MM_S {
            0.0
        } else {
            SLOW_BURN_COST
        }
    }

    /// How far it is from what is wanted, in steps of speed, squared: what is too fast counts more than what is too
    /// slow.
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

    /// How many ticks are lost until the arm is as fast as wanted again, if it may use all of the acceleration for that:
    /// with the speed v wanted, `(v - end)2 / (2 a v)`.
    fn recovery(&self, tick_stroke: &TickStroke) -> f64 {
        if self.wish.objective == Objective::Even || self.rests {
            return 0.0;
        }
        let wanted_mm_s = self.speeds.end_mm_s;
        let missing_mm_s = (wanted_mm_s - f64::from(tick_stroke.end_mm_s)).max(0.0);
        missing_mm_s * missing_mm_s
            / (2.0 * f64::from(tick_stroke.change_mm_s) * wanted_mm_s.max(1.0))
    }

    /// The fastest even speed with which the vector gets its full length, or as far up and down as the
    /// arm makes of the largest speed: no other speeds gave the full length.
    fn crawl(&self, stored_mm_s: f32) -> TickFit {
        let change = self.acceleration_mm_s2 * TICK_S;
        let mut fits = Vec::new();
        for ticks in self.least_ticks.max(1)..i16::MAX {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks) * (1.0 - SPARE);
            for max in [
                even_mm_s.min(stored_mm_s.max(LEAST_END_MM_S)),
                even_mm_s + 0.49 * change,
            ] {
                self.consider(stored_mm_s, max, max, &mut fits);
            }
            if let Some(&fit) = fits.first() {
                return fit;
            }
        }
        // With less than half a step it would keep for ever what it has.
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

    /// What the vector may leave instead, where it is not known how it begins: nothing if all of that is the same.
    fn possible_ends_mm_s(
        &self,
        end_mm_s: f32,
        max_mm_s: f32,
        tick_stroke: &TickStroke,
    ) -> Option<[f32; 3]> {
        let possible = |stored_mm_s| self.tick_stroke(stored_mm_s, end_mm_s, max_mm_s);
        let ends_mm_s = self.possible_mm_s?.map(|it| possible(it).end_mm_s);
        let is_same = |it: &f32| (it - tick_stroke.end_mm_s).abs() <= KNOWN_MM_S;
        (!ends_mm_s.iter().all(is_same)).then_some(ends_mm_s)
    }

    /// What becomes of the vector with these speeds.
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

/// By how much begin speeds are lower and corrections smaller than they could be, for rounding.
const SPARE: f32 = 1e-5;
/// Where in a step the speeds of the packet lie, so that they are rounded to the counts meant.
pub(crate) const NEAR: f32 = 0.4;
/// By so many steps of speed a vector may end faster than wanted: whether that is too fast is seen at its ticks.
const FREE_STEPS: f64 = 1.0;
/// How many ticks it is worth not to be faster by one more; in its square.
const OVER: f64 = 0.3;
/// How many ticks it is worth to end one step less above what is wanted, as far as that is not too fast.
const LESS: f64 = 0.1;
/// The same before a rest, where what is kept goes into the next vector at once, in another direction, and what that
/// corrects adds to it.
const FREE_AT_REST_STEPS: f64 = 0.3;
/// How many ticks it is worth not to keep one more step of speed there; in its cube, for what the next vector corrects is
/// anything up to half a step.
const OVER_AT_REST: f64 = 26.0;
/// The same for a top speed above what is allowed.
const ABOVE: f64 = 2.0;
/// A laser that burns slower sets fire to things: what the policy allows at the least, unless told otherwise, and a little more.
const SAFE_BURN_MM_S: f32 = 1.001;
/// What the policy allows a burning vector to tell as its largest speed at the least, unless told otherwise, in mm/s.
pub const LEAST_BURN_MM_S: f32 = 1.0;
/// More than anything else that a vector can have: it takes up to [`MOST_TICKS`], and what is late counts squared.
const SLOW_BURN_COST: f64 = 1e10;
/// So many ticks, squared, it is worth to know better by a step of speed with what the next vector begins.
const UNSURE: f64 = 10_000.0;
/// A speed that is off by less is known, in mm/s.
const KNOWN_MM_S: f32 = 0.04;
/// A stock arm counts to no more (note N51).
const MOST_TICKS: f64 = 32_000.0;
/// So many choices are told.
pub(crate) const MOST_FITS: usize = 30;
/// Where in a step the largest speed lies before a rest: it decides how many ticks slow down to 0.
const NEARS: [f32; 4] = [-0.4, 0.0, 0.2, 0.4];
/// A vector that does not rest ends with no less, in mm/s: 0 means a rest.
pub(crate) const LEAST_END_MM_S: f32 = 0.01;
/// Nor does it leave less to the next one: behind a laser that would creep (note N48).
pub(crate) const LEAST_LEFT_MM_S: f32 = 0.1;

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
    fn an_arm_that_brakes_for_a_corner_may_go_on_for_a_while_and_brake_then() {
        // From 40 mm/s with 2 mm/s less each tick: 13 ticks at b and 18 that brake go 15.9 mm = (31 b - 18 * 19) / 50 with b = 36.7 mm/s,
        // of which 0.7 mm/s are left.
        let wanted = target(15.9, [40.0, 0.5, 40.0], false);
        let fits = wanted.fits(40.0);
        let found = fits.iter().find(|it| it.tick_stroke.counts == [0, 13, 18]);
        let left_mm_s = found.expect("among the choices").tick_stroke.end_mm_s;
        assert!((left_mm_s - 0.68).abs() < 0.01, "{left_mm_s}");
    }

    proptest! {
        #[test]
        fn every_vector_is_as_long_as_it_should_be(
            length_mm in 0.012..150.0_f32,
            stored in prop_oneof![0.0..60.0_f32, (-9.0..0.0_f32).prop_map(|it| 10.0_f32.powf(it))],
            end in 0.0..60.0_f64,
            max in 0.1..80.0_f64,
            rests: bool,
        ) {
            let max = max.max(stored.into()).max(end);
            // As the ticker limits it: less could not be begun from rest.
            let most_mm_s = single(max.max(3.0));
            let wanted = target(length_mm, [stored.into(), end, max], rests);
            let wish = TickPreference { most_mm_s, ..wanted.wish };
            let fit = TickTarget { wish, ..wanted }.fits(stored)[0];
            prop_assert!(fit.tick_stroke.is_exact(), "{fit:?}");
            prop_assert_eq!(fit.end_mm_s == 0.0, rests);
            prop_assert!(fit.max_mm_s > 0.0 && fit.max_mm_s <= most_mm_s, "{fit:?}");
            // No slower than what is wanted, or than a tenth of what a tick changes.
            let slowest_mm_s = wanted.speeds.max_mm_s.min(0.2);
            let most_s = f64::from(length_mm) / slowest_mm_s + 2.0;
            prop_assert!(f64::from(fit.tick_stroke.ticks()) * 0.02 <= most_s, "{fit:?}");
        }

        #[test]
        fn a_vector_to_a_rest_does_not_creep_however_long_the_link_takes(
            length_mm in 0.012..10.0_f32,
            stored in (-9.0..0.0_f32).prop_map(|it| 10.0_f32.powf(it)),
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
            // Twice as long as wanted, and some ticks.
            let most_s = 2.0 * f64::from(length_mm) / max.min(0.2) + 2.0;
            prop_assert!(fit.duration_s() <= most_s, "{fit:?}");
        }
    }
}
