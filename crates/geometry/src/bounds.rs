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
