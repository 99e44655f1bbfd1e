//! Axes of frames.

use dobot_arm::Position;

/// A frame in the base frame: its origin, and its axes as unit vectors.
///
/// ```text
///          y  third point
///          |  .
///          | .
///   origin o-------> x  second point
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axes {
    origin: Position,
    x: Position,
    y: Position,
    z: Position,
}

impl Axes {
    pub(crate) const BASE: Self = Self {
        origin: Position::new(0.0, 0.0, 0.0),
        x: Position::new(1.0, 0.0, 0.0),
        y: Position::new(0.0, 1.0, 0.0),
        z: Position::new(0.0, 0.0, 1.0),
    };

    /// Creates a frame from three points: its origin, a point on its x axis and a point on the side
    /// of its y axis.
    pub(crate) fn of(origin: Position, on_x: Position, beside: Position) -> Result<Self, String> {
        let x = unit(on_x - origin)
            .ok_or("its second point is its origin; they must be at least 1 mm apart")?;
        let z = unit(cross(x, beside - origin))
            .ok_or("its three points lie on one line; the third must be at least 1 mm beside it")?;
        Ok(Self {
            origin,
            x,
            y: cross(z, x),
            z,
        })
    }

    /// Converts a place in the frame to the base frame.
    pub(crate) fn place(&self, at: [f64; 3]) -> Position {
        self.origin + self.way(at)
    }

    /// Converts a place in the base frame to the frame.
    pub(crate) fn locate(&self, at: Position) -> [f64; 3] {
        [self.x, self.y, self.z].map(|axis| dot(at - self.origin, axis))
    }

    /// Whether the z axis points down.
    pub(crate) const fn is_upside_down(&self) -> bool {
        self.z.z.0 < 0.0
    }

    /// Converts a displacement along the axes to the base frame.
    pub(crate) fn way(&self, [x, y, z]: [f64; 3]) -> Position {
        self.x * x + self.y * y + self.z * z
    }

    /// The rotation of the frame about the vertical, in degrees; 0 if its x axis is vertical.
    pub(crate) fn rotation_deg(&self) -> f64 {
        self.x.direction().0
    }
}

pub(crate) fn cross(a: Position, b: Position) -> Position {
    let ([ax, ay, az], [bx, by, bz]) = (numbers(a), numbers(b));
    Position::new(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
}

pub(crate) fn dot(a: Position, b: Position) -> f64 {
    let (a, b) = (numbers(a), numbers(b));
    (0..3).map(|i| a[i] * b[i]).sum()
}

pub(crate) const fn numbers(at: Position) -> [f64; 3] {
    [at.x.0, at.y.0, at.z.0]
}

/// The direction of a displacement of at least 1 mm.
fn unit(way: Position) -> Option<Position> {
    let length = way.length().0;
    (length >= 1.0).then(|| way * (1.0 / length))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_frame_is_right_angled_and_holds_its_three_points(
            points in prop::array::uniform9(-300.0..300.0_f64),
        ) {
            let [a, b, c, d, e, f, g, h, i] = points;
            let [origin, on_x, beside] = [[a, b, c], [d, e, f], [g, h, i]].map(|[x, y, z]| Position::new(x, y, z));
            let Ok(axes) = Axes::of(origin, on_x, beside) else { return Ok(()); };
            for (one, other, expected) in [
                (axes.x, axes.x, 1.0), (axes.y, axes.y, 1.0), (axes.z, axes.z, 1.0),
                (axes.x, axes.y, 0.0), (axes.y, axes.z, 0.0), (axes.z, axes.x, 0.0),
            ] {
                prop_assert!((dot(one, other) - expected).abs() < 1e-9);
            }
            // Right-handed.
            prop_assert!((dot(cross(axes.x, axes.y), axes.z) - 1.0).abs() < 1e-9);
            let along = origin.distance(on_x).0;
            prop_assert!(axes.place([along, 0.0, 0.0]).distance(on_x).0 < 1e-9);
            let there = axes.place(axes.locate(beside));
            prop_assert!(there.distance(beside).0 < 1e-9);
            // The third point lies in the plane, on the side of y.
            prop_assert!(dot(beside - origin, axes.z).abs() < 1e-6);
            prop_assert!(dot(beside - origin, axes.y) > 0.0);
        }
    }
}
