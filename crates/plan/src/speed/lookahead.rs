//! Look-ahead: start and end speeds of vectors, and their durations.

use crate::path::vector::length;

/// A straight vector for the look-ahead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainVector {
    /// The unit vector of its direction.
    pub direction: [f64; 3],
    /// The length in mm, above 0.
    pub length_mm: f64,
    /// The maximum speed, in mm/s.
    pub limit_mm_s: f64,
    /// The maximum speed at the corner after it in mm/s: infinite, or lower if that corner and its
    /// neighbours together turn the tool too fast.
    pub corner_mm_s: f64,
}

impl ChainVector {
    /// Creates a vector with these increments in mm, not all 0, and no corner limit.
    #[must_use]
    pub fn of(increments: [f64; 3], limit_mm_s: f64) -> Self {
        let length_mm = length(increments);
        Self {
            direction: increments.map(|mm| mm / length_mm),
            length_mm,
            limit_mm_s,
            corner_mm_s: f64::INFINITY,
        }
    }
}

/// The limits at corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cornering {
    /// The maximum acceleration, along the path and across it together, in mm/s2.
    pub acceleration_mm_s2: f64,
    /// The maximum deviation of an imagined arc from a corner, in mm: a larger value allows faster
    /// corners. The arm itself draws sharp corners. See
    /// [`ArmLimits::corner_deviation_mm`](crate::ArmLimits::corner_deviation_mm).
    pub deviation_mm: f64,
    /// The window over which the acceleration at a corner is measured, in s. A corner changes the
    /// velocity instantly; the positions one window before, at and one window after it count.
    pub window_s: f64,
}

/// The junction of two vectors, or the start or end of a chain.
///
/// ```text
///          t       corner      an arc touches both vectors at the distance t from the corner:
///    ----->|----------.        t = the half of the shorter vector, or less where the arc would
///           `.        |        leave the corner by more than the deviation. On a polygon that
///              `.     | t      stands for a circle all the arcs together are that circle.
///                \    |
///   turn: the     |---|  on    radius r = t / tan(turn / 2),  its largest speed: v2 = a r
///   angle between |   |
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Junction {
    /// The squared speed in the middle of the arc.
    pub v2: f64,
    /// The maximum of `v2` without the limits of the vectors.
    most_v2: f64,
    /// The maximum squared speed on the arc; infinite if the path is straight.
    cap_v2: f64,
    /// The length of the arc's tangents along both vectors, in mm.
    tangent_mm: f64,
    /// Cosine and sine of the turn.
    cos: f64,
    sin: f64,
    /// Half of the turn in rad, its cosine and its sine.
    half_turn: f64,
    half_cos: f64,
    half_sin: f64,
}

impl Cornering {
    /// Computes the speeds at the junctions of a chain: the fastest motion along the path with
    /// rounded corners, from the speed `begin_mm_s`, or the highest that can be braked in time, to
    /// rest.
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
    /// 1. An arc is passed no faster than its radius allows, nor than either vector's limit.
    /// 2. Backward: no junction is reached faster than what follows can brake from.
    /// 3. Forward: no junction is reached faster than what is before can accelerate to.
    /// 4. On an arc only what the turning leaves of the acceleration changes the speed; see
    ///    `Junction::half_arc`.
    pub fn speeds(self, begin_mm_s: f64, chain: &[ChainVector], junctions: &mut Vec<Junction>) {
        self.set_junctions(begin_mm_s, chain, junctions);
        self.set_speeds(chain, junctions);
    }

    /// Sets the junctions of a chain, without speeds.
    pub(crate) fn set_junctions(
        self,
        begin_mm_s: f64,
        chain: &[ChainVector],
        junctions: &mut Vec<Junction>,
    ) {
        junctions.clear();
        if chain.is_empty() {
            return;
        }
        junctions.push(Junction {
            most_v2: begin_mm_s * begin_mm_s,
            ..Junction::STRAIGHT_ON
        });
        junctions.extend(
            chain
                .windows(2)
                .map(|pair| self.junction(&pair[0], &pair[1])),
        );
        junctions.push(Junction::REST);
    }

