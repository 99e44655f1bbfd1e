//! Fewer, longer vectors: the link carries few, so each has to count.

mod cone;
mod corridor;
mod search;
mod snap;
mod visibility;

#[cfg(test)]
mod oracle;

use corridor::Corridor;
use dobot_geometry::{Point, Stroke};
use search::fewest;

/// Draws a stroke with as few vectors as it finds that pass its points in order, each within
/// `tolerance_mm`, and so stay within the tolerance of the stroke everywhere. The ends of an open
/// stroke stay; a closed one stays closed, its begin within the tolerance. A stroke shorter than
/// [`MIN_VECTOR_MM`] becomes a dot.
///
/// Corners need not lie on the stroke: a chord of a curve may swing from one side of it to the
/// other, and is longer by a factor of the square root of two for it. Where it costs no vector
/// they are put on the stroke.
///
/// ```text
///   corner on the curve    _.-----._      free corner   _-'''''-_
///                        .'         '.                *'---------'*
///                       *-------------*              '             '
/// ```
///
/// For short strokes the result never has more vectors than the best choice among the stroke's
/// own points; the work for long ones is bounded, and linear in their points.
#[must_use]
pub fn simplify(stroke: &Stroke, tolerance_mm: f64) -> Stroke {
    let points = simplified(stroke, tolerance_mm - SLACK_MM);
    Stroke {
        closed: stroke.closed && points.len() > 1,
        points,
    }
}

/// Shorter vectors are merged: they cost as much time on the link as long ones, and a vector of
/// length zero stops a stock arm for good.
pub const MIN_VECTOR_MM: f64 = 0.005;

fn simplified(stroke: &Stroke, tolerance_mm: f64) -> Vec<Point> {
    if tolerance_mm > MIN_VECTOR_MM
        && let Some(points) = fewest(&Corridor::new(&stroke.points, stroke.closed, tolerance_mm))
    {
        return points;
    }
    // Specks can leave no way but a vector that is too short.
    let points = without_specks(&stroke.points);
    if tolerance_mm <= 2.0 * MIN_VECTOR_MM || points.len() < 3 {
        return points;
    }
    let corridor = Corridor::new(&points, stroke.closed, tolerance_mm - MIN_VECTOR_MM);
    fewest(&corridor).unwrap_or(points)
}

/// The points without those that are hardly away from the one before; both ends stay.
fn without_specks(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for &p in points {
        if kept
            .last()
            .is_none_or(|last| last.distance(p) >= MIN_VECTOR_MM)
        {
            kept.push(p);
        }
    }
    if let [_, .., last] = &mut kept[..] {
        *last = points[points.len() - 1];
    }
    kept
}

