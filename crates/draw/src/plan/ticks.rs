//! Speeds for a stock arm, which cuts each vector into whole ticks (note N48).

use super::pace::Speeds;

/// How a stock arm runs a vector: so many ticks faster each, so many as fast, so many slower.
///
/// ```text
///   speed in a tick     begin 4, up 2, even 1, down 3          each tick's way is its speed times
///     |      _8_         correction included                   20 ms; the rest of the length is
///     |    _6|  |6_                                            spread over all ticks: correction
///     |  4|        |4_
///     |  |            |2        the next vector begins with what the last tick had
///     +-------------------- ticks
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cut {
    /// Ticks that accelerate, go on as fast, and slow down.
    counts: [i16; 3],
    /// The speed of the first tick, before it accelerates, in mm/s.
    first_mm_s: f32,
    /// The speed of the fastest tick, in mm/s.
    top_mm_s: f32,
    /// What the next vector begins with, in mm/s.
    pub(super) end_mm_s: f32,
    /// By how much all ticks are faster, so that they are as long as the vector, in mm/s.
    correction_mm_s: f32,
    /// How much faster one tick is than the one before, in mm/s.
    change_mm_s: f32,
}

impl Cut {
    /// What the controller makes of a vector, in its own arithmetic: single precision, in this
    /// order. `stored_mm_s` is the end speed of the vector before.
    pub(super) fn of(
        length_mm: f32,
        stored_mm_s: f32,
        end_mm_s: f32,
        max_mm_s: f32,
        acceleration_mm_s2: f32,
    ) -> Self {
        let change = acceleration_mm_s2 * TICK_S;
        let begin = if stored_mm_s > max_mm_s {
            max_mm_s
        } else {
            stored_mm_s
        };
        let end = if end_mm_s > max_mm_s {
            max_mm_s
        } else {
            end_mm_s
        };
        let (begin, up, down) = ramps(length_mm, [begin, end, max_mm_s], acceleration_mm_s2);
        let (ups, downs) = (f32::from(up), f32::from(down));
        let way_up = ups * (2.0 * begin + (ups - 1.0) * change) * 0.01;
        let way_down = if up > 0 {
            downs * (2.0 * begin + 2.0 * (ups - 1.0) * change - (downs - 1.0) * change) * 0.01
        } else {
            downs * (2.0 * begin - (downs + 1.0) * change) * 0.01
        };
        let top = begin + ups * change;
        let mut even = whole(50.0 * (length_mm - way_up - way_down) / top);
        if up.wrapping_add(even).wrapping_add(down) == 0 {
            even = 1;
        }
        let ticks = f32::from(up.wrapping_add(even).wrapping_add(down));
        let rest = length_mm - (way_up + f32::from(even) * top * TICK_S + way_down);
        let correction_mm_s = 50.0 * rest / ticks;
        let last = match (up > 0, down > 0) {
            (true, true) => begin + ups * change - downs * change,
            (false, false) => begin,
            (true, false) if even <= 0 => begin + (ups - 1.0) * change,
            (true, false) => begin + ups * change,
            (false, true) => begin - downs * change,
        };
        let fastest = if even <= 0 && up > 0 {
            begin + (ups - 1.0) * change
        } else if even <= 0 {
            begin - change
        } else {
            top
        };
        Self {
            counts: [up, even, down],
            first_mm_s: begin + correction_mm_s,
            top_mm_s: fastest + correction_mm_s,
            end_mm_s: correction_mm_s + last,
            correction_mm_s,
            change_mm_s: change,
        }
    }

    /// How many ticks it takes.
    pub(super) fn ticks(&self) -> i16 {
        self.counts.iter().sum()
    }

    /// Whether the vector becomes as long as it should. Where more than one step of speed is left
    /// to spread, the controller spreads one step and is off the way.
    fn is_true(&self) -> bool {
        self.counts.iter().all(|&count| count >= 0)
            && self.correction_mm_s.abs() <= self.change_mm_s * (1.0 - SPARE)
            && self.end_mm_s >= 0.0
            && self.first_mm_s >= 0.0
    }
}

/// The begin speed, and how many ticks accelerate and slow down.
fn ramps(length: f32, [begin, end, max]: [f32; 3], acceleration: f32) -> (f32, i16, i16) {
    let step = acceleration * TICK_S;
    let ticks = |change: f32| whole(change / step + 0.5);
    let full = (max * max - begin * begin / 2.0 - end * end / 2.0) / acceleration;
    if full <= length {
        return (begin, ticks(max - begin), ticks(max - end));
    }
    let least = (end * end - begin * begin) / (2.0 * acceleration);
    let is_rising = least >= 0.0;
    if length <= least.abs() {
        return if is_rising {
            let end = (2.0 * acceleration * length + begin * begin).sqrt();
            (begin, ticks(end - begin), 0)
        } else {
            let begin = (2.0 * acceleration * length + end * end).sqrt();
            (begin, 0, ticks(begin - end))
        };
    }
    if begin < 0.1 * max && end < 0.1 * max {
        let peak = (acceleration * length + begin * begin / 2.0 + end * end / 2.0).sqrt();
        (begin, ticks(peak - begin), ticks(peak - end))
    } else if is_rising {
        (begin, ticks(end - begin), 0)
    } else {
        (begin, 0, ticks(begin - end))
    }
}

