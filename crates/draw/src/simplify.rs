//! Fewer, longer vectors: the link carries few, so each has to count.

use crate::point::{Point, Stroke};

/// Merges the segments of a stroke into as few as it finds without leaving it by more than
/// `tolerance_mm`; both ends stay. A stroke shorter than [`MIN_VECTOR_MM`] becomes a dot.
///
/// From its first point the pen looks ahead: every point it passes by opens a wedge of the
/// directions that stay within the tolerance of that point. As long as the next point lies in the
/// intersection of all wedges, and farther out than everything passed by, one vector does.
///
/// ```text
///                    . -- p2 --.
///          p1 . - '              ' - . p3 is out: a vector ends at p2
///        . '  _____--------
///   here <---
///             -----______   <- the wedge: within the tolerance of p1 and of p2
/// ```
#[must_use]
pub fn simplify(stroke: &Stroke, tolerance_mm: f64) -> Stroke {
    let points = without_specks(&stroke.points);
    let tolerance_mm = tolerance_mm - MIN_VECTOR_MM;
    let points = if tolerance_mm > 0.0 {
        merged(&points, tolerance_mm)
    } else {
        points
    };
    Stroke {
        closed: stroke.closed && points.len() > 1,
        points,
    }
}

/// Shorter vectors are merged: they cost as much time on the link as long ones, and a vector of
/// length zero stops a stock arm for good.
pub const MIN_VECTOR_MM: f64 = 0.005;

fn merged(points: &[Point], tolerance_mm: f64) -> Vec<Point> {
    let mut kept = vec![points[0]];
    let mut here = 0;
    while here + 1 < points.len() {
        here = farthest(points, here, tolerance_mm);
        kept.push(points[here]);
    }
    kept
}

/// The last point that one vector from `here` may lead to. A few points that it may not lead to
/// are looked past, as the line may wobble back.
fn farthest(points: &[Point], here: usize, tolerance_mm: f64) -> usize {
    let mut wedge = Wedge::at(points[here], tolerance_mm);
    let mut end = here + 1;
    for (next, &p) in points.iter().enumerate().skip(here + 1) {
        if wedge.allows(p) {
            end = next;
        }
        if !wedge.pass(p) || next > end + LOOK_PAST {
            break;
        }
    }
    end
}

const LOOK_PAST: usize = 16;

/// The directions from `here` that pass all points so far within the tolerance.
struct Wedge {
    here: Point,
    tolerance_mm: f64,
    /// How far out the points so far lie.
    reach_mm: f64,
    /// The two edges, clockwise and counterclockwise; `None` while every direction is fine.
    edges: Option<(Point, Point)>,
}

impl Wedge {
    const fn at(here: Point, tolerance_mm: f64) -> Self {
        Self {
            here,
            tolerance_mm,
            reach_mm: 0.0,
            edges: None,
        }
    }

    /// Whether one vector to `p` passes all points so far within the tolerance.
    fn allows(&self, p: Point) -> bool {
        let way = p - self.here;
        let inside = self
            .edges
            .is_none_or(|(right, left)| right.cross(way) >= 0.0 && way.cross(left) >= 0.0);
        // Points beyond the vector's end would be missed.
        inside && way.length() >= self.reach_mm
    }

    /// Narrows the wedge to the directions that pass `p`; false if none is left.
    fn pass(&mut self, p: Point) -> bool {
        let way = p - self.here;
        let distance = way.length();
        self.reach_mm = self.reach_mm.max(distance);
        if distance <= self.tolerance_mm {
            return true;
        }
        let sin = self.tolerance_mm / distance;
        let cos = (1.0 - sin * sin).sqrt();
        let turned = |sin| Point::new(way.x * cos - way.y * sin, way.x * sin + way.y * cos);
        let (mut right, mut left) = (turned(-sin), turned(sin));
        if let Some((old_right, old_left)) = self.edges {
            if way.dot(old_right) <= 0.0 || way.dot(old_left) <= 0.0 {
                return false;
            }
            right = if old_right.cross(right) > 0.0 {
                right
            } else {
                old_right
            };
            left = if left.cross(old_left) > 0.0 {
                left
            } else {
                old_left
            };
        }
        self.edges = Some((right, left));
        right.cross(left) >= 0.0
    }
}

/// The points without those that are hardly away from the one before; both ends stay.
fn without_specks(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(points.len());
    for &p in points {
        if kept
            .last()
            .is_none_or(|last| last.distance(p) >= MIN_VECTOR_MM)
        {
            kept.push(p);
        }
    }
    let (last, end) = (kept.len() - 1, points[points.len() - 1]);
    if last > 0 {
        kept[last] = end;
    }
    kept
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;
    use crate::deviation::deviation;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    fn circle(radius: f64, count: u32) -> Stroke {
        let at = |i| TAU * f64::from(i % count) / f64::from(count);
        let points = (0..=count).map(|i| Point::new(at(i).cos() * radius, at(i).sin() * radius));
        Stroke {
            points: points.collect(),
            closed: true,
        }
    }

    #[test]
    fn a_straight_line_of_many_points_becomes_one_vector() {
        let wobbly = line(&[
            (0.0, 0.0),
            (1.0, 0.04),
            (2.0, -0.04),
            (3.0, 0.03),
            (9.0, 0.0),
        ]);
        assert_eq!(simplify(&wobbly, 0.05), line(&[(0.0, 0.0), (9.0, 0.0)]));
    }

    #[test]
    fn a_line_that_turns_back_keeps_its_farthest_point() {
        let there_and_back = line(&[(0.0, 0.0), (5.0, 0.0), (2.0, 0.0)]);
        assert_eq!(simplify(&there_and_back, 0.05), there_and_back);
    }

    #[test]
    fn repeated_points_vanish_and_a_speck_becomes_a_dot() {
        let repeated = line(&[(0.0, 0.0), (0.0, 0.0), (4.0, 0.0), (4.0, 0.0)]);
        assert_eq!(simplify(&repeated, 0.05), line(&[(0.0, 0.0), (4.0, 0.0)]));
        let speck = line(&[(1.0, 1.0), (1.001, 1.0)]);
        assert_eq!(simplify(&speck, 0.05), line(&[(1.0, 1.0)]));
    }

    #[test]
    fn a_circle_takes_about_as_many_chords_as_its_sagitta_demands() {
        // A chord of a circle of radius r that leaves it by e has the length 2 sqrt(2 r e).
        let ideal = TAU * 20.0 / (2.0 * (2.0 * 20.0 * 0.045_f64).sqrt());
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let found = (simplify(&circle(20.0, 2000), 0.05).points.len() - 1) as f64;
        assert!(found <= ideal * 1.1 + 1.0, "{found} chords, ideal {ideal}");
    }

    proptest! {
        #[test]
        fn never_leaves_the_stroke_by_more_than_the_tolerance(
            steps in proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 1..60),
            tolerance in 0.02..1.0_f64,
        ) {
            let mut here = Point::default();
            let points = steps.iter().map(|&(x, y)| {
                here = here + Point::new(x, y);
                here
            });
            let stroke = Stroke::open(points.collect());
            let simple = simplify(&stroke, tolerance);
            prop_assert_eq!(simple.points[0], stroke.points[0]);
            if simple.points.len() > 1 {
                prop_assert_eq!(simple.last(), stroke.last());
                let worst = deviation(&[stroke], std::slice::from_ref(&simple)).largest_mm();
                prop_assert!(worst <= tolerance + 1e-9, "{worst} > {tolerance}");
            }
            for (a, b) in simple.segments() {
                prop_assert!(a.distance(b) > 0.0);
            }
        }
    }
}
