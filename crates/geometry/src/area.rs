//! Areas in the plane.

use kurbo::Point;

/// An area to be filled, with its holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Area {
    /// Closed polygons; the last point of each is joined with its first.
    pub rings: Vec<Vec<Point>>,
    /// What counts as inside.
    pub rule: FillRule,
}

/// What counts as the inside of overlapping rings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FillRule {
    /// What the rings go around more often one way than the other.
    #[default]
    NonZero,
    /// What is inside an odd number of rings.
    EvenOdd,
}
