//! Arcs and circles through three points, as straight lines.

use std::f64::consts::TAU;

use dobot_arm::Position;

use crate::axes::{cross, dot};

/// The places along an arc from `from` through `through`; the last one is its end: `to`, or `from`
/// for a full circle. No straight line between them is farther than the tolerance from the arc.
///
/// ```text
///        _ - - _        sagitta = radius (1 - cos(angle / 2))
///      /    |    \
///     o-----+-----o     a line over this angle
/// ```
pub(crate) fn chords(
    [from, through, to]: [Position; 3],
    is_circle: bool,
    tolerance_mm: f64,
) -> Result<Vec<Position>, String> {
    let (a, b) = (through - from, to - from);
    let normal = cross(a, b);
    let area = dot(normal, normal);
    if area.sqrt() < 0.001 * a.length().0.max(b.length().0) || area == 0.0 {
        return Err(
            "the three points of the arc lie on one line; they must lie on a circle".into(),
        );
    }
    let middle =
        from + (cross(normal, a) * dot(b, b) + cross(b, normal) * dot(a, a)) * (0.5 / area);
    let radius = middle.distance(from).0;
    if radius > MAX_RADIUS_MM {
        return Err(format!(
            "the radius of the arc is {radius:.0} mm; allowed are up to {MAX_RADIUS_MM} mm: use a straight line"
        ));
    }
    let x = (from - middle) * (1.0 / radius);
    let y = cross(normal * (1.0 / area.sqrt()), x);
    let angle = |at: Position| {
        dot(at - middle, y)
            .atan2(dot(at - middle, x))
            .rem_euclid(TAU)
    };
    let whole = if is_circle { TAU } else { angle(to) };
    let most = 2.0 * (1.0 - (tolerance_mm / radius).min(1.0)).acos();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "at most some thousands"
    )]
    let count = (whole / most).ceil().max(if is_circle { 3.0 } else { 1.0 }) as u32;
    let at = |n: u32| {
        let (sin, cos) = (whole * f64::from(n) / f64::from(count)).sin_cos();
        middle + x * (radius * cos) + y * (radius * sin)
    };
    let end = if is_circle { from } else { to };
    Ok((1..count).map(at).chain([end]).collect())
}

/// The largest radius; a flatter arc is a line within any arm's reach.
const MAX_RADIUS_MM: f64 = 10_000.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_of_a_circle_stays_within_its_tolerance() {
        let on = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            Position::new(200.0 + 50.0 * cos, 50.0 * sin, 10.0)
        };
        let places = chords([on(0.0), on(30.0), on(90.0)], false, 0.1).unwrap_or_default();
        // 2 acos(1 - 0.1 / 50) is 7.25 degrees.
        assert_eq!(places.len(), 13);
        let mut from = on(0.0);
        for to in places {
            let middle = (from + to) * 0.5;
            let radius = middle.distance(Position::new(200.0, 0.0, 10.0)).0;
            assert!((49.9..50.0).contains(&radius), "{radius}");
            from = to;
        }
        assert!(from.distance(on(90.0)).0 < 1e-9);
    }

    #[test]
    fn a_circle_ends_at_its_start_and_passes_through_its_points() {
        let at = [[200.0, 0.0], [220.0, 20.0], [240.0, 0.0]].map(|[x, y]| Position::new(x, y, 0.0));
        let places = chords(at, true, 0.2).unwrap_or_default();
        assert_eq!(places.last(), Some(&at[0]));
        let middle = Position::new(220.0, 0.0, 0.0);
        assert!(
            places
                .iter()
                .all(|place| (place.distance(middle).0 - 20.0).abs() < 1e-9)
        );
        // It turns left, through the second point.
        assert!(places[0].y.0 > 0.0);
    }

    #[test]
    fn three_points_on_a_line_are_not_an_arc() {
        let at = [200.0, 220.0, 240.0].map(|x| Position::new(x, 0.0, 0.0));
        assert!(chords(at, false, 0.5).is_err_and(|reason| reason.contains("on one line")));
    }
}
