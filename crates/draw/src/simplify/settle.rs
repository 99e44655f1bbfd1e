//! Corners that cost nothing go back to where the stroke has them.

use super::MIN_VECTOR_MM;
use super::search::Corner;
use super::tube::Tube;
use crate::point::Point;

/// Moves corners of a path to the points of the stroke they stand for: as many as can be without
/// another vector. Both ends stay.
pub(super) fn put_on_the_stroke(tube: &Tube<'_>, path: &[Corner]) -> Vec<Point> {
    let begin = Choice {
        corner: path[0],
        off: 0,
        before: 0,
        moved: false,
    };
    let mut layers = vec![vec![begin]];
    for (i, &corner) in path.iter().enumerate().skip(1) {
        let places = places(tube, corner, i + 1 == path.len());
        let choices = places.filter_map(|place| place.after(tube, &layers[i - 1]));
        let choices = choices.collect();
        layers.push(choices);
    }
    best_of_each(&layers)
}

/// A place for a corner.
#[derive(Clone, Copy, Debug)]
struct Choice {
    corner: Corner,
    /// How many corners of the path up to here lie off the stroke.
    off: usize,
    /// Which choice for the corner before makes it so.
    before: usize,
    /// Not where the search put it.
    moved: bool,
}

impl Choice {
    /// This place after the best of those before; `None` if no vector joins them.
    fn after(self, tube: &Tube<'_>, layer: &[Self]) -> Option<Self> {
        let mut order: Vec<usize> = (0..layer.len()).collect();
        order.sort_by_key(|&i| layer[i].off);
        let before = order.into_iter().find(|&i| layer[i].joins(tube, self))?;
        Some(Self {
            off: layer[before].off + usize::from(!self.moved),
            before,
            ..self
        })
    }

    fn joins(self, tube: &Tube<'_>, next: Self) -> bool {
        let (from, to) = (self.corner, next.corner);
        let found = !self.moved && !next.moved;
        found
            || from.passed < to.passed
                && from.at.distance(to.at) >= MIN_VECTOR_MM
                && tube.passes(from.at, to.at, from.passed + 1, to.passed)
    }
}

/// Where a corner may be: where the search put it, or the two points it lies between.
fn places(tube: &Tube<'_>, found: Corner, ends: bool) -> impl Iterator<Item = Choice> {
    let count = if ends { 0 } else { 2 };
    let points = (found.passed..tube.points.len()).take(count);
    let moved = points.map(move |passed| (true, passed, tube.points[passed]));
    let places = [(false, found.passed, found.at)].into_iter().chain(moved);
    places.map(move |(moved, passed, at)| Choice {
        corner: Corner {
            at,
            passed,
            ..found
        },
        off: 0,
        before: 0,
        moved,
    })
}

fn best_of_each(layers: &[Vec<Choice>]) -> Vec<Point> {
    let mut choice = 0;
    let mut points: Vec<Point> = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        points.push(layer[choice].corner.at);
        choice = layer[choice].before;
    }
    points.reverse();
    points
}
