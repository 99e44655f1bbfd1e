//! Detours around the arm's own position.

use std::f64::consts::PI;

use dobot_geometry::{Point, Vec2};

/// Returns the corners of a path that keeps `nearest_mm` from the arm's axis (or the distance of
/// its ends, if smaller) and passes in front of the arm. There are none if the straight path does
/// that.
///
/// ```text
///              .--------.
///   from ----'    __      '---- to       an arc around the axis, and the lines that touch it;
///                /  \                    the arc is a polygon around it
///                \__/
/// ```
#[must_use]
pub fn detour(from: Point, to: Point, nearest_mm: f64) -> Vec<Point> {
    let (from, to) = (from.to_vec2(), to.to_vec2());
    let radius_mm = nearest_mm.min(from.hypot()).min(to.hypot());
    if radius_mm <= 0.0 {
        return Vec::new();
    }
    // Angles range from -pi to pi, so the path between them passes x > 0.
    let touches = |p: Vec2| (radius_mm / p.hypot()).min(1.0).acos();
    let turn = to.atan2() - from.atan2();
    // The straight path is free if the two tangents already cover the whole turn.
    let arc = turn.abs() - touches(from) - touches(to);
    if arc <= 0.0 {
        return Vec::new();
    }
    let side = turn.signum();
    let first = from.atan2() + side * touches(from);
    #[expect(clippy::cast_possible_truncation, reason = "at most a few dozen")]
    #[expect(clippy::cast_sign_loss, reason = "an arc is above 0")]
    let count = (arc / MAX_STEP).ceil() as u32;
    let step = arc / f64::from(count);
    let corner_mm = radius_mm / (0.5 * step).cos();
    let corner = |i: u32| first + side * step * (f64::from(i) + 0.5);
    (0..count)
        .map(|i| (Vec2::from_angle(corner(i)) * corner_mm).to_point())
        .collect()
}

/// The polygon is at most 3.5 % farther from the axis than the arc.
const MAX_STEP: f64 = PI / 6.0;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Returns the minimum distance of a path from the axis, and whether it passes behind it.
    fn nearest_mm(way: &[Point]) -> (f64, bool) {
        let legs = way.windows(2).map(|pair| {
            let (a, leg) = (pair[0].to_vec2(), pair[1] - pair[0]);
            let along = (-a.dot(leg) / leg.hypot2().max(1e-12)).clamp(0.0, 1.0);
            let passes_behind = a.y * (a.y + leg.y) < 0.0 && {
                let share = a.y / (a.y - (a.y + leg.y));
                a.x + share * leg.x < 0.0
            };
            ((a + leg * along).hypot(), passes_behind)
        });
        legs.fold((f64::INFINITY, false), |all, leg| {
            (all.0.min(leg.0), all.1 || leg.1)
        })
    }

    fn whole(from: Point, to: Point, nearest_mm: f64) -> Vec<Point> {
        let between = detour(from, to, nearest_mm);
        [vec![from], between, vec![to]].concat()
    }

    #[test]
    fn a_free_path_stays_straight() {
        let [a, b] = [Point::new(200.0, -100.0), Point::new(200.0, 100.0)];
        assert!(detour(a, b, 150.0).is_empty());
        assert_eq!(detour(a, a, 150.0), []);
    }

    #[test]
    fn a_path_from_one_side_of_the_arm_to_the_other_passes_the_front() {
        let [a, b] = [Point::new(0.0, -220.0), Point::new(0.0, 220.0)];
        let way = whole(a, b, 150.0);
        assert!(way[1..way.len() - 1].iter().all(|p| p.x > 100.0), "{way:?}");
        // Two tangents and the arc between them.
        let length_mm: f64 = way.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let touching_mm = (220.0_f64.powi(2) - 150.0_f64.powi(2)).sqrt();
        let arc = PI - 2.0 * (150.0_f64 / 220.0).acos();
        let shortest_mm = 2.0 * touching_mm + 150.0 * arc;
        let ratio = length_mm / shortest_mm;
        assert!(
            (1.0..1.02).contains(&ratio),
            "{length_mm} mm, {shortest_mm} mm"
        );
    }

    proptest! {
        #[test]
        fn no_path_leads_nearer_to_the_axis_than_its_ends_or_behind_it(
            from in (100.0..320.0, -2.3..2.3),
            to in (100.0..320.0, -2.3..2.3),
            least_mm in 0.0..200.0,
        ) {
            let [a, b] = [from, to].map(|(mm, angle)| (Vec2::from_angle(angle) * mm).to_point());
            let way = whole(a, b, least_mm);
            let (found_mm, passes_behind) = nearest_mm(&way);
            let allowed_mm = f64::min(least_mm, f64::min(from.0, to.0));
            prop_assert!(found_mm >= allowed_mm - 1e-9, "{found_mm} mm: {way:?}");
            prop_assert!(!passes_behind || least_mm == 0.0, "{way:?}");
            let farthest_mm = f64::max(f64::max(from.0, to.0), allowed_mm * 1.036);
            prop_assert!(way.iter().all(|p| p.to_vec2().hypot() <= farthest_mm + 1e-9), "{way:?}");
        }
    }
}
