//! The deviation of a drawn path from the wanted one.

use kurbo::Point;

use crate::{SegmentIndex, Stroke, steps};

/// The distance between two paths in both directions, because stray ink and missing ink are
/// different faults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The drawn point farthest from the wanted path.
    pub astray: WorstPoint,
    /// The wanted point farthest from the drawn path.
    pub missed: WorstPoint,
}

impl Deviation {
    /// Returns the larger of the two distances, in millimetres.
    #[must_use]
    pub fn largest_mm(&self) -> f64 {
        self.astray.distance_mm.max(self.missed.distance_mm)
    }
}

/// The point of a path with the largest distance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorstPoint {
    /// The distance to the other path, in millimetres; infinite if that one is empty.
    pub distance_mm: f64,
    /// The point.
    pub at: Point,
}

/// Compares the wanted path with the drawn one, at every corner and at least every half millimetre.
#[must_use]
pub fn deviation(wanted: &[Stroke], drawn: &[Stroke]) -> Deviation {
    Deviation {
        astray: farthest(drawn, wanted),
        missed: farthest(wanted, drawn),
    }
}

/// A path prepared for distance queries.
///
/// It remembers the last nearest segment, because consecutive queries along another path are close
/// together.
#[derive(Debug)]
pub struct PathDistance {
    index: SegmentIndex,
    last: u32,
}

impl PathDistance {
    /// Prepares a path for distance queries.
    #[must_use]
    pub fn new(path: &[Stroke]) -> Self {
        Self {
            index: SegmentIndex::new(short(once(path))),
            last: 0,
        }
    }

    /// Returns the distance in mm; infinite without a path. Distances below a ten-thousandth of a
    /// millimetre are not distinguished.
    pub fn distance_mm(&mut self, p: Point) -> f64 {
        self.distance_from_mm(p, NEGLIGIBLE_MM)
    }

    /// Like [`distance_mm`](Self::distance_mm), but returns any value up to `enough_mm` if the
    /// distance is at most that.
    fn distance_from_mm(&mut self, p: Point, enough_mm: f64) -> f64 {
        match self.index.nearest_from(self.last, p, enough_mm * enough_mm) {
            Some((item, distance2)) => {
                self.last = item;
                distance2.sqrt()
            }
            None => f64::INFINITY,
        }
    }
}

/// Returns the point of `path` farthest from `other`.
fn farthest(path: &[Stroke], other: &[Stroke]) -> WorstPoint {
    let mut near = PathDistance::new(other);
    farthest_from(path, &mut near)
}

fn farthest_from(path: &[Stroke], near: &mut PathDistance) -> WorstPoint {
    let points = path
        .iter()
        .flat_map(pieces)
        .flat_map(|(from, to)| steps(from, to, STEP_MM));
    points.fold(WorstPoint::default(), |worst, at| {
        // A point closer than the farthest one found does not need an exact distance.
        let enough_mm = worst.distance_mm.max(NEGLIGIBLE_MM);
        let distance_mm = near.distance_from_mm(at, enough_mm);
        if distance_mm > worst.distance_mm {
            WorstPoint { distance_mm, at }
        } else {
            worst
        }
    })
}

/// Returns each segment of a path once, regardless of its direction: a search would have to visit
/// all duplicates.
fn once(path: &[Stroke]) -> Vec<(Point, Point)> {
    let order = |a: &Point, b: &Point| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
    let one_way = |(a, b): (Point, Point)| {
        if order(&a, &b).is_le() {
            (a, b)
        } else {
            (b, a)
        }
    };
    let mut segments: Vec<_> = path.iter().flat_map(pieces).map(one_way).collect();
    segments.sort_unstable_by(|a, b| order(&a.0, &b.0).then(order(&a.1, &b.1)));
    segments.dedup();
    segments
}

/// Splits segments into short ones, because the boxes of long ones would overlap.
fn short(segments: Vec<(Point, Point)>) -> Vec<(Point, Point)> {
    let length_mm: f64 = segments.iter().map(|(a, b)| a.distance(*b)).sum();
    let most_mm = SHORT_MM.max(length_mm / MAX_PIECES);
    let cut = |(a, b): (Point, Point)| {
        let ends: Vec<Point> = steps(a, b, most_mm).collect();
        let pieces = ends.windows(2).map(|pair| (pair[0], pair[1]));
        pieces.collect::<Vec<_>>()
    };
    segments.into_iter().flat_map(cut).collect()
}

