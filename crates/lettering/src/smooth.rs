//! Smoothing of glyphs: curves through the corners of coarse polygons.
//!
//! The fonts were digitised for letters a few millimetres tall; larger ones would show corners. A
//! stroke is split at sharp turns. In between, each corner gets the tangent of the circle through
//! it and its neighbours, and the ends of long straight pieces get the direction of the piece, so
//! that stems stay straight and meet their bows smoothly.

use dobot_geometry::{CubicBez, Point, Vec2, chords, corners};

/// Rounds the gentle corners of a stroke, within `tolerance` of the curve through them.
pub(crate) fn smooth(points: &[Point], sharp: f64, tolerance: f64) -> Vec<Point> {
    let mut points = points.to_vec();
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let is_closed = points.first() == points.last();
    let tangents = tangents(&points, is_closed, sharp);
    let mut smooth = vec![points[0]];
    for (pair, ends) in points.windows(2).zip(tangents.windows(2)) {
        curve(
            [pair[0], pair[1]],
            ends[0].after,
            ends[1].before,
            tolerance,
            &mut smooth,
        );
    }
    smooth
}

/// The directions in which a curve arrives at a corner and leaves it; `None` leaves it free.
#[derive(Clone, Copy, Debug, Default)]
struct Tangent {
    before: Option<Vec2>,
    after: Option<Vec2>,
}

fn tangents(points: &[Point], is_closed: bool, sharp: f64) -> Vec<Tangent> {
    let last = points.len() - 1;
    let neighbours = |i: usize| match (i, is_closed) {
        (0, true) => Some((points[last - 1], points[1])),
        (0, false) => None,
        (i, true) if i == last => Some((points[last - 1], points[1])),
        (i, false) if i == last => None,
        (i, _) => Some((points[i - 1], points[i + 1])),
    };
    let at = |i| match neighbours(i) {
        Some((before, after)) => tangent(before, points[i], after, sharp),
        None => Tangent::default(),
    };
    (0..points.len()).map(at).collect()
}

fn tangent(a: Point, b: Point, c: Point, sharp: f64) -> Tangent {
    let (before, after) = (unit(b - a), unit(c - b));
    let (way, next) = (a.distance(b), b.distance(c));
    if before.cross(after).atan2(before.dot(after)).abs() > sharp {
        return Tangent::default();
    }
    let along = match (way > STRAIGHT, next > STRAIGHT) {
        (true, true) => return Tangent::default(),
        (true, false) => before,
        (false, true) => after,
        // Use the tangent of the circle through the three points.
        (false, false) => unit(before * next + after * way),
    };
    Tangent {
        before: Some(along),
        after: Some(along),
    }
}

/// Returns the curve from one corner to the next, without the first point.
fn curve(
    [a, d]: [Point; 2],
    leaving: Option<Vec2>,
    coming: Option<Vec2>,
    tolerance: f64,
    points: &mut Vec<Point>,
) {
    let chord = unit(d - a);
    let Some((leaving, coming)) = with_mirrored(chord, leaving, coming) else {
        return points.push(d);
    };
    let reach = a.distance(d) / 3.0;
    let (b, c) = (a + leaving * reach, d - coming * reach);
    let curve = CubicBez::new(a, b, c, d);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small count"
    )]
    let count = chords(curve, tolerance).min(MAX_CHORDS) as u32;
    points.extend(corners(curve, count));
}

/// Returns both tangents of a curve; `None` if both ends are free.
fn with_mirrored(chord: Vec2, leaving: Option<Vec2>, coming: Option<Vec2>) -> Option<(Vec2, Vec2)> {
    // Mirror the other tangent at a free end, which continues the curve like a circle.
    let mirrored = |other: Vec2| chord * (2.0 * chord.dot(other)) - other;
    match (leaving, coming) {
        (None, None) => None,
        (Some(from), None) => Some((from, mirrored(from))),
        (None, Some(to)) => Some((mirrored(to), to)),
        (Some(from), Some(to)) => Some((from, to)),
    }
}

fn unit(way: Vec2) -> Vec2 {
    way * (1.0 / way.length().max(f64::MIN_POSITIVE))
}

/// Segments longer than this, in grid units, are straight by design.
const STRAIGHT: f64 = 5.5;
const MAX_CHORDS: f64 = 1000.0;

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use dobot_geometry::{Line, ParamCurveNearest};

    use super::*;

    fn points(points: &[(f64, f64)]) -> Vec<Point> {
        points.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn a_polygon_of_twelve_corners_becomes_a_circle() {
        let corner = |i| {
            let (sin, cos) = (TAU * f64::from(i % 12) / 12.0).sin_cos();
            Point::new(8.0 * cos, 8.0 * sin)
        };
        let round = smooth(&(0..=12).map(corner).collect::<Vec<_>>(), 1.0, 0.001);
        for (a, b) in round.iter().zip(&round[1..]) {
            let radius = a.lerp(*b, 0.5).to_vec2().length();
            assert!((radius - 8.0).abs() < 0.02, "{radius}");
        }
    }

    #[test]
    fn sharp_corners_and_straight_lines_stay() {
        let zigzag = points(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        assert_eq!(smooth(&zigzag, 1.0, 0.01), zigzag);
        let straight = points(&[(0.0, 0.0), (3.0, 0.0), (6.0, 0.0)]);
        assert_eq!(smooth(&straight, 1.0, 0.01), straight);
    }

    #[test]
    fn a_stem_stays_straight_where_it_meets_a_bow() {
        let hook = points(&[(0.0, 0.0), (0.0, 15.0), (1.0, 18.0), (4.0, 20.0)]);
        let round = smooth(&hook, 1.0, 0.01);
        assert_eq!(round[..2], hook[..2]);
        assert!(round.len() > 8);
    }

    proptest! {
        #[test]
        fn every_corner_stays_and_the_line_does_not_stray(
            corners in proptest::collection::vec((-20.0..20.0_f64, -20.0..20.0_f64), 1..12),
        ) {
            let corners = points(&corners);
            let round = smooth(&corners, 1.0, 0.05);
            let mut rest = round.iter();
            for corner in &corners {
                prop_assert!(rest.any(|p| p == corner));
            }
            for p in &round {
                let nearest = corners.windows(2).map(|line| Line::new(line[0], line[1]).nearest(*p, 0.0).distance_sq.sqrt());
                prop_assert!(corners.len() < 3 || nearest.fold(f64::INFINITY, f64::min) < 3.0);
            }
        }
    }
}
