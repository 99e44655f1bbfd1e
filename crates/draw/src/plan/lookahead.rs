//! Look-ahead: how fast each corner may be passed.

/// One straight vector, as look-ahead sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Its direction, of length one.
    pub direction: [f64; 3],
    /// Its length in mm, above 0.
    pub length_mm: f64,
    /// The speed that must not be passed on it, in mm/s.
    pub limit_mm_s: f64,
}

/// What corners are measured against.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cornering {
    /// How fast speed may change along the path, in mm/s2.
    pub acceleration_mm_s2: f64,
    /// How far an imagined arc through a corner may leave it, in mm: the larger, the faster
    /// corners are passed. The arm itself draws the corner sharp.
    pub deviation_mm: f64,
    /// Whether every corner is a stop.
    pub stops: bool,
}

impl Cornering {
    /// The square of the speed at which the corner between two directions may be passed.
    ///
    /// Junction deviation: a circle touches both vectors such that its arc passes the corner at
    /// the distance `d`. Running along that arc with the centripetal acceleration `a` gives the
    /// speed, where `h` is half the angle between the two vectors:
    ///
    /// ```text
    ///       v2 = a r,   r = d sin(h) / (1 - sin(h))
    ///
    ///   ---->-.          straight on: h = 90 degrees, any speed
    ///       d/ \         right angle: h = 45 degrees, v2 = 2.41 a d
    ///           v        back:        h = 0,          v2 = 0
    /// ```
    #[must_use]
    pub fn corner_v2(self, before: [f64; 3], after: [f64; 3]) -> f64 {
        if self.stops {
            return 0.0;
        }
        let cos_turn = before[0] * after[0] + before[1] * after[1] + before[2] * after[2];
        let sin_half = (0.5 * (1.0 + cos_turn)).clamp(0.0, 1.0).sqrt();
        self.acceleration_mm_s2 * self.deviation_mm * sin_half / (1.0 - sin_half)
    }

    /// The speeds in mm/s at the start of each vector and, last, at the end of the last: at rest
    /// at both ends of the chain.
    ///
    /// ```text
    ///   speed
    ///     |        limit of b ________
    ///     |                  /        \         corner c|d
    ///     |   corner a|b    /          \          |    ____
    ///     |         |______/|          |\         |   /    \
    ///     |        /|       |          | \________|__/      \
    ///     |_______/_|_______|__________|__________|__________\___ way
    ///        a         b          b         c           d
    /// ```
    ///
    /// 1. A corner is passed no faster than its angle allows, nor than either vector's limit.
    /// 2. Backward: no corner is reached faster than the vector after it can brake from.
    /// 3. Forward: no corner is reached faster than the vector before it can accelerate to.
    /// 4. Both in squares of speeds, where a vector of length `s` adds or takes `2 a s`.
    pub fn speeds(self, chain: &[Run], speeds: &mut Vec<f64>) {
        speeds.clear();
        if chain.is_empty() {
            return;
        }
        speeds.push(0.0);
        speeds.extend(chain.windows(2).map(|pair| {
            let limit = pair[0].limit_mm_s.min(pair[1].limit_mm_s);
            let corner_v2 = self.corner_v2(pair[0].direction, pair[1].direction);
            corner_v2.min(limit * limit)
        }));
        speeds.push(0.0);
        let gain = 2.0 * self.acceleration_mm_s2;
        let mut v2 = 0.0_f64;
        for (at, run) in speeds.iter_mut().zip(chain).rev() {
            v2 = at.min(v2 + gain * run.length_mm);
            *at = v2;
        }
        for (at, run) in speeds[1..].iter_mut().zip(chain) {
            v2 = at.min(v2 + gain * run.length_mm);
            *at = v2;
        }
        for at in speeds {
            *at = at.sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const CORNERING: Cornering = Cornering {
        acceleration_mm_s2: 100.0,
        deviation_mm: 0.02,
        stops: false,
    };

    fn run(degrees: f64, length_mm: f64, limit_mm_s: f64) -> Run {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Run {
            direction: [cos, sin, 0.0],
            length_mm,
            limit_mm_s,
        }
    }

    fn speeds(chain: &[Run]) -> Vec<f64> {
        let mut speeds = Vec::new();
        CORNERING.speeds(chain, &mut speeds);
        speeds
    }

    #[test]
    fn a_right_angle_is_passed_at_the_speed_of_its_arc() {
        // r = d sin 45 / (1 - sin 45) = 2.4142 d
        let v2 = CORNERING.corner_v2([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        assert!((v2 - 100.0 * 0.02 * 2.414_213_562).abs() < 1e-6);
    }

    #[test]
    fn straight_on_the_limit_counts_and_turning_back_stops() {
        let straight = speeds(&[run(0.0, 50.0, 30.0), run(0.0, 50.0, 20.0)]);
        assert_eq!(straight, [0.0, 20.0, 0.0]);
        let back = speeds(&[run(0.0, 50.0, 30.0), run(180.0, 50.0, 20.0)]);
        assert!(back[1] < 1e-6);
    }

    #[test]
    fn a_long_straight_brakes_in_time_for_its_end() {
        // v2 = 2 a s: 1 mm before the end 200, 2 mm before it 400, whatever the limit.
        let chain = [
            run(0.0, 50.0, 90.0),
            run(0.0, 1.0, 90.0),
            run(0.0, 1.0, 90.0),
        ];
        let v2: Vec<f64> = speeds(&chain).iter().map(|v| (v * v).round()).collect();
        assert_eq!(v2, [0.0, 400.0, 200.0, 0.0]);
    }

    proptest! {
        #[test]
        fn limit_corner_and_acceleration_hold_everywhere(
            chain in proptest::collection::vec(
                (0.0..360.0_f64, 0.01..20.0_f64, 1.0..100.0_f64).prop_map(|(d, s, v)| run(d, s, v)),
                1..50,
            )
        ) {
            let speeds = speeds(&chain);
            prop_assert_eq!((speeds[0], speeds[chain.len()]), (0.0, 0.0));
            for (i, run) in chain.iter().enumerate() {
                let (from, to) = (speeds[i], speeds[i + 1]);
                prop_assert!(from <= run.limit_mm_s && to <= run.limit_mm_s);
                let needed = (to * to - from * from).abs() / (2.0 * run.length_mm);
                prop_assert!(needed <= CORNERING.acceleration_mm_s2 * (1.0 + 1e-9));
            }
            for (i, pair) in chain.windows(2).enumerate() {
                let corner = CORNERING.corner_v2(pair[0].direction, pair[1].direction).sqrt();
                prop_assert!(speeds[i + 1] <= corner * (1.0 + 1e-9));
            }
        }
    }
}
