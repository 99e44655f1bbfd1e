//! Division of a vector into ticks by a stock arm (note N48).

use dobot_arm::stock::short;

use crate::TickProgress;
use crate::tick_progress::{TICK_S, added};

/// A vector as executed by a stock arm: ticks that accelerate, keep the speed, and decelerate.
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
pub struct TickStroke {
    /// The number of ticks that accelerate, keep the speed, and decelerate.
    pub counts: [i16; 3],
    /// The speed of the first tick, before it accelerates, in mm/s.
    pub first_mm_s: f32,
    /// The speed of the fastest tick, in mm/s.
    pub top_mm_s: f32,
    /// The initial speed of the next vector, in mm/s.
    pub end_mm_s: f32,
    /// The speed that all ticks lack to cover the length of the vector, in mm/s.
    pub correction_mm_s: f32,
    /// The speed change from tick to tick, in mm/s.
    pub change_mm_s: f32,
}

impl TickStroke {
    /// Computes the ticks of a vector of this length in the controller's own arithmetic: single
    /// precision, in this order. `stored_mm_s` is the speed left by the vector before; end speed
    /// and maximum speed are those of the packet. In laser mode without the laser the acceleration
    /// is a hundredfold.
    #[must_use]
    pub fn of(
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
        let mut even = short(50.0 * (length_mm - way_up - way_down) / top);
        if added([up, even, down]) == 0 {
            even = 1;
        }
        let ticks = f32::from(added([up, even, down]));
        let rest = length_mm - (way_up + f32::from(even) * top * TICK_S + way_down);
        let correction_mm_s = 50.0 * rest / ticks;
        let correction = if correction_mm_s.abs() > change {
            change
        } else {
            correction_mm_s
        };
        let last = match (up > 0, down > 0) {
            (true, true) => begin + ups * change - downs * change,
            (false, true) => begin - downs * change,
            (true, false) if even <= 0 => begin + (ups - 1.0) * change,
            // A count below zero changes the speed, although no tick does.
            (_, false) => begin + ups * change,
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
            first_mm_s: begin + correction,
            top_mm_s: fastest + correction,
            end_mm_s: correction + last,
            correction_mm_s,
            change_mm_s: change,
        }
    }

    /// Returns the number of ticks.
    #[must_use]
    pub fn ticks(&self) -> i16 {
        added(self.counts)
    }

    /// Returns the speed of each tick in mm/s.
    #[must_use]
    pub fn speeds_mm_s(&self) -> impl DoubleEndedIterator<Item = f32> {
        let [up, even, down] = self.counts;
        let change = self.change_mm_s;
        let top = self.first_mm_s + f32::from(up) * change;
        let first = self.first_mm_s;
        let rises = (0..up).map(move |tick| first + f32::from(tick) * change);
        let keeps = (0..even).map(move |_| top);
        let falls = (1..=down).map(move |tick| top - f32::from(tick) * change);
        rises.chain(keeps).chain(falls)
    }

    /// Returns the executed length in mm: the nominal length if it [is exact](Self::is_exact),
    /// negative if the vector moves back.
    #[must_use]
    pub fn length_mm(&self) -> f32 {
        self.speeds_mm_s().map(|mm_s| mm_s * TICK_S).sum()
    }

    /// Returns the displacement in mm of a vector with these increments and ticks, including
    /// rounding.
    #[must_use]
    pub fn displacement_mm(&self, vector_mm: [f32; 3], length_mm: f32) -> [f32; 3] {
        let mut progress = TickProgress::default();
        progress.begin(Some(self));
        for _ in 0..self.ticks() {
            progress = progress.tick(vector_mm, length_mm, self.change_mm_s);
        }
        progress.travelled_mm()
    }

    /// Whether the executed length equals the nominal one. If the missing speed exceeds one step,
    /// the controller adds only one step and the length is wrong.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.counts.iter().all(|&count| count >= 0)
            && self.correction_mm_s.abs() <= self.change_mm_s * (1.0 - SPARE)
            && self.end_mm_s >= 0.0
            && self.first_mm_s >= 0.0
    }
}