/// What rounding may take of the tolerance.
const SLACK_MM: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::oracle::fewest_between_points;
    use super::*;
    use dobot_geometry::{Vec2, deviation};

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn circle(radius: f64, count: u32) -> Stroke {
        let at = |i| TAU * f64::from(i % count) / f64::from(count);
        let points = (0..=count).map(|i| Point::new(at(i).cos() * radius, at(i).sin() * radius));
        Stroke {
            points: points.collect(),
            closed: true,
        }
    }

    /// A wheel of 53 teeth in a ring of 120: 20,000 segments, 118 mm wide.
    fn spirograph() -> Stroke {
        let (ring, wheel, arm) = (120.0, 53.0, 44.0);
        let scale = 59.0 / (ring - wheel + arm);
        let at = |i: u32| {
            let (sin, cos) = (TAU * wheel * f64::from(i % 20_000) / 20_000.0).sin_cos();
            let turned = TAU * (ring - wheel) * f64::from(i % 20_000) / 20_000.0;
            let rolled = Vec2::new(cos, sin) * (ring - wheel);
            let pen = rolled + Vec2::new(turned.cos(), -turned.sin()) * arm;
            (pen * scale).to_point()
        };
        Stroke {
            points: (0..=20_000).map(at).collect(),
            closed: true,
        }
    }

    fn walk(steps: &[(f64, f64)], closed: bool) -> Stroke {
        let mut points = vec![Point::default()];
        for &(x, y) in steps {
            points.push(points[points.len() - 1] + Vec2::new(x, y));
        }
        if closed {
            points.push(points[0]);
        }
        Stroke { points, closed }
    }

    fn steps() -> impl Strategy<Value = Vec<(f64, f64)>> {
        let any_way = proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 1..60);
        let forward = proptest::collection::vec((0.1..1.0_f64, -0.3..0.3_f64), 1..60);
        let back_and_forth = proptest::collection::vec((-0.5..1.0_f64, -0.02..0.02_f64), 1..60);
        prop_oneof![any_way, forward, back_and_forth]
    }

    fn worst_mm(wanted: &Stroke, drawn: &Stroke) -> f64 {
        deviation(std::slice::from_ref(wanted), std::slice::from_ref(drawn)).largest_mm()
    }

    #[test]
    fn a_straight_line_of_many_points_becomes_one_vector() {
        let wobbly = line(&[
            (0.0, 0.0),
            (1.0, 0.04),
            (2.0, -0.04),
            (3.0, 0.03),
            (9.0, 0.0),
        ]);
        assert_eq!(simplify(&wobbly, 0.05), line(&[(0.0, 0.0), (9.0, 0.0)]));
    }

    #[test]
    fn a_line_that_turns_back_keeps_its_farthest_point() {
        let there_and_back = line(&[(0.0, 0.0), (5.0, 0.0), (2.0, 0.0)]);
        assert_eq!(simplify(&there_and_back, 0.05), there_and_back);
    }

    #[test]
    fn corners_that_cost_nothing_stay_where_they_are() {
        let sides = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
        let mut square = line(&sides);
        square.closed = true;
        let halved = square.segments().flat_map(|(a, b)| [a, a.lerp(b, 0.5)]);
        let mut halved = Stroke {
            points: halved.collect(),
            closed: true,
        };
        halved.points.push(square.points[0]);
        assert_eq!(simplify(&halved, 0.05), square);
    }

    #[test]
    fn repeated_points_vanish_and_a_speck_becomes_a_dot() {
        let repeated = line(&[(0.0, 0.0), (0.0, 0.0), (4.0, 0.0), (4.0, 0.0)]);
        assert_eq!(simplify(&repeated, 0.05), line(&[(0.0, 0.0), (4.0, 0.0)]));
        let speck = line(&[(1.0, 1.0), (1.001, 1.0)]);
        assert_eq!(simplify(&speck, 0.05), line(&[(1.0, 1.0)]));
    }

    #[test]
    fn chords_of_a_circle_swing_from_one_side_to_the_other() {
        // A chord that leaves a circle of radius r by e on both sides has the length 4 sqrt(r e).
        for (radius, count) in [(20.0_f64, 20_000), (20.0, 500), (3.0, 1000), (100.0, 3000)] {
            let ideal = TAU * radius / (4.0 * (radius * 0.05).sqrt());
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            let found = (simplify(&circle(radius, count), 0.05).points.len() - 1) as f64;
            assert!(found <= ideal.ceil() + 1.0, "{found} chords, ideal {ideal}");
        }
    }

    #[test]
    fn a_spirograph_takes_three_quarters_of_the_fewest_vectors_between_its_points() {
        let wanted = spirograph();
        let drawn = simplify(&wanted, 0.05);
        assert!(worst_mm(&wanted, &drawn) <= 0.05);
        assert!(drawn.closed && drawn.points[0] == drawn.points[drawn.points.len() - 1]);
        let fewest = fewest_between_points(&wanted.points, 0.05).expect("a path");
        let found = drawn.points.len() - 1;
        assert!(4 * found <= 3 * fewest, "{found} of {fewest}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn never_leaves_the_stroke_by_more_than_the_tolerance(
            steps in steps(),
            closed: bool,
            tolerance in 0.02..1.0_f64,
        ) {
            let stroke = walk(&steps, closed);
            let simple = simplify(&stroke, tolerance);
            if simple.points.len() > 1 {
                prop_assert!(closed || simple.points[0] == stroke.points[0]);
                prop_assert!(closed || simple.last() == stroke.last());
                let worst = worst_mm(&stroke, &simple);
                prop_assert!(worst <= tolerance, "{worst} > {tolerance}");
            }
            prop_assert_eq!(simple.closed, closed && simple.points.len() > 1);
            prop_assert!(!simple.closed || simple.points[0] == simple.points[simple.points.len() - 1]);
            for (a, b) in simple.segments() {
                prop_assert!(a.distance(b) >= MIN_VECTOR_MM);
            }
        }

        #[test]
        fn never_takes_more_vectors_than_the_best_choice_of_points(
            steps in steps(),
            closed: bool,
            tolerance in 0.02..1.0_f64,
        ) {
            let stroke = walk(&steps, closed);
            let simple = simplify(&stroke, tolerance);
            if let Some(fewest) = fewest_between_points(&stroke.points, tolerance - SLACK_MM) {
                prop_assert!(simple.points.len() - 1 <= fewest, "{simple:?} instead of {fewest}");
            }
        }
    }
}
