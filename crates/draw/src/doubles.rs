//! Lines that are drawn twice.

use std::collections::HashSet;

use dobot_geometry::{Point, Stroke};

/// Strokes without those that lie on another one from end to end, whichever way they go, and how many
/// these were. What differs by less than the tolerance may be the same.
pub(crate) fn without_doubles(strokes: Vec<Stroke>, tolerance_mm: f64) -> (Vec<Stroke>, usize) {
    let before = strokes.len();
    let mut seen = HashSet::new();
    let mut kept = strokes;
    kept.retain(|it| seen.insert(corners(&it.points, tolerance_mm)));
    let count = before - kept.len();
    (kept, count)
}

/// The corners in an order of their own: those of a line there and back, or around from anywhere, are the same.
fn corners(points: &[Point], tolerance_mm: f64) -> Vec<[i64; 2]> {
    #[expect(clippy::cast_possible_truncation, reason = "on a table")]
    let rounded = |mm: f64| (mm / tolerance_mm).round() as i64;
    let corners = points.iter().map(|p| [rounded(p.x), rounded(p.y)]);
    let mut corners: Vec<_> = corners.collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&it| Point::from(it)).collect())
    }

    #[test]
    fn a_line_that_lies_on_another_is_dropped_whichever_way_it_goes() {
        let square = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0), (0.0, 0.0)];
        let from_elsewhere = [(9.0, 9.0), (9.0, 0.0), (0.0, 0.0), (0.0, 9.0), (9.0, 9.0)];
        let strokes = vec![
            line(&[(0.0, 0.0), (5.0, 5.0)]),
            line(&[(5.001, 5.0), (0.0, 0.001)]),
            line(&square),
            line(&from_elsewhere),
            line(&[(0.0, 0.0), (5.0, 5.2)]),
        ];
        let (kept, count) = without_doubles(strokes.clone(), 0.05);
        assert_eq!(count, 2);
        assert_eq!(kept, [0, 2, 4].map(|i: usize| strokes[i].clone()));
    }
}