/// Returns the initial speed and the numbers of ticks that accelerate and decelerate.
fn ramps(length: f32, [begin, end, max]: [f32; 3], acceleration: f32) -> (f32, i16, i16) {
    let ticks = |change: f32| short(change / (acceleration * TICK_S) + 0.5);
    let full = (max * max - begin * begin / 2.0 - end * end / 2.0) / acceleration;
    if full <= length {
        return (begin, ticks(max - begin), ticks(max - end));
    }
    let least = (end * end - begin * begin) / (2.0 * acceleration);
    let is_rising = least >= 0.0;
    if length <= least.abs() {
        return if is_rising {
            let end = libm::sqrtf(2.0 * acceleration * length + begin * begin);
            (begin, ticks(end - begin), 0)
        } else {
            let begin = libm::sqrtf(2.0 * acceleration * length + end * end);
            (begin, 0, ticks(begin - end))
        };
    }
    if begin < 0.1 * max && end < 0.1 * max {
        let peak = libm::sqrtf(acceleration * length + begin * begin / 2.0 + end * end / 2.0);
        (begin, ticks(peak - begin), ticks(peak - end))
    } else if is_rising {
        (begin, ticks(end - begin), 0)
    } else {
        (begin, 0, ticks(begin - end))
    }
}

/// The share of a step reserved for rounding.
const SPARE: f32 = 1e-5;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_from_rest_to_rest_has_the_ticks_of_the_note() {
        // 10 mm at 100 mm/s2: the peak is sqrt(1000) = 31.6 mm/s, 16 steps of 2 mm/s up and down;
        // they cover 4.8 mm each, and the missing 0.4 mm add 50 * 0.4 / 32 = 0.625 mm/s.
        let tick_stroke = TickStroke::of(10.0, 0.0, 0.0, 40.0, 100.0);
        assert_eq!(tick_stroke.counts, [16, 0, 16]);
        assert!((tick_stroke.correction_mm_s - 0.625).abs() < 1e-4);
        assert!((tick_stroke.end_mm_s - 0.625).abs() < 1e-4);
        let way_mm = tick_stroke.length_mm();
        assert!((way_mm - 10.0).abs() < 1e-4, "{way_mm}");
        assert!(tick_stroke.is_exact());
    }

    #[test]
    fn counts_below_zero_lower_the_speed_that_is_left_by_what_they_would_have_added() {
        // The acceleration is -100 mm/s2, so a tick adds -2 mm/s: 40 mm/s are -20 + 0.5 ticks away, cut
        // to -19, up and down. They cover -7.6 and 6.84 mm; 100.76 mm at 38 mm/s are 132 ticks.
        let tick_stroke = TickStroke::of(100.0, 0.0, 0.0, 40.0, -100.0);
        assert_eq!(tick_stroke.counts, [-19, 132, -19]);
        // 94 ticks lack 0.23 mm/s, which is more than a step of -2: they get the step.
        assert!((tick_stroke.first_mm_s - -2.0).abs() < 1e-4);
        // Left for the next vector: 0 + -19 * -2 + -2.
        let left_mm_s = tick_stroke.end_mm_s;
        assert!(
            (left_mm_s - 36.0).abs() < 1e-4,
            "{left_mm_s}, not 36 by 1e-4"
        );
        assert!(!tick_stroke.is_exact());
    }

    #[test]
    fn a_short_vector_in_full_motion_would_be_too_short_and_is_found_untrue() {
        // 3 mm at 40 mm/s: three ticks of 0.8 mm leave 0.6 mm, which is 10 mm/s for each.
        let tick_stroke = TickStroke::of(3.0, 40.0, 40.0, 40.0, 100.0);
        assert_eq!(tick_stroke.counts, [0, 3, 0]);
        // Only one step of 2 mm/s is added: 42 mm/s for 60 ms.
        assert!((tick_stroke.length_mm() - 2.52).abs() < 1e-4);
        assert!(!tick_stroke.is_exact());
    }
}