    /// Sets the speeds at the junctions of a chain, whose limits may have changed.
    pub(crate) fn set_speeds(self, chain: &[ChainVector], junctions: &mut [Junction]) {
        let [begin, corners @ .., rest] = junctions else {
            return;
        };
        for (pair, junction) in chain.windows(2).zip(corners) {
            let limit = pair[0].limit_mm_s.min(pair[1].limit_mm_s);
            let limit = limit.min(pair[0].corner_mm_s);
            junction.v2 = junction.most_v2.min(limit * limit);
        }
        (begin.v2, rest.v2) = (begin.most_v2, rest.most_v2);
        // Squared speeds are linear in the distance at constant acceleration, so both passes
        // use them.
        let mut v2 = 0.0_f64;
        for (i, run) in chain.iter().enumerate().rev() {
            v2 = self.reached_v2(v2, &junctions[i + 1], run, &junctions[i]);
            v2 = v2.min(junctions[i].v2);
            junctions[i].v2 = v2;
        }
        v2 = junctions[0].v2;
        for (i, run) in chain.iter().enumerate() {
            v2 = self.reached_v2(v2, &junctions[i], run, &junctions[i + 1]);
            v2 = v2.min(junctions[i + 1].v2);
            junctions[i + 1].v2 = v2;
        }
    }

    /// Returns the minimum duration of each vector of a chain from rest to rest, in s.
    #[must_use]
    pub fn durations_s(self, chain: &[ChainVector]) -> Vec<f64> {
        let mut junctions = Vec::with_capacity(chain.len() + 1);
        self.speeds(0.0, chain, &mut junctions);
        let pairs = junctions.windows(2).zip(chain);
        pairs
            .map(|(pair, run)| self.duration_s(&pair[0], run, &pair[1]))
            .collect()
    }

    /// Returns the junction of two vectors, with its maximum speed if these have no limits.
    fn junction(self, before: &ChainVector, after: &ChainVector) -> Junction {
        let ([ax, ay, az], [bx, by, bz]) = (before.direction, after.direction);
        let cos = (ax * bx + ay * by + az * bz).clamp(-1.0, 1.0);
        let sin_half = (0.5 * (1.0 - cos)).sqrt();
        let cos_half = (0.5 * (1.0 + cos)).sqrt();
        if sin_half < STRAIGHT {
            return Junction::STRAIGHT_ON;
        }
        let tan_half = sin_half / cos_half;
        let reach_mm = self.deviation_mm * (1.0 + cos_half) / sin_half;
        let shorter_mm = before.length_mm.min(after.length_mm);
        let most_mm = reach_mm.min(0.5 * shorter_mm);
        let sampled_limit_mm_s = self.sampled_limit_mm_s(sin_half, shorter_mm);
        let cap_v2 = (self.acceleration_mm_s2 * most_mm / tan_half)
            .min(sampled_limit_mm_s * sampled_limit_mm_s);
        if cap_v2 < MIN_V2 {
            return Junction::REST;
        }
        Junction {
            v2: cap_v2,
            most_v2: cap_v2,
            cap_v2,
            tangent_mm: cap_v2 / self.acceleration_mm_s2 * tan_half,
            cos,
            sin: 2.0 * sin_half * cos_half,
            half_turn: sin_half.atan2(cos_half),
            half_cos: cos_half,
            half_sin: sin_half,
        }
    }

    /// Returns the corner speed at which the sampled acceleration reaches its limit, in mm/s. At
    /// constant speed, the velocity turns by as much as the acceleration changes it within the
    /// window. On longer vectors or at sharp corners, the tool also brakes before and accelerates
    /// after the corner, which adds to the samples.
    fn sampled_limit_mm_s(self, sin_half: f64, shorter_mm: f64) -> f64 {
        let change_mm_s = self.acceleration_mm_s2 * self.window_s;
        let even_mm_s = 0.5 * change_mm_s / sin_half;
        let windows = shorter_mm / (even_mm_s * self.window_s);
        let sharp = 4.0 * (sin_half - GENTLE);
        even_mm_s - 0.5 * change_mm_s * (windows - 1.0).max(sharp).clamp(0.0, 1.0)
    }

    /// Returns the maximum squared speed in the middle of the arc at the end of a vector, given
    /// `v2` in the middle of the arc at its start.
    fn reached_v2(self, v2: f64, from: &Junction, run: &ChainVector, to: &Junction) -> f64 {
        let limit_v2 = run.limit_mm_s * run.limit_mm_s;
        let straight_mm = run.length_mm - from.tangent_mm - to.tangent_mm;
        let out = from.half_arc(v2).min(limit_v2);
        let into = out + 2.0 * self.acceleration_mm_s2 * straight_mm;
        to.half_arc(into.min(to.cap_v2).min(limit_v2)).min(limit_v2)
    }

