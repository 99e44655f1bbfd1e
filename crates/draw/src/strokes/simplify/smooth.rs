//! Smoothing: a path without the tremor of a stroke's points, which an arm executes fastest.
//!
//! Points from a hand, a tablet or a scan scatter to both sides of the intended line. Within the
//! tolerance, each point moves to where the curvature changes evenly from the two points before it
//! to the two after it.
//!
//! ```text
//!      *             *                    given: each * turns the tool, which has to be slow
//!   *.....*.......*.....*.......*         smooth: ........
//!             *             *
//! ```

use std::ops::Range;

use dobot_geometry::{Point, Vec2};

use super::MIN_VECTOR_MM;
use super::corridor::{Corner, Corridor};

/// Returns the points of a stroke without those that barely differ from the one before; `None` if
/// that leaves the corridor, or the stroke has too many points.
pub(super) fn as_given(corridor: &Corridor<'_>) -> Option<Vec<Corner>> {
    if corridor.points.len() > NODES.end {
        return None;
    }
    let nodes = nodes(corridor.points, MIN_VECTOR_MM);
    let at = nodes.iter().map(|&node| corridor.points[node]).collect();
    within(corridor, at, &nodes)
}

/// Returns a path along some points of a stroke with the most even curvature that a part of the
/// tolerance allows; `None` if it leaves the corridor, or the stroke has too few or too many
/// points. Both ends are kept.
pub(super) fn smooth(corridor: &Corridor<'_>) -> Option<Vec<Corner>> {
    let nodes = nodes(corridor.points, SPACING_MM);
    let given: Vec<Point> = nodes.iter().map(|&node| corridor.points[node]).collect();
    let mut at = given.clone();
    let last = at.len() - 1;
    if !NODES.contains(&last) {
        return None;
    }
    for _ in 0..ROUNDS {
        for i in 1..last {
            let wanted = bent_evenly(&at, i);
            let off = wanted - given[i];
            // Limit the displacement, so that the vectors in between still have some tolerance.
            let most_mm = SHARE * corridor.radii[nodes[i]];
            at[i] = given[i] + off * (most_mm / off.length().max(most_mm));
        }
    }
    within(corridor, at, &nodes)
}

/// Returns the position of a point that minimises the squared second differences.
fn bent_evenly(at: &[Point], i: usize) -> Point {
    let last = at.len() - 1;
    let sum = |shares: &[(usize, f64)]| -> Point {
        let sum: Vec2 = shares
            .iter()
            .map(|(i, share)| at[*i].to_vec2() * *share)
            .sum();
        sum.to_point()
    };
    if i == 1 {
        sum(&[(0, 0.4), (2, 0.8), (3, -0.2)])
    } else if i + 1 == last {
        sum(&[(last, 0.4), (i - 1, 0.8), (i - 2, -0.2)])
    } else {
        let (near, far) = (4.0 / 6.0, -1.0 / 6.0);
        sum(&[(i - 2, far), (i - 1, near), (i + 1, near), (i + 2, far)])
    }
}

/// Returns the points to keep at a minimum spacing, in mm, including both ends.
fn nodes(points: &[Point], spacing_mm: f64) -> Vec<usize> {
    let last = points.len() - 1;
    let mut nodes = vec![0];
    for i in 1..last {
        let away = |other: usize| points[i].distance(points[other]) >= spacing_mm;
        if away(nodes[nodes.len() - 1]) && away(last) {
            nodes.push(i);
        }
    }
    nodes.push(last);
    nodes
}

/// Returns a path along points of the stroke, if all of its vectors stay in the corridor.
fn within(corridor: &Corridor<'_>, at: Vec<Point>, nodes: &[usize]) -> Option<Vec<Corner>> {
    let corners = at.into_iter().zip(nodes).map(|(at, &passed)| Corner {
        at,
        passed,
        before: 0,
    });
    let path: Vec<Corner> = corners.collect();
    let passes = |pair: &[Corner]| {
        pair[0].at.distance(pair[1].at) >= MIN_VECTOR_MM
            && corridor.passes(pair[0].at, pair[1].at, pair[0].passed + 1, pair[1].passed)
    };
    path.windows(2).all(passes).then_some(path)
}

/// The spacing of the smoothed points.
const SPACING_MM: f64 = 0.25;
/// Fewer points cannot be smoothed; more would take longer than they save, and several times the
/// memory of the stroke.
const NODES: Range<usize> = 4..50_000;
/// The number of times each point is moved: removes tremor over a dozen points.
const ROUNDS: usize = 200;
/// The maximum displacement of a point, as a share of the tolerance: the rest is for the vectors.
const SHARE: f64 = 0.6;

#[cfg(test)]
mod tests {
    use dobot_geometry::Random;

    use super::*;

    /// An arc of 20 mm radius in points 0.3 mm apart, each with an error of up to 0.02 mm.
    fn trembling_arc() -> Vec<Point> {
        let mut random = Random::new(3);
        let mut off = || 0.02 * (2.0 * random.share() - 1.0);
        let arc = (0..150).map(|i| Vec2::from_angle(0.015 * f64::from(i)) * 20.0);
        arc.map(|p| p.to_point() + Vec2::new(off(), off()))
            .collect()
    }

    #[test]
    fn tremor_is_removed_and_the_curve_is_kept() {
        let points = trembling_arc();
        let corridor = Corridor::new(&points, false, 0.045);
        let path = smooth(&corridor).expect("a path");
        let turn = |at: &[Point]| {
            let (incoming, outgoing) = (at[1] - at[0], at[2] - at[1]);
            incoming.cross(outgoing).atan2(incoming.dot(outgoing))
        };
        let sharpest = |at: &[Point]| {
            at.windows(3)
                .map(|three| turn(three).abs())
                .fold(0.0, f64::max)
        };
        let at: Vec<Point> = path.iter().map(|corner| corner.at).collect();
        // The intended turns are 0.015.
        assert!(sharpest(&points) > 0.1, "{}", sharpest(&points));
        assert!(sharpest(&at[1..at.len() - 1]) < 0.025, "{}", sharpest(&at));
        // Both ends keep their places, off the arc.
        let inner = &at[5..at.len() - 5];
        let off_mm = inner.iter().map(|p| (p.to_vec2().length() - 20.0).abs());
        let off_mm = off_mm.fold(0.0, f64::max);
        assert!(off_mm < 0.02, "{off_mm} mm");
        assert_eq!([at[0], at[at.len() - 1]], [points[0], points[149]]);
    }

    #[test]
    fn few_points_and_turns_closer_than_the_spacing_are_unchanged() {
        let zigzag = [(0.0, 0.0), (1.0, 0.0), (0.0, 0.1)].map(Point::from);
        assert!(smooth(&Corridor::new(&zigzag, false, 0.045)).is_none());
        // Loops 0.1 mm wide, which a path along points 0.25 mm apart cannot follow.
        let at = |i: i32| Point::new(0.01 * f64::from(i), 0.1 * (0.2 * f64::from(i)).sin());
        let loops: Vec<Point> = (0..500).map(at).collect();
        let corridor = Corridor::new(&loops, false, 0.02);
        assert!(smooth(&corridor).is_none());
        assert_eq!(as_given(&corridor).expect("a path").len(), loops.len());
    }
}
