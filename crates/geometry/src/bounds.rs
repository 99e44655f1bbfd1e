//! The upright rectangles around things.

use kurbo::{Point, Rect};

use crate::Stroke;

/// The smallest rectangle that holds these points; of none one inside out, which overlaps nothing
/// and which [`Rect::union_pt`] grows as it should.
pub fn bounds(points: impl IntoIterator<Item = Point>) -> Rect {
    let (most, least) = (f64::INFINITY, f64::NEG_INFINITY);
    let empty = Rect::new(most, most, least, least);
    points
        .into_iter()
        .fold(empty, |bounds, p| bounds.union_pt(p))
}

/// The smallest rectangle that holds these strokes.
#[must_use]
pub fn bounds_of_strokes(strokes: &[Stroke]) -> Rect {
    bounds(strokes.iter().flat_map(|s| s.points.iter().copied()))
}

/// How wide the narrowest strip is in which all points lie, to the nearest degree of its direction.
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
