//! An order of strokes, each with the point where it is begun.

use dobot_geometry::{Point, Stroke};

use super::travel::Travel;

/// A stroke and the point of it where it is begun: one of the ends, or any corner where it is
/// closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stop {
    pub(super) stroke: u32,
    pub(super) point: u32,
}

impl Stop {
    /// Where the pen comes down.
    pub(super) fn begin(self, strokes: &[Stroke]) -> Point {
        strokes[self.stroke as usize].points[self.point as usize]
    }

    /// Where it leaves the paper.
    pub(super) fn end(self, strokes: &[Stroke]) -> Point {
        self.other_end(strokes).begin(strokes)
    }

    /// The same stroke, begun from its other end; a closed one has none.
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

/// Whether a stroke may be begun anywhere: files do not call all of them closed that end where they
/// began.
fn is_loop(stroke: &Stroke) -> bool {
    stroke.closed || (stroke.points.len() > 2 && stroke.points.first() == stroke.points.last())
}

/// The strokes in the order given, without those that have no points.
pub(super) fn given(strokes: &[Stroke]) -> Vec<Stop> {
    (0..)
        .zip(strokes)
        .filter(|(_, stroke)| !stroke.points.is_empty())
        .map(|(stroke, _)| Stop { stroke, point: 0 })
        .collect()
}

/// What the ways between the strokes cost.
pub(super) fn cost(strokes: &[Stroke], way: &[Stop], start: Point, travel: Travel) -> f64 {
    let mut here = start;
    let mut cost = 0.0;
    for stop in way {
        cost += travel.cost(here.distance(stop.begin(strokes)));
        here = stop.end(strokes);
    }
    cost
}

/// Begins every closed stroke at the corner that is best between its neighbours. Returns the gain.
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

/// The strokes as the way goes through them; after them those that it leaves out.
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

/// The stroke, begun at one of its points.
fn begun(mut stroke: Stroke, point: usize) -> Stroke {
    if is_loop(&stroke) && point > 0 {
        // The last point repeats the first: leave it out while turning.
        stroke.points.pop();
        let count = stroke.points.len().max(1);
        stroke.points.rotate_left(point % count);
        stroke.points.extend(stroke.points.first().copied());
    } else if point > 0 {
        stroke.points.reverse();
    }
    stroke
}
