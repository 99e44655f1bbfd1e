//! Areas in the plane.

use kurbo::Point;

/// An area to be filled, with its holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Area {
    /// Closed polygons; the last point of each is joined with its first.
    pub rings: Vec<Vec<Point>>,
    /// The rule that says which points are inside.
    pub rule: FillRule,
}

/// The rule that says which points are inside overlapping rings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FillRule {
    /// Points around which the rings go more often one way than the other.
    #[default]
    NonZero,
    /// Points inside an odd number of rings.
    EvenOdd,
}
