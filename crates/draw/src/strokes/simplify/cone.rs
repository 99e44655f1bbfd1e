//! The directions from a point that pass others within the tolerance.

use dobot_geometry::Vec2;

/// What lies between two edges that are less than half a turn apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    /// The clockwise edge, of any length.
    pub(super) right: Vec2,
    /// The counterclockwise edge.
    pub(super) left: Vec2,
}

impl Cone {
    /// The directions that hit a disc of `radius` a `way` off; `None` where that is all of them.
    pub(super) fn to_disc(way: Vec2, radius: f64) -> Option<Self> {
        let tangent2 = way.hypot2() - radius * radius;
        (tangent2 > 0.0).then(|| {
            let (sin, cos) = (radius, tangent2.sqrt());
            let turned = |sin: f64| way.rotate_scale(Vec2::new(cos, sin));
            Self {
                right: turned(-sin),
                left: turned(sin),
            }
        })
    }

    /// Whether a direction is one of them.
    pub(super) fn holds(self, way: Vec2) -> bool {
        self.right.cross(way) >= 0.0 && way.cross(self.left) >= 0.0
    }

    /// The directions of both, if there are any.
    pub(super) fn and(self, other: Self) -> Option<Self> {
        let right = if self.holds(other.right) {
            other.right
        } else if other.holds(self.right) {
            self.right
        } else {
            return None;
        };
        let left = if self.holds(other.left) {
            other.left
        } else {
            self.left
        };
        Some(Self { right, left })
    }
}
