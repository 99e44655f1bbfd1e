//! The order of strokes: less way to go with the pen up.

use crate::index::SegmentIndex;
use crate::point::{Point, Stroke};

/// Puts strokes in an order in which the pen, beginning at `start`, travels less between them: it
/// always goes on with the nearest stroke that is left. Open strokes may be drawn from either end
/// and closed ones from any corner. Never longer than the order given.
#[must_use]
pub fn order(strokes: Vec<Stroke>, start: Point) -> Vec<Stroke> {
    let given = travel_mm(&strokes, start);
    let ordered = nearest_next(&strokes, start);
    if travel_mm(&ordered, start) < given {
        ordered
    } else {
        strokes
    }
}

/// How far the pen travels between the strokes, from `start` to the begin of the first, and so on.
#[must_use]
pub fn travel_mm(strokes: &[Stroke], start: Point) -> f64 {
    let mut here = start;
    let mut travelled = 0.0;
    for stroke in strokes.iter().filter(|stroke| !stroke.points.is_empty()) {
        travelled += here.distance(stroke.points[0]);
        here = stroke.points[stroke.points.len() - 1];
    }
    travelled
}

fn nearest_next(strokes: &[Stroke], start: Point) -> Vec<Stroke> {
    let mut entries = Entries::new(strokes);
    let mut ordered = Vec::with_capacity(strokes.len());
    let mut here = start;
    while let Some((stroke, entry)) = entries.take_nearest(here) {
        let next = entered(&strokes[stroke], entry);
        here = next.last().unwrap_or(here);
        ordered.push(next);
    }
    ordered
}

/// Every point where a stroke may begin.
struct Entries {
    index: SegmentIndex,
    /// For each item of the index: which stroke, and which point of it.
    owners: Vec<(u32, u32)>,
    /// For each stroke its first item; one more at the end.
    first: Vec<u32>,
}

impl Entries {
    fn new(strokes: &[Stroke]) -> Self {
        let (mut points, mut owners, mut first) = (Vec::new(), Vec::new(), vec![0]);
        for (id, stroke) in (0..).zip(strokes) {
            let last = stroke.points.len().saturating_sub(1);
            let step = if stroke.closed { 1 } else { last.max(1) };
            for (entry, &p) in (0..).zip(&stroke.points).step_by(step) {
                points.push((p, p));
                owners.push((id, entry));
            }
            first.push(u32::try_from(owners.len()).expect("far fewer than 2^32 points"));
        }
        Self {
            index: SegmentIndex::new(points),
            owners,
            first,
        }
    }

    fn take_nearest(&mut self, p: Point) -> Option<(usize, usize)> {
        let (item, _) = self.index.nearest(p)?;
        let (stroke, entry) = self.owners[item as usize];
        let stroke = stroke as usize;
        for item in self.first[stroke]..self.first[stroke + 1] {
            self.index.remove(item);
        }
        Some((stroke, entry as usize))
    }
}

/// The stroke, drawn from one of its entries.
fn entered(stroke: &Stroke, entry: usize) -> Stroke {
    let mut stroke = stroke.clone();
    if stroke.closed {
        // The last point repeats the first: leave it out while turning.
        stroke.points.pop();
        let count = stroke.points.len();
        stroke.points.rotate_left(entry % count.max(1));
        stroke.points.extend(stroke.points.first().copied());
    } else if entry > 0 {
        stroke.points.reverse();
    }
    stroke
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn goes_on_with_the_nearest_and_turns_it_where_that_is_nearer() {
        let strokes = vec![
            line(&[(50.0, 0.0), (60.0, 0.0)]),
            line(&[(20.0, 0.0), (11.0, 0.0)]),
            line(&[(0.0, 0.0), (10.0, 0.0)]),
        ];
        let ordered = order(strokes, Point::default());
        let starts: Vec<f64> = ordered.iter().map(|s| s.points[0].x).collect();
        assert_eq!(starts, [0.0, 11.0, 50.0]);
    }

    #[test]
    fn a_closed_stroke_begins_at_its_nearest_corner() {
        let mut square = line(&[(9.0, 9.0), (5.0, 9.0), (5.0, 5.0), (9.0, 5.0), (9.0, 9.0)]);
        square.closed = true;
        let ordered = order(vec![square], Point::default());
        assert_eq!(
            ordered[0].points,
            line(&[(5.0, 5.0), (9.0, 5.0), (9.0, 9.0), (5.0, 9.0), (5.0, 5.0)]).points
        );
    }

    fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
        let point = (0.0..100.0_f64, 0.0..100.0_f64).prop_map(|(x, y)| Point::new(x, y));
        let stroke = (proptest::collection::vec(point, 1..6), any::<bool>()).prop_map(
            |(mut points, closed)| {
                if closed {
                    points.push(points[0]);
                }
                Stroke { points, closed }
            },
        );
        proptest::collection::vec(stroke, 0..40)
    }

    /// What a stroke draws, whichever way it is drawn.
    fn ink(stroke: &Stroke) -> Vec<String> {
        let mut ink: Vec<String> = stroke
            .segments()
            .map(|(a, b)| {
                if (a.x, a.y) < (b.x, b.y) {
                    (a, b)
                } else {
                    (b, a)
                }
            })
            .chain(stroke.points.iter().map(|&p| (p, p)))
            .map(|pair| format!("{pair:?}"))
            .collect();
        ink.sort();
        ink.dedup();
        ink
    }

    proptest! {
        #[test]
        fn draws_every_stroke_once_and_travels_no_further(strokes in strokes()) {
            let ordered = order(strokes.clone(), Point::default());
            prop_assert!(travel_mm(&ordered, Point::default()) <= travel_mm(&strokes, Point::default()));
            let mut before: Vec<_> = strokes.iter().map(ink).collect();
            let mut after: Vec<_> = ordered.iter().map(ink).collect();
            before.sort();
            after.sort();
            prop_assert_eq!(before, after);
        }
    }
}
