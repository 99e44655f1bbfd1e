//! Simplification of paths.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use dobot_geometry::distance_from_chord;

/// A simplified path.
#[derive(Clone, Debug, PartialEq)]
pub struct Thinned {
    /// The indices of the remaining points, in order, including the first and the last.
    pub kept: Vec<usize>,
    /// The maximum distance between the original path and that of the arm along the simplified one, in
    /// the unit of the coordinates.
    pub deviation: f64,
    /// The index of the point with that distance, or of the end of the segment that bows so far.
    pub farthest: Option<usize>,
}

/// Removes points of a piecewise linear path until at most `most` segments are left, and fewer if
/// that stays within the tolerance. At least one segment remains, and all `corners`, given by
/// index, are kept.
///
/// `bow` returns how far the arm leaves the straight line between two points, given by index; it is
/// added to the distance of the points between them.
///
/// The segment with the largest deviation is divided first (Ramer, Douglas and Peucker), so that the
/// available segments are used where they help most. The distance combines all coordinates; no
/// single one is farther off.
///
/// ```
/// use dobot_ros2::thinned;
///
/// let corner = [[0.0, 0.0], [5.0, 0.1], [10.0, 0.0], [10.0, 5.0], [10.0, 10.0]];
/// let thin = thinned(&corner, &[], 0.5, 10, |_, _| 0.0);
/// assert_eq!((thin.kept, thin.farthest), (vec![0, 2, 4], Some(1)));
/// assert!((thin.deviation - 0.1).abs() < 1e-12);
/// ```
#[must_use]
pub fn thinned<const N: usize>(
    places: &[[f64; N]],
    corners: &[usize],
    tolerance: f64,
    most: usize,
    bow: impl Fn(usize, usize) -> f64,
) -> Thinned {
    let last = places.len().saturating_sub(1);
    let mut kept: Vec<usize> = [0, last]
        .into_iter()
        .chain(corners.iter().copied())
        .collect();
    kept.retain(|index| *index < places.len());
    kept.sort_unstable();
    kept.dedup();
    let span = |from, to| Span::new(places, from, to, bow(from, to));
    let pieces = kept.windows(2);
    let mut spans: BinaryHeap<Span> = pieces.map(|ends| span(ends[0], ends[1])).collect();
    while let Some(worst) = spans.peek()
        && let Some(at) = worst.at
        && worst.distance > tolerance
        && kept.len() <= most
    {
        let Span { from, to, .. } = *worst;
        spans.pop();
        kept.push(at);
        spans.extend([span(from, at), span(at, to)]);
    }
    kept.sort_unstable();
    let worst = spans.peek().filter(|worst| worst.distance > 0.0);
    Thinned {
        kept,
        deviation: worst.map_or(0.0, |worst| worst.distance),
        farthest: worst.map(|worst| worst.at.unwrap_or(worst.to)),
    }
}

/// A segment, and where it is divided if it deviates too far.
#[derive(Clone, Copy, Debug)]
struct Span {
    from: usize,
    to: usize,
    /// A point between its ends, if there is one.
    at: Option<usize>,
    distance: f64,
}

impl Span {
    /// It is divided at the point farthest from the straight line, or in the middle if the bow is
    /// larger.
    fn new<const N: usize>(places: &[[f64; N]], from: usize, to: usize, bow: f64) -> Self {
        let off = |at: usize| distance_from_chord(places[at], places[from], places[to]);
        let farthest = (from + 1..to).max_by(|a, b| off(*a).total_cmp(&off(*b)));
        let apart = farthest.map_or(0.0, off);
        let middle = (to - from > 1).then_some(usize::midpoint(from, to));
        Self {
            from,
            to,
            at: if apart < bow { middle } else { farthest },
            distance: apart + bow,
        }
    }
}

impl Ord for Span {
    fn cmp(&self, other: &Self) -> Ordering {
        self.distance.total_cmp(&other.distance)
    }
}

impl PartialOrd for Span {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Span {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Span {}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn places() -> impl Strategy<Value = Vec<[f64; 4]>> {
        prop::collection::vec(prop::array::uniform4(-135.0..135.0), 1..60)
    }

    /// Returns the distance of a point from the nearest segment.
    fn off(point: [f64; 4], way: &[[f64; 4]]) -> f64 {
        let pieces = way.windows(2);
        let nearest = pieces
            .map(|ends| distance_from_chord(point, ends[0], ends[1]))
            .min_by(f64::total_cmp);
        nearest.unwrap_or_else(|| distance_from_chord(point, way[0], way[0]))
    }

    proptest! {
        #[test]
        fn no_point_of_the_whole_path_deviates_more_than_reported(
            places in places(), tolerance in 0.0..90.0_f64, most in 0_usize..30,
        ) {
            let thin = thinned(&places, &[], tolerance, most, |_, _| 0.0);
            let way: Vec<[f64; 4]> = thin.kept.iter().map(|index| places[*index]).collect();
            // Also between the points, on the straight segments.
            for ends in places.windows(2) {
                for share in [0.0, 0.3, 0.7, 1.0] {
                    let point = std::array::from_fn(|i| ends[0][i] + (ends[1][i] - ends[0][i]) * share);
                    let found = off(point, &way);
                    prop_assert!(found <= thin.deviation + 1e-9, "{found}, reported {}", thin.deviation);
                }
            }
        }

        #[test]
        fn both_ends_stay_and_there_are_never_more_pieces_than_allowed(
            places in places(), tolerance in 0.0..90.0_f64, most in 0_usize..30,
        ) {
            let thin = thinned(&places, &[], tolerance, most, |_, _| 0.0);
            prop_assert_eq!(thin.kept.first(), Some(&0));
            prop_assert_eq!(thin.kept.last(), Some(&(places.len() - 1)));
            prop_assert!(thin.kept.len() - 1 <= most.max(1), "{:?}", thin.kept);
            prop_assert!(thin.kept.is_sorted_by(|a, b| a < b));
        }

        #[test]
        fn the_tolerance_is_kept_if_enough_pieces_are_allowed(
            places in places(), tolerance in 0.0..90.0_f64,
        ) {
            let thin = thinned(&places, &[], tolerance, places.len(), |_, _| 0.0);
            prop_assert!(thin.deviation <= tolerance, "{}", thin.deviation);
        }
    }

    #[test]
    fn a_straight_path_is_its_two_ends() {
        let way: Vec<[f64; 2]> = (0..100)
            .map(|n| [f64::from(n), 2.0 * f64::from(n)])
            .collect();
        let thin = thinned(&way, &[], 0.001, 50, |_, _| 0.0);
        assert_eq!(thin.kept, [0, 99]);
        assert!(thin.deviation < 1e-9, "{}", thin.deviation);
    }

    #[test]
    fn corners_stay_even_on_a_straight_path_and_other_points_do_not() {
        let way: Vec<[f64; 1]> = (0..10).map(|n| [f64::from(n)]).collect();
        assert_eq!(
            thinned(&way, &[4, 4, 99], 1.0, 1, |_, _| 0.0).kept,
            [0, 4, 9]
        );
    }

    #[test]
    fn an_empty_path_stays_empty() {
        assert!(thinned::<4>(&[], &[], 1.0, 5, |_, _| 0.0).kept.is_empty());
        assert_eq!(thinned(&[[1.0]], &[], 1.0, 5, |_, _| 0.0).kept, [0]);
    }
}
