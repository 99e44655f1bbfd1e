//! Points of the arm and of what it must not touch.

/// A point in the base frame, in mm.
pub(crate) type Point = [f64; 3];

pub(crate) fn distance(from: Point, to: Point) -> f64 {
    let [x, y, z] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    (x * x + y * y + z * z).sqrt()
}
