//! An order of strokes with their starts.

use dobot_geometry::{Point, Stroke};

use super::travel::Travel;

/// A stroke and the point at which it is begun: one of its ends, or any corner of a closed stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stop {
    pub(super) stroke: u32,
    pub(super) point: u32,
}

impl Stop {
    /// Returns the point at which the pen is lowered.
    pub(super) fn begin(self, strokes: &[Stroke]) -> Point {
        strokes[self.stroke as usize].points[self.point as usize]
    }

    /// Returns the point at which the pen is lifted.
    pub(super) fn end(self, strokes: &[Stroke]) -> Point {
        self.other_end(strokes).begin(strokes)
    }

    /// Returns the stroke begun from its other end; a closed stroke has none.
    pub(super) fn other_end(self, strokes: &[Stroke]) -> Self {
        let stroke = &strokes[self.stroke as usize];
        let last = u32::try_from(stroke.points.len() - 1).expect("far fewer than 2^32 points");
        let point = if is_loop(stroke) {
            self.point
        } else {
            last - self.point
        };
        Self { point, ..self }
    }
}

/// Whether a stroke may begin anywhere: files do not mark all strokes as closed that return to
/// their start.
fn is_loop(stroke: &Stroke) -> bool {
    stroke.closed || (stroke.points.len() > 2 && stroke.points.first() == stroke.points.last())
}

/// Returns the strokes in the given order, without empty ones.
pub(super) fn given(strokes: &[Stroke]) -> Vec<Stop> {
    (0..)
        .zip(strokes)
        .filter(|(_, stroke)| !stroke.points.is_empty())
        .map(|(stroke, _)| Stop { stroke, point: 0 })
        .collect()
}

/// Returns the travel cost between the strokes.
pub(super) fn cost(strokes: &[Stroke], way: &[Stop], start: Point, travel: Travel) -> f64 {
    let mut here = start;
    let mut cost = 0.0;
    for stop in way {
        cost += travel.cost(here.distance(stop.begin(strokes)));
        here = stop.end(strokes);
    }
    cost
}

/// Moves the start of every closed stroke to the best corner between its neighbours. Returns the
/// gain.
pub(super) fn turn_loops(
    strokes: &[Stroke],
    way: &mut [Stop],
    start: Point,
    travel: Travel,
) -> f64 {
    let mut here = start;
    let mut gain = 0.0;
    for i in 0..way.len() {
        let next = way.get(i + 1).map(|next| next.begin(strokes));
        let stroke = &strokes[way[i].stroke as usize];
        if is_loop(stroke) {
            let cost = |p: Point| {
                let on = next.map_or(0.0, |next| travel.cost(p.distance(next)));
                travel.cost(here.distance(p)) + on
            };
            let costs = (0..).zip(stroke.points.iter().map(|&p| cost(p)));
            let best = costs.min_by(|a, b| a.1.total_cmp(&b.1));
            let (point, least) = best.expect("a way holds strokes with points only");
            gain += cost(way[i].begin(strokes)) - least;
            way[i].point = point;
        }
        here = way[i].end(strokes);
    }
    gain
}

/// Returns the strokes in drawing order, followed by those left out.
pub(super) fn drawn(mut strokes: Vec<Stroke>, way: &[Stop]) -> Vec<Stroke> {
    let mut drawn = Vec::with_capacity(strokes.len());
    for stop in way {
        let stroke = std::mem::take(&mut strokes[stop.stroke as usize]);
        drawn.push(begun(stroke, stop.point as usize));
    }
    let left_out = strokes.len() - way.len();
    drawn.resize(drawn.len() + left_out, Stroke::default());
    drawn
}

/// Returns the stroke with its start at one of its points.
fn begun(mut stroke: Stroke, point: usize) -> Stroke {
    if is_loop(&stroke) && point > 0 {
        // The last point repeats the first: leave it out while rotating.
        stroke.points.pop();
        let count = stroke.points.len().max(1);
        stroke.points.rotate_left(point % count);
        stroke.points.extend(stroke.points.first().copied());
    } else if point > 0 {
        stroke.points.reverse();
    }
    stroke
}
