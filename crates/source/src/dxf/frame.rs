//! From the coordinates of an entity to the page.

use dobot_geometry::Point;

/// `origin + across x + along y`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) origin: Point,
    pub(super) across: Point,
    pub(super) along: Point,
}

impl Frame {
    pub(super) const fn scaled(unit_mm: f64) -> Self {
        Self {
            origin: Point::new(0.0, 0.0),
            across: Point::new(unit_mm, 0.0),
            along: Point::new(0.0, unit_mm),
        }
    }

    pub(super) fn point(&self, p: Point) -> Point {
        self.origin + self.way(p)
    }

    pub(super) fn way(&self, way: Point) -> Point {
        self.across * way.x + self.along * way.y
    }

    /// A frame that is told in this one.
    pub(super) fn within(&self, inner: &Self) -> Self {
        Self {
            origin: self.point(inner.origin),
            across: self.way(inner.across),
            along: self.way(inner.along),
        }
    }

    /// Seen from behind: an entity whose extrusion points down counts x to the left.
    pub(super) fn mirrored(&self) -> Self {
        Self {
            across: self.across * -1.0,
            ..*self
        }
    }
}
