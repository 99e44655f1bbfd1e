//! Distances between points.

/// Returns the distance between two points in the base frame, in mm.
pub(crate) fn distance(from: [f64; 3], to: [f64; 3]) -> f64 {
    let [x, y, z] = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    (x * x + y * y + z * z).sqrt()
}
