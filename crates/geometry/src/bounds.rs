//! Bounding boxes.

use kurbo::{Point, Rect};

use crate::Stroke;

/// Returns the smallest rectangle that holds these points. Without points it is inverted: it
/// overlaps nothing, and [`Rect::union_pt`] extends it correctly.
pub fn bounds(points: impl IntoIterator<Item = Point>) -> Rect {
    let (most, least) = (f64::INFINITY, f64::NEG_INFINITY);
    let empty = Rect::new(most, most, least, least);
    points
        .into_iter()
        .fold(empty, |bounds, p| bounds.union_pt(p))
}

/// Returns the smallest rectangle that holds these strokes.
#[must_use]
pub fn bounds_of_strokes(strokes: &[Stroke]) -> Rect {
    bounds(strokes.iter().flat_map(|s| s.points.iter().copied()))
}

/// Returns the width of the narrowest strip that holds all points, with its direction in whole
/// degrees.
#[must_use]
pub fn least_width(points: &[Point]) -> f64 {
    let across = |deg: i32| {
        let (sin, cos) = f64::from(deg).to_radians().sin_cos();
        let along = points.iter().map(|point| point.x * cos + point.y * sin);
        let (least, most) = along.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        most - least
    };
    (0..180).map(across).fold(f64::MAX, f64::min)
}
