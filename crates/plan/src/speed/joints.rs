//! Tool speed limits that keep the joint speeds within their limits.

use dobot_arm::{FOREARM, REAR_ARM};

use crate::path::vector::length;

/// The speed limit from the joints along a straight vector.
///
/// ```text
///   distance D: pivot to wrist          near the axis           stretched far out
///   alpha, gamma: as in the inverse         |<-r->o                  ___---o
///   kinematics                              |     |             o---'
///   rear = 90 - elevation - alpha      base turns v / r      rear and fore turn v / sin(alpha)
///   fore = gamma - elevation
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointSpeeds {
    /// The maximum speed of base, rear arm and forearm, in rad/s.
    limit_rad_s: f64,
    /// The distance of the tool from the wrist, in mm.
    tool_mm: f64,
}

impl JointSpeeds {
    pub(crate) const fn new(limit_deg_s: f64, tool_mm: f64) -> Self {
        Self {
            limit_rad_s: limit_deg_s.to_radians(),
            tool_mm,
        }
    }

    /// Returns the maximum tool speed along this vector, in mm/s, at most `wanted_mm_s`. Positions
    /// out of reach are ignored; the reach check refuses them.
    pub(crate) fn cap(&self, here: [f64; 3], way: [f64; 3], wanted_mm_s: f64) -> f64 {
        let length_mm = length(way);
        if self.is_easy(here, length_mm, wanted_mm_s) {
            return wanted_mm_s;
        }
        let direction = way.map(|mm| mm / length_mm);
        // The base turns fastest at the closest point to its axis, the two links at the farthest
        // point, which is an end.
        let [x, y, _] = here;
        let flat_v2 = way[0] * way[0] + way[1] * way[1];
        let nearest = if flat_v2 > 0.0 {
            (-(x * way[0] + y * way[1]) / flat_v2).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let fastest_per_mm = [0.0, 0.25, 0.5, 0.75, 1.0, nearest]
            .map(|share| self.turn_per_mm([0, 1, 2].map(|i| here[i] + share * way[i]), direction))
            .into_iter()
            .fold(0.0, f64::max);
        let allowed_mm_s = self.limit_rad_s / fastest_per_mm;
        wanted_mm_s.min(allowed_mm_s.max(self.stretched_mm_s()))
    }

    /// Whether no joint can approach its limit: the wrist stays well between folded and stretched,
    /// the tool away from the axis, and the speed is moderate.
    fn is_easy(&self, [x, y, z]: [f64; 3], length_mm: f64, speed_mm_s: f64) -> bool {
        let reach_mm = (x * x + y * y).sqrt();
        let across_mm = reach_mm - self.tool_mm;
        let distance_mm = (across_mm * across_mm + z * z).sqrt();
        reach_mm - length_mm >= EASY_NEAR_MM
            && distance_mm - length_mm >= EASY_NEAR_MM
            && distance_mm + length_mm <= EASY_FAR_MM
            && speed_mm_s * EASY_PER_MM <= self.limit_rad_s
    }

    /// Returns the rotation per millimetre of the fastest of the three joints at this position, in
    /// rad.
    fn turn_per_mm(&self, [x, y, z]: [f64; 3], [dx, dy, dz]: [f64; 3]) -> f64 {
        let reach_mm = (x * x + y * y).sqrt();
        let across_mm = reach_mm - self.tool_mm;
        let distance_v2 = across_mm * across_mm + z * z;
        let distance_mm = distance_v2.sqrt();
        let cos = |link_mm: f64, sign: f64| {
            (distance_v2 - sign * LINKS_V2) / (2.0 * link_mm * distance_mm)
        };
        let (cos_alpha, cos_gamma) = (cos(REAR_ARM.0, 1.0), cos(FOREARM.0, -1.0));
        if cos_alpha.abs() > 1.0 || reach_mm <= 0.0 {
            return 0.0;
        }
        let base = (x * dy - y * dx) / (reach_mm * reach_mm);
        let outward = (x * dx + y * dy) / reach_mm;
        let away = (across_mm * outward + z * dz) / distance_mm;
        let elevation = (across_mm * dz - z * outward) / distance_v2;
        let opening = |cos: f64, link_mm: f64, sign: f64| {
            let slope = (1.0 + sign * LINKS_V2 / distance_v2) / (2.0 * link_mm);
            -slope * away / (1.0 - cos * cos).max(0.0).sqrt()
        };
        let rear = elevation + opening(cos_alpha, REAR_ARM.0, 1.0);
        let fore = opening(cos_gamma, FOREARM.0, -1.0) - elevation;
        [base, rear, fore]
            .map(f64::abs)
            .into_iter()
            .fold(0.0, f64::max)
    }

    /// Returns the speed that is allowed even with the arm stretched: there a joint turns with the
    /// square root of the distance. In the first tick of 20 ms at v mm/s it turns 36 deg/s times
    /// the square root of v, and slightly more for the elevation.
    fn stretched_mm_s(&self) -> f64 {
        let root = self.limit_rad_s / STRETCHED_RAD_S;
        root * root
    }
}

/// The difference of the squared link lengths.
const LINKS_V2: f64 = FOREARM.0 * FOREARM.0 - REAR_ARM.0 * REAR_ARM.0;
/// Between these distances no joint turns more than `EASY_PER_MM` in any direction: 1 / 80 + 0.0081
/// at 80 mm, 1 / 285 + 0.0144 at 285 mm.
const EASY_NEAR_MM: f64 = 80.0;
const EASY_FAR_MM: f64 = 285.0;
/// In rad.
const EASY_PER_MM: f64 = 0.021;
/// 45 degrees per second.
const STRETCHED_RAD_S: f64 = 45.0 * core::f64::consts::PI / 180.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::{Degrees, Joints, Pose, Position, Tool, inverse};
    use proptest::prelude::*;

