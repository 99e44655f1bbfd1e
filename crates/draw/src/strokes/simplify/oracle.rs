//! The minimum number of vectors between points of the stroke, by exhaustive search; a reference
//! for tests.

use dobot_geometry::{Line, ParamCurveNearest, Point};

use super::MIN_VECTOR_MM;

/// Returns the number of vectors of the shortest path (Imai and Iri) from point to point of the
/// stroke that hits the discs of all points in between in order. A vector passes at most
/// [`LONGEST`] points.
pub(super) fn fewest_between_points(points: &[Point], tolerance_mm: f64) -> Option<usize> {
    let mut least = vec![None; points.len()];
    least[0] = Some(0);
    for end in 1..points.len() {
        let begins = (end.saturating_sub(LONGEST)..end)
            .filter(|&begin| hits(points, begin, end, tolerance_mm));
        least[end] = begins
            .filter_map(|begin| least[begin])
            .min()
            .map(|count| count + 1);
    }
    least[points.len() - 1]
}

fn hits(points: &[Point], begin: usize, end: usize, tolerance_mm: f64) -> bool {
    let (a, b) = (points[begin], points[end]);
    let length = a.distance(b);
    let mut along: f64 = 0.0;
    length >= MIN_VECTOR_MM
        && points[begin..=end].iter().all(|p| {
            let off = Line::new(a, b).nearest(*p, 0.0).distance_sq.sqrt();
            let middle = (*p - a).dot(b - a) / length;
            let across = (*p - a).cross(b - a) / length;
            let half = (tolerance_mm * tolerance_mm - across * across)
                .max(0.0)
                .sqrt();
            along = along.max(middle - half);
            off <= tolerance_mm && along <= (middle + half).min(length)
        })
}

/// Enough for the tests.
const LONGEST: usize = 100;
