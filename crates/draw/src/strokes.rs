//! From areas and lines to strokes: filled, joined, without duplicates, in order, and with few
//! vectors.

pub(crate) mod cutting;
pub(crate) mod duplicate_lines;
pub(crate) mod hatch;
pub(crate) mod merge;
pub(crate) mod order;
pub(crate) mod simplify;

#[cfg(test)]
pub(crate) mod shapes {
    use dobot_geometry::Point;

    /// A ring of 1000 corners whose edges cross each other half a million times.
    pub(crate) fn tangle() -> Vec<Point> {
        let corner = |i| match (i % 2, f64::from(i) * 0.08) {
            (0, y) => Point::new(0.0, y),
            (_, y) => Point::new(90.0, 80.0 - y),
        };
        (0..1000).map(corner).collect()
    }
}
