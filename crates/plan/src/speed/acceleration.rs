//! The acceleration of a planned motion, measured from its positions.

use crate::Plan;
use crate::path::commands::write;
use crate::speed::sampled_acceleration::{at_ticks, second_difference};
use crate::ticks::TICK_S;
use crate::ticks::ticker::Ticker;

/// Returns the maximum acceleration of a plan's motion in mm/s2, from positions sampled every
/// `apart_s` seconds.
///
/// ```text
///   p(t - h) ---> p(t)          |p(t + h) - 2 p(t) + p(t - h)| / h2
///                   \
///                    v p(t + h)
/// ```
///
/// With short intervals, a sharp corner has any acceleration; a stock arm reports its position
/// every 80 ms. Windows start four times per interval, so that no peak is missed.
#[must_use]
pub fn acceleration(plan: &Plan, apart_s: f64) -> f64 {
    let places = places(plan, apart_s / LOOKS);
    let looks = 2 * AHEAD;
    places
        .windows(looks + 1)
        .map(|seen| second_difference(seen[0], seen[AHEAD], seen[looks]) / (apart_s * apart_s))
        .fold(0.0, f64::max)
}

/// Returns the tool position every `step_s` seconds.
fn places(plan: &Plan, step_s: f64) -> Vec<[f64; 3]> {
    if plan.arm_limits().has_ticks {
        between(&ticks(plan), step_s / f64::from(TICK_S))
    } else {
        smooth(plan, step_s)
    }
}

/// Returns the tool position at each tick of a stock arm.
fn ticks(plan: &Plan) -> Vec<[f64; 3]> {
    let mut ticker = Ticker::new(plan.arm_limits(), 0.0);
    let (mut places, mut from) = (vec![plan.start], plan.start);
    for (vector, to) in plan.moves.iter().zip(plan.positions()) {
        let (way, length_mm) = (vector.increments(), vector.length_mm());
        let direction = way.map(|mm| mm / length_mm);
        places.extend(at_ticks(from, direction, &ticker.run(&write(vector))));
        from = to;
    }
    places
}

/// Interpolates positions at a distance of `apart` samples.
fn between(places: &[[f64; 3]], apart: f64) -> Vec<[f64; 3]> {
    let at = |index: u32| {
        let place = f64::from(index) * apart;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an index"
        )]
        let before = place as usize;
        let (a, b) = (places.get(before)?, places.get(before + 1)?);
        let share = place.fract();
        Some([0, 1, 2].map(|i| a[i] + share * (b[i] - a[i])))
    };
    (0..).map_while(at).collect()
}

/// Returns the tool positions of the profiles without ticks.
fn smooth(plan: &Plan, step_s: f64) -> Vec<[f64; 3]> {
    let acceleration = plan.arm_limits().acceleration_mm_s2;
    let (mut places, mut from, mut t_s) = (Vec::new(), plan.start, 0.0);
    for (vector, to) in plan.moves.iter().zip(plan.positions()) {
        let profile = vector.profile(acceleration);
        let way = vector.increments();
        while t_s < profile.duration_s() {
            let share = profile.distance_at(t_s) / profile.distance();
            places.push([0, 1, 2].map(|i| from[i] + share * way[i]));
            t_s += step_s;
        }
        t_s -= profile.duration_s();
        from = to;
    }
    places
}

const LOOKS: f64 = 4.0;
const AHEAD: usize = 4;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::{ArmLimits, DrawingTool, Paper, Pass};
    use dobot_geometry::{Point, Stroke};

    #[test]
    fn a_single_line_uses_the_full_acceleration() {
        let stroke = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(260.0, 0.0)]);
        let pass = Pass::new(DrawingTool::default(), vec![stroke]);
        let arm_limits = ArmLimits {
            acceleration_mm_s2: 50.0,
            ..ArmLimits::default()
        };
        let plan = Plan::new(&[pass], &Paper::default(), &arm_limits).unwrap();
        for apart_s in [0.02, 0.08] {
            let found = acceleration(&plan, apart_s);
            assert!((found - 50.0).abs() < 0.01, "{found}");
        }
    }
}
