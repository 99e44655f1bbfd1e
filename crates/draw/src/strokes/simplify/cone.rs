//! Cones of directions from a point that pass others within the tolerance.

use dobot_geometry::Vec2;

/// The directions between two edges less than half a turn apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    /// The clockwise edge, of any length.
    pub(super) right: Vec2,
    /// The counterclockwise edge.
    pub(super) left: Vec2,
}

impl Cone {
    /// Returns the directions that hit a disc of `radius` at `way`; `None` if that is all of them.
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

    /// Whether the cone contains a direction.
    pub(super) fn holds(self, way: Vec2) -> bool {
        self.right.cross(way) >= 0.0 && way.cross(self.left) >= 0.0
    }

    /// Returns the intersection of both cones, if it is not empty.
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
