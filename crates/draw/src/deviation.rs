//! How well the drawn path matches the wanted one.

use crate::index::SegmentIndex;
use crate::point::{Point, Stroke};

/// How far two paths lie apart: each way, since ink in the wrong place and ink that is missing are
/// two different faults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The drawn point that lies farthest from what was wanted.
    pub astray: Worst,
    /// The wanted point that lies farthest from what was drawn.
    pub missed: Worst,
}

impl Deviation {
    /// The larger of the two distances, in millimetres.
    #[must_use]
    pub fn largest_mm(&self) -> f64 {
        self.astray.distance_mm.max(self.missed.distance_mm)
    }
}

/// The worst place of a path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// How far it lies from the other path; infinite where the other is empty.
    pub distance_mm: f64,
    /// Where it is.
    pub at: Point,
}

/// Compares the path wanted with the path drawn, at every corner and at least every half
/// millimetre.
#[must_use]
pub fn deviation(wanted: &[Stroke], drawn: &[Stroke]) -> Deviation {
    Deviation {
        astray: farthest(drawn, wanted),
        missed: farthest(wanted, drawn),
    }
}

/// A path that can be asked how far away it is.
///
/// It remembers which of its segments was the nearest: whoever asks along another path finds the
/// next one close to it.
#[derive(Debug)]
pub(crate) struct Near {
    index: SegmentIndex,
    last: u32,
}

impl Near {
    pub(crate) fn new(path: &[Stroke]) -> Self {
        Self {
            index: SegmentIndex::new(path.iter().flat_map(pieces).collect()),
            last: 0,
        }
    }

    /// The distance in mm; infinite where there is no path.
    pub(crate) fn distance_mm(&mut self, p: Point) -> f64 {
        match self.index.nearest_from(self.last, p) {
            Some((item, distance2)) => {
                self.last = item;
                distance2.sqrt()
            }
            None => f64::INFINITY,
        }
    }
}

/// The point of `path` that lies farthest from `other`.
fn farthest(path: &[Stroke], other: &[Stroke]) -> Worst {
    let mut near = Near::new(other);
    let points = path
        .iter()
        .flat_map(pieces)
        .flat_map(|(from, to)| from.steps_to(to, STEP_MM));
    points.fold(Worst::default(), |worst, at| {
        let distance_mm = near.distance_mm(at);
        if distance_mm > worst.distance_mm {
            Worst { distance_mm, at }
        } else {
            worst
        }
    })
}

/// The segments of a stroke; of a dot its point.
fn pieces(stroke: &Stroke) -> impl Iterator<Item = (Point, Point)> {
    let dot = stroke.points.first().filter(|_| stroke.points.len() == 1);
    stroke.segments().chain(dot.map(|&p| (p, p)))
}

const STEP_MM: f64 = 0.5;

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn tells_ink_astray_from_ink_that_is_missing() {
        let wanted = [line(&[(0.0, 0.0), (10.0, 0.0)])];
        let drawn = [line(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)])];
        let found = deviation(&wanted, &drawn);
        assert_eq!(
            found.astray,
            Worst {
                distance_mm: 3.0,
                at: Point::new(4.0, 3.0)
            }
        );
        assert_eq!(
            found.missed,
            Worst {
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
    fn nothing_drawn_is_infinitely_wrong_and_nothing_wanted_is_right() {
        let wanted = [line(&[(0.0, 0.0), (8.0, 0.0)])];
        assert_eq!(deviation(&wanted, &[]).missed.distance_mm, f64::INFINITY);
        assert_eq!(deviation(&[], &[]).largest_mm(), 0.0);
    }
}