/// Returns the segments of a stroke; for a dot its point.
fn pieces(stroke: &Stroke) -> impl Iterator<Item = (Point, Point)> {
    let dot = stroke.points.first().filter(|_| stroke.points.len() == 1);
    stroke.segments().chain(dot.map(|&p| (p, p)))
}

const STEP_MM: f64 = 0.5;
/// Smaller distances are irrelevant to the arm and invisible.
const NEGLIGIBLE_MM: f64 = 1e-4;
const SHORT_MM: f64 = 1.0;
/// The approximate upper limit on the number of pieces.
const MAX_PIECES: f64 = 500_000.0;

#[cfg(test)]
mod tests {
    use kurbo::Vec2;

    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn distinguishes_stray_ink_from_missing_ink() {
        let wanted = [line(&[(0.0, 0.0), (10.0, 0.0)])];
        let drawn = [line(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)])];
        let found = deviation(&wanted, &drawn);
        assert_eq!(
            found.astray,
            WorstPoint {
                distance_mm: 3.0,
                at: Point::new(4.0, 3.0)
            }
        );
        assert_eq!(
            found.missed,
            WorstPoint {
                distance_mm: 6.0,
                at: Point::new(10.0, 0.0)
            }
        );
        assert_eq!(found.largest_mm(), 6.0);
    }

    #[test]
    fn the_same_line_in_other_pieces_does_not_deviate() {
        let wanted = [line(&[(0.0, 0.0), (8.0, 0.0)]), line(&[(1.0, 1.0)])];
        let drawn = [
            line(&[(1.0, 1.0)]),
            line(&[(8.0, 0.0), (2.0, 0.0)]),
            line(&[(0.0, 0.0), (3.0, 0.0)]),
        ];
        assert_eq!(deviation(&wanted, &drawn).largest_mm(), 0.0);
    }

    #[test]
    fn an_empty_drawing_deviates_infinitely_unless_nothing_was_wanted() {
        let wanted = [line(&[(0.0, 0.0), (8.0, 0.0)])];
        assert_eq!(deviation(&wanted, &[]).missed.distance_mm, f64::INFINITY);
        assert_eq!(deviation(&[], &[]).largest_mm(), 0.0);
    }

    /// Returns the number of segment distances computed per compared point.
    fn visits(path: &[Stroke], other: &[Stroke]) -> f64 {
        let count = |(a, b): (Point, Point)| steps(a, b, STEP_MM).count();
        let points: usize = path.iter().flat_map(pieces).map(count).sum();
        let mut near = PathDistance::new(other);
        farthest_from(path, &mut near);
        let mut each = PathDistance::new(other);
        for stroke in path {
            let points = stroke.segments().flat_map(|(a, b)| steps(a, b, STEP_MM));
            points.for_each(|p| assert!(each.distance_mm(p) < 1.0));
        }
        let visits = near.index.visits.get().max(each.index.visits.get());
        f64::from(u32::try_from(visits).unwrap_or(u32::MAX))
            / f64::from(u32::try_from(points).unwrap_or(u32::MAX))
    }

    /// As an arm draws it: a little beside what was wanted, every time elsewhere.
    fn drawn(wanted: &[Stroke]) -> Vec<Stroke> {
        let beside = |i: usize, p: Point| {
            let share = |count: usize| f64::from(u32::try_from(i % count).unwrap_or(0));
            p + Vec2::new(0.0011 * share(13), 0.0007 * share(29))
        };
        let stroke = |(i, stroke): (usize, &Stroke)| {
            let points = stroke.points.iter().enumerate();
            Stroke::open(points.map(|(j, &p)| beside(i + 7 * j, p)).collect())
        };
        wanted.iter().enumerate().map(stroke).collect()
    }

    #[test]
    fn overlapping_strokes_are_compared_with_few_of_them() {
        let wanted = vec![line(&[(0.0, 0.0), (11.0, 17.0), (20.0, 3.0)]); 4000];
        let drawn = drawn(&wanted);
        for (path, other) in [(&drawn, &wanted), (&wanted, &drawn), (&wanted, &wanted)] {
            let visits = visits(path, other);
            assert!(visits < 200.0, "{visits} for each point");
        }
    }

    #[test]
    fn a_fan_is_compared_with_few_of_its_lines() {
        let ray = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 3000.0).sin_cos();
            line(&[(0.0, 0.0), (15.0 * cos, 15.0 * sin)])
        };
        let wanted: Vec<Stroke> = (0..3000).map(ray).collect();
        let drawn = drawn(&wanted);
        for (path, other) in [(&drawn, &wanted), (&wanted, &drawn)] {
            let visits = visits(path, other);
            assert!(visits < 200.0, "{visits} for each point");
        }
    }
}