    /// Returns the minimum duration of the vector between two junctions, in s, in the motion found
    /// by [`speeds`](Self::speeds).
    #[must_use]
    pub fn duration_s(self, from: &Junction, run: &ChainVector, to: &Junction) -> f64 {
        let a = self.acceleration_mm_s2;
        let limit_v2 = run.limit_mm_s * run.limit_mm_s;
        let straight_mm = (run.length_mm - from.tangent_mm - to.tangent_mm).max(0.0);
        let gain = 2.0 * a * straight_mm;
        let [up, down] = [from, to].map(|junction| junction.half_arc(junction.v2).min(limit_v2));
        let (out, into) = (up.min(down + gain), down.min(up + gain));
        let peak = (0.5 * (out + into + gain)).min(limit_v2).sqrt();
        let (out_mm_s, into_mm_s) = (out.sqrt(), into.sqrt());
        let ramps_mm = (peak * peak - 0.5 * (out + into)) / a;
        let cruise_s = (straight_mm - ramps_mm).max(0.0) / peak;
        let ramps_s = (2.0 * peak - out_mm_s - into_mm_s) / a;
        cruise_s + ramps_s + from.half_arc_s(out_mm_s, a) + to.half_arc_s(into_mm_s, a)
    }
}

impl Junction {
    /// The start or end of a chain.
    const REST: Self = Self {
        v2: 0.0,
        most_v2: 0.0,
        ..Self::STRAIGHT_ON
    };

    const STRAIGHT_ON: Self = Self {
        v2: f64::INFINITY,
        most_v2: f64::INFINITY,
        cap_v2: f64::INFINITY,
        tangent_mm: 0.0,
        cos: 1.0,
        sin: 0.0,
        half_turn: 0.0,
        half_cos: 1.0,
        half_sin: 0.0,
    };

    /// Returns the speed in mm/s.
    #[must_use]
    pub fn speed_mm_s(&self) -> f64 {
        self.v2.sqrt()
    }

    /// Returns the squared speed at one end of half the arc, from that at the other end, using the
    /// acceleration that turning leaves.
    ///
    /// With w the share of the acceleration used for turning, w = v2 / (a r), the acceleration left
    /// along the path is `a sqrt(1 - w2)`. So `dw / ds = 2 sqrt(1 - w2) / r`, whose solution is a
    /// sine: over half an arc its argument grows by the whole turn.
    fn half_arc(&self, v2: f64) -> f64 {
        if self.tangent_mm == 0.0 {
            return v2;
        }
        let w = v2 / self.cap_v2;
        if w >= self.cos {
            return self.cap_v2;
        }
        self.cap_v2 * (w * self.cos + (1.0 - w * w).sqrt() * self.sin)
    }

    /// Returns the duration of half the arc, given the speed at its outer end: in two pieces, each
    /// with constant acceleration.
    fn half_arc_s(&self, outer_mm_s: f64, acceleration_mm_s2: f64) -> f64 {
        if self.tangent_mm == 0.0 {
            return 0.0;
        }
        let length_mm = self.cap_v2 / acceleration_mm_s2 * self.half_turn;
        let inner_mm_s = self.speed_mm_s();
        let half = Self {
            cos: self.half_cos,
            sin: self.half_sin,
            ..*self
        };
        let middle = half.half_arc(self.v2).sqrt();
        let middle_mm_s = middle.min(inner_mm_s.max(outer_mm_s));
        length_mm / (inner_mm_s + middle_mm_s) + length_mm / (middle_mm_s + outer_mm_s)
    }
}