    use super::*;

    const PEN_MM: f64 = Tool::SuctionCup.reach().0;

    fn joints([x, y, z]: [f64; 3]) -> Option<[f64; 3]> {
        let pose = Pose {
            position: Position::new(x, y, z),
            rotation: Degrees(0.0),
        };
        let Joints {
            base, rear, fore, ..
        } = inverse(&pose, Tool::SuctionCup).ok()?;
        Some([base.0, rear.0, fore.0])
    }

    /// Returns the fastest joint speed along a vector in ticks of 20 ms, in deg/s.
    fn fastest_deg_s(here: [f64; 3], way: [f64; 3], speed_mm_s: f64) -> Option<f64> {
        let ticks = (length(way) / (speed_mm_s * 0.02)).floor();
        let at = |tick: f64| {
            let share = tick * speed_mm_s * 0.02 / length(way);
            joints([0, 1, 2].map(|i| here[i] + share * way[i]))
        };
        let mut fastest: f64 = 0.0;
        let mut tick = 0.0;
        while tick < ticks {
            let (from, to) = (at(tick)?, at(tick + 1.0)?);
            let turns = (0..3).map(|i| (to[i] - from[i] + 540.0).rem_euclid(360.0) - 180.0);
            fastest = turns.map(|turn| turn.abs() / 0.02).fold(fastest, f64::max);
            tick += 1.0;
        }
        Some(fastest)
    }

    #[test]
    fn in_the_middle_of_the_area_nothing_is_slower() {
        let speeds = JointSpeeds::new(100.0, PEN_MM);
        for x in [170.0, 220.0, 280.0] {
            for way in [[1.0, 0.0, 0.0], [0.0, 30.0, 0.0], [0.0, 0.0, 10.0]] {
                assert_eq!(speeds.cap([x, 10.0, -40.0], way, 80.0), 80.0);
            }
        }
    }

    #[test]
    fn a_stretched_arm_is_slower() {
        let speeds = JointSpeeds::new(100.0, PEN_MM);
        let wrist_mm = 294.9_f64;
        let x = (wrist_mm * wrist_mm - 125.0 * 125.0).sqrt() + PEN_MM;
        let cap = speeds.cap([x, 0.0, -125.0], [-1.0, 0.0, 0.0], 80.0);
        assert!(cap < 40.0, "{cap}");
        assert!(fastest_deg_s([x, 0.0, -125.0], [-5.0, 0.0, 0.0], 80.0).unwrap() > 100.0);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn no_joint_exceeds_its_speed(
            reach_mm in 129.0..321.0_f64,
            base_rad in -3.0..3.0_f64,
            z in -180.0..140.0_f64,
            way in [-60.0..60.0_f64, -60.0..60.0_f64, -20.0..20.0_f64],
            share in 0.01..1.0_f64,
        ) {
            let (sin, cos) = base_rad.sin_cos();
            let here = [reach_mm * cos, reach_mm * sin, z];
            let way = way.map(|mm| mm * share);
            let far = [0, 1, 2].map(|i| here[i] + way[i]);
            prop_assume!(joints(here).is_some() && joints(far).is_some() && length(way) > 0.01);
            // Closer positions, with the arm folded, are not allowed for drawing.
            prop_assume!(far[0].hypot(far[1]) >= 129.0);
            let cap = JointSpeeds::new(100.0, PEN_MM).cap(here, way, 80.0);
            prop_assert!(cap > 0.0 && cap <= 80.0);
            if let Some(found) = fastest_deg_s(here, way, cap) {
                prop_assert!(found <= 105.0, "{found} deg/s at {cap} mm/s");
            }
        }

        #[test]
        fn an_easy_vector_is_one_that_no_joint_limits(
            reach_mm in 80.0..345.0_f64,
            z in -180.0..140.0_f64,
            way in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64],
        ) {
            let speeds = JointSpeeds::new(100.0, PEN_MM);
            let (here, length_mm) = ([reach_mm, 0.0, z], length(way));
            prop_assume!(length_mm > 0.01 && speeds.is_easy(here, length_mm, 80.0));
            let turns = speeds.turn_per_mm(here, way.map(|mm| mm / length_mm));
            prop_assert!(turns <= EASY_PER_MM, "{turns}");
        }
    }
}
