//! Areas in the plane.

use kurbo::Point;

/// An area to fill, with its holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Area {
    /// Closed polygons: the last point of each connects to the first.
    pub rings: Vec<Vec<Point>>,
    /// The fill rule.
    pub rule: FillRule,
}

/// The rule that decides which points lie inside overlapping rings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FillRule {
    /// Points with a winding number other than zero.
    #[default]
    NonZero,
    /// Points inside an odd number of rings.
    EvenOdd,
}

/// Returns the edges of a ring, whose last point connects to the first.
pub fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    let ends = ring.iter().cycle().skip(1);
    ring.iter().copied().zip(ends.copied())
}