/// Below this half sine of a turn the path is straight.
const STRAIGHT: f64 = 1e-7;
/// The half sine of a turn up to which a corner is gentle.
const GENTLE: f64 = 0.3;
/// The squared speed below which a corner is a stop, in (mm/s)2.
const MIN_V2: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;

    const CORNERING: Cornering = Cornering {
        acceleration_mm_s2: 100.0,
        deviation_mm: 0.05,
        window_s: 0.08,
    };

    fn run(degrees: f64, length_mm: f64, limit_mm_s: f64) -> ChainVector {
        let (sin, cos) = degrees.to_radians().sin_cos();
        ChainVector {
            direction: [cos, sin, 0.0],
            length_mm,
            limit_mm_s,
            corner_mm_s: f64::INFINITY,
        }
    }

    fn speeds(chain: &[ChainVector]) -> Vec<f64> {
        let mut junctions = Vec::new();
        CORNERING.speeds(0.0, chain, &mut junctions);
        junctions.iter().map(Junction::speed_mm_s).collect()
    }

    #[test]
    fn a_polygon_is_run_at_the_speed_of_its_circle() {
        // 72 vectors around a circle of 4 mm: v2 = a R, where the arcs touch the vectors in their
        // middle and so have the radius of the inscribed circle.
        let turn = TAU / 72.0;
        let length_mm = 2.0 * 4.0 * (turn / 2.0).sin();
        let chain: Vec<ChainVector> = (0..720_u32)
            .map(|i| run(f64::from(i) * 5.0, length_mm, 90.0))
            .collect();
        let inscribed_mm = 4.0 * (turn / 2.0).cos();
        let found = speeds(&chain)[360];
        let wanted = (100.0 * inscribed_mm).sqrt();
        assert!((found - wanted).abs() < 1e-6, "{found} instead of {wanted}");
        let mut junctions = Vec::new();
        CORNERING.speeds(0.0, &chain, &mut junctions);
        let took_s = CORNERING.duration_s(&junctions[360], &chain[360], &junctions[361]);
        let wanted_s = inscribed_mm * turn / wanted;
        assert!((took_s - wanted_s).abs() < 1e-9, "{took_s}, {wanted_s}");
    }

    #[test]
    fn at_a_sharp_corner_the_tool_deviates_no_more_than_the_acceleration_allows() {
        // Right angle, braking and accelerating with a: 0.08 s from the corner the distance is v h
        // + a h2 / 2 on both sides, and the second difference is sqrt(2) times that.
        let v = speeds(&[run(0.0, 50.0, 90.0), run(90.0, 50.0, 90.0)])[1];
        let away_mm = v * 0.08 + 0.5 * 100.0 * 0.08 * 0.08;
        let seen = 2.0_f64.sqrt() * away_mm / (0.08 * 0.08);
        assert!((seen - 100.0).abs() < 1e-6, "{seen}");
    }

    #[test]
    fn at_a_straight_join_the_limit_applies_and_at_a_reversal_the_tool_stops() {
        let straight = speeds(&[run(0.0, 50.0, 30.0), run(0.0, 50.0, 20.0)]);
        assert_eq!(straight, [0.0, 20.0, 0.0]);
        let back = speeds(&[run(0.0, 50.0, 30.0), run(180.0, 50.0, 20.0)]);
        assert!(back[1] < 1e-6);
    }

    #[test]
    fn a_long_straight_brakes_in_time_for_its_end() {
        // v2 = 2 a s: 1 mm before the end 200, 2 mm before it 400, for any limit.
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
                let corner = CORNERING.junction(&pair[0], &pair[1]).speed_mm_s();
                prop_assert!(speeds[i + 1] <= corner * (1.0 + 1e-9));
            }
        }

        #[test]
        fn the_duration_of_a_half_arc_is_that_of_small_steps(
            turn in 0.05..1.6_f64, share in 0.01..0.99_f64, radius_mm in 0.05..50.0_f64,
        ) {
            let a = 100.0;
            let mut junction = Junction {
                v2: share * a * radius_mm,
                most_v2: a * radius_mm,
                cap_v2: a * radius_mm,
                tangent_mm: radius_mm * (turn / 2.0).tan(),
                cos: turn.cos(),
                sin: turn.sin(),
                half_turn: turn / 2.0,
                half_cos: (turn / 2.0).cos(),
                half_sin: (turn / 2.0).sin(),
            };
            let steps = 20_000_u32;
            let step_mm = radius_mm * turn / 2.0 / f64::from(steps);
            let (mut v2, mut took_s) = (junction.v2, 0.0);
            for _ in 0..steps {
                let across = v2 / radius_mm;
                let along = (a * a - across * across).max(0.0).sqrt();
                let next = (v2 + 2.0 * along * step_mm).min(junction.cap_v2);
                took_s += 2.0 * step_mm / (v2.sqrt() + next.sqrt());
                v2 = next;
            }
            let found = junction.half_arc(junction.v2);
            prop_assert!((found / v2 - 1.0).abs() < 2e-3, "{found} instead of {v2}");
            let found_s = junction.half_arc_s(found.sqrt(), a);
            prop_assert!((found_s / took_s - 1.0).abs() < 0.04, "{found_s} instead of {took_s}");
            junction.v2 = found;
            prop_assert!(junction.half_arc(found) <= junction.cap_v2);
        }
    }
}