/// A number cut to a whole one, as the stock processor does it: 0 for one that is none.
#[expect(
    clippy::cast_possible_truncation,
    reason = "what is too large is found untrue"
)]
fn whole(value: f32) -> i16 {
    if value.is_finite() { value as i16 } else { 0 }
}

/// What a vector should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wish {
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
}

/// The end speed and the largest speed for the packet, and what becomes of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit {
    pub end_mm_s: f32,
    pub max_mm_s: f32,
    pub cut: Cut,
    cost: f64,
}

impl Wish {
    /// The speeds that come nearest to the wish, behind a vector that left this speed.
    ///
    /// The controller takes an end speed and a largest one, and finds counts of ticks. So counts
    /// near to those wanted are tried, each with the two speeds that should lead to it; what
    /// really becomes of them is calculated as the controller does.
    pub(super) fn fit(&self, stored_mm_s: f32) -> Fit {
        let mut best = None;
        self.try_slower(stored_mm_s, &mut best);
        self.try_faster(stored_mm_s, &mut best);
        let slow = || self.crawl(stored_mm_s);
        best.unwrap_or_else(slow)
    }

    /// No tick accelerates: the begin speed is free, up to the one that is stored and one step.
    fn try_slower(&self, stored_mm_s: f32, best: &mut Option<Fit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let wanted = self.ticks.max(f64::from(self.least_ticks));
        let about = whole(single(wanted));
        for ticks in (about - 1).max(1).max(self.least_ticks)..=(about + 2).max(self.least_ticks) {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks);
            let drop = 2.0 * (even_mm_s - single(self.speeds.end_mm_s)) / change;
            let about = whole(drop.clamp(0.0, f32::from(ticks)));
            for down in (about - 2).max(0)..=(about + 2).min(ticks) {
                let downs = f32::from(down);
                let sum = change * downs * (downs + 1.0) / 2.0;
                let begin = (50.0 * self.length_mm + sum) / f32::from(ticks) * (1.0 - SPARE);
                let max = begin.min(stored_mm_s);
                self.consider(stored_mm_s, max - (downs - NEAR) * change, max, best);
            }
        }
    }

    /// Some ticks accelerate, from the speed that is stored.
    fn try_faster(&self, stored_mm_s: f32, best: &mut Option<Fit>) {
        let change = self.acceleration_mm_s2 * TICK_S;
        let [peak, end] = [self.speeds.peak_mm_s, self.speeds.end_mm_s].map(single);
        let up = whole(((peak - stored_mm_s) / change).clamp(0.0, 3000.0));
        let down = whole(((peak - end) / change).clamp(0.0, 3000.0));
        // Before a rest the end speed is 0, whatever the counts are meant to be.
        let downs = if self.rests {
            down..=down
        } else {
            (down - 3).max(0)..=down + 2
        };
        for up in (up - 3).max(1)..=up + 2 {
            for down in downs.clone() {
                for near in if self.rests { &NEARS[..] } else { &NEARS[2..3] } {
                    let max = stored_mm_s + (f32::from(up) - near) * change;
                    self.consider(
                        stored_mm_s,
                        max - (f32::from(down) - NEAR) * change,
                        max,
                        best,
                    );
                }
            }
        }
    }

    fn consider(&self, stored_mm_s: f32, end_mm_s: f32, max_mm_s: f32, best: &mut Option<Fit>) {
        let least = if self.rests { 0.0 } else { LEAST_END_MM_S };
        let end_mm_s = if self.rests {
            0.0
        } else {
            end_mm_s.min(max_mm_s).max(least)
        };
        if max_mm_s < LEAST_END_MM_S {
            return;
        }
        let cut = Cut::of(
            self.length_mm,
            stored_mm_s,
            end_mm_s,
            max_mm_s,
            self.acceleration_mm_s2,
        );
        if !cut.is_true() || cut.ticks() < self.least_ticks {
            return;
        }
        let cost = self.cost(stored_mm_s, &cut);
        if best.is_none_or(|best| cost < best.cost) {
            *best = Some(Fit {
                end_mm_s,
                max_mm_s,
                cut,
                cost,
            });
        }
    }

    /// In steps of speed, squared: what is too fast counts more than what is too slow.
    fn cost(&self, stored_mm_s: f32, cut: &Cut) -> f64 {
        let steps = |mm_s: f64| mm_s / f64::from(cut.change_mm_s);
        let late = f64::from(cut.ticks()) - self.ticks;
        let over = steps(f64::from(cut.end_mm_s) - self.speeds.end_mm_s);
        let first = if cut.counts[0] == 0 && cut.counts[1] == 0 {
            cut.first_mm_s - cut.change_mm_s
        } else {
            cut.first_mm_s
        };
        let jump = steps(f64::from(first - stored_mm_s)).abs();
        let jump = (jump - 1.0).max(0.0);
        let above = steps(f64::from(cut.top_mm_s) - self.speeds.limit_mm_s).max(0.0);
        let weight = if over > 0.0 { OVER } else { UNDER };
        late * late + weight * over * over + 2.0 * jump * jump + 4.0 * above * above
    }

    /// As slow as it has to be, so that it becomes as long as it should: nothing else did.
    fn crawl(&self, stored_mm_s: f32) -> Fit {
        let change = self.acceleration_mm_s2 * TICK_S;
        let mut best = None;
        for ticks in self.least_ticks.max(1)..i16::MAX {
            let even_mm_s = 50.0 * self.length_mm / f32::from(ticks) * (1.0 - SPARE);
            for max in [
                even_mm_s.min(stored_mm_s.max(LEAST_END_MM_S)),
                even_mm_s + 0.49 * change,
            ] {
                self.consider(stored_mm_s, max, max, &mut best);
            }
            if let Some(fit) = best {
                return fit;
            }
        }
        let max_mm_s = single(self.speeds.limit_mm_s);
        let cut = Cut::of(
            self.length_mm,
            stored_mm_s,
            0.0,
            max_mm_s,
            self.acceleration_mm_s2,
        );
        Fit {
            end_mm_s: 0.0,
            max_mm_s,
            cut,
            cost: f64::INFINITY,
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
const fn single(value: f64) -> f32 {
    value as f32
}

/// The control tick.
pub(super) const TICK_S: f32 = 0.02;
/// By how much begin speeds are lower and corrections smaller than they could be, for rounding.
const SPARE: f32 = 1e-5;
/// Where in a step the speeds of the packet lie, so that they are rounded to the counts meant.
const NEAR: f32 = 0.4;
const OVER: f64 = 8.0;
const UNDER: f64 = 0.5;
const NEARS: [f32; 4] = [-0.4, 0.0, 0.4, 0.2];
/// A vector that does not rest ends with no less, in mm/s: 0 means a rest.
const LEAST_END_MM_S: f32 = 0.01;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn wish(length_mm: f32, [start, end, max]: [f64; 3], rests: bool) -> Wish {
        let end = if rests { 0.0 } else { end };
        let speeds = Speeds::of(length_mm.into(), [start, end, max], max, 100.0);
        Wish {
            length_mm,
            speeds,
            ticks: speeds.duration_s / f64::from(TICK_S),
            least_ticks: 1,
            rests,
            acceleration_mm_s2: 100.0,
        }
    }

    #[test]
    fn a_vector_from_rest_to_rest_is_cut_as_the_note_tells() {
        // 10 mm at 100 mm/s2: the peak is sqrt(1000) = 31.6 mm/s, 16 steps of 2 mm/s up and down;
        // their ways are 4.8 mm each, and the 0.4 mm left make 50 * 0.4 / 32 = 0.625 mm/s more.
        let cut = Cut::of(10.0, 0.0, 0.0, 40.0, 100.0);
        assert_eq!(cut.counts, [16, 0, 16]);
        assert!((cut.correction_mm_s - 0.625).abs() < 1e-4);
        assert!((cut.end_mm_s - 0.625).abs() < 1e-4);
        assert!(cut.is_true());
    }

    #[test]
    fn a_short_vector_in_full_motion_would_be_too_short_and_is_found_untrue() {
        // 3 mm at 40 mm/s: three ticks of 0.8 mm leave 0.6 mm, which is 10 mm/s for each.
        let cut = Cut::of(3.0, 40.0, 40.0, 40.0, 100.0);
        assert_eq!(cut.counts, [0, 3, 0]);
        assert!(!cut.is_true());
    }

    proptest! {
        #[test]
        fn every_vector_is_as_long_as_it_should_be(
            length_mm in 0.002..150.0_f32,
            stored in 0.0..60.0_f32,
            end in 0.0..60.0_f64,
            max in 1.0..80.0_f64,
            rests: bool,
        ) {
            let max = max.max(stored.into()).max(end);
            let fit = wish(length_mm, [stored.into(), end, max], rests).fit(stored);
            prop_assert!(fit.cut.is_true(), "{fit:?}");
            prop_assert_eq!(fit.end_mm_s == 0.0, rests);
            prop_assert!(fit.max_mm_s > 0.0);
        }
    }
}
