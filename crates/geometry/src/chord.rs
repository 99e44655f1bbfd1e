//! The distance of a point from a chord, in any dimension.

/// Returns the distance of a point from the segment between two others, in the unit of their
/// coordinates.
///
/// ```
/// # use dobot_geometry::distance_from_chord;
/// assert_eq!(distance_from_chord([3.0, 4.0], [0.0, 0.0], [10.0, 0.0]), 4.0);
/// assert_eq!(distance_from_chord([13.0, 4.0], [0.0, 0.0], [10.0, 0.0]), 5.0);
/// ```
#[must_use]
pub fn distance_from_chord<const N: usize>(point: [f64; N], from: [f64; N], to: [f64; N]) -> f64 {
    let less = |p: [f64; N], q: [f64; N]| std::array::from_fn(|i| p[i] - q[i]);
    let dot = |p: [f64; N], q: [f64; N]| p.iter().zip(q).map(|(p, q)| p * q).sum::<f64>();
    let (way, off): ([f64; N], [f64; N]) = (less(to, from), less(point, from));
    let length2 = dot(way, way);
    let share = if length2 > 0.0 {
        (dot(off, way) / length2).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let rest: [f64; N] = std::array::from_fn(|i| off[i] - way[i] * share);
    dot(rest, rest).sqrt()
}
