//! Moves corners back to points of the stroke if that costs no vector.

use super::corridor::{Corner, Corridor};

/// Moves as many corners of a path as possible to the points of the stroke that they represent,
/// without an additional vector. Both ends are kept.
pub(super) fn snap_to_points(corridor: &Corridor<'_>, path: &[Corner]) -> Vec<Corner> {
    let begin = Choice {
        corner: path[0],
        off: 0,
        before: 0,
        moved: false,
    };
    let mut layers: Vec<[Option<Choice>; 3]> = Vec::with_capacity(path.len());
    layers.push([Some(begin), None, None]);
    for (i, &corner) in path.iter().enumerate().skip(1) {
        let before = layers[i - 1];
        let places = places(corridor, corner, i + 1 == path.len());
        layers.push(places.map(|place| place?.after(corridor, &before)));
    }
    best_of_each(&layers)
}

/// A choice for a corner: its place from the search, or one of the two points that it lies between.
#[derive(Clone, Copy, Debug)]
struct Choice {
    corner: Corner,
    /// The number of corners off the stroke up to here.
    off: usize,
    /// The choice for the corner before.
    before: usize,
    /// Whether it differs from the search's place.
    moved: bool,
}

impl Choice {
    /// Returns this choice after the best of those before; `None` if no vector joins them.
    fn after(self, corridor: &Corridor<'_>, layer: &[Option<Choice>; 3]) -> Option<Self> {
        let mut order = [0, 1, 2];
        order.sort_by_key(|&i| layer[i].map_or(usize::MAX, |before| before.off));
        let joins = |&i: &usize| layer[i].is_some_and(|before| before.joins(corridor, self));
        let before = order.into_iter().find(joins)?;
        Some(Self {
            off: layer[before]?.off + usize::from(!self.moved),
            before,
            ..self
        })
    }

    fn joins(self, corridor: &Corridor<'_>, next: Self) -> bool {
        let (from, to) = (self.corner, next.corner);
        let found = !self.moved && !next.moved;
        found
            || from.passed < to.passed
                && from.at.distance(to.at) >= corridor.least_mm
                && corridor.passes(from.at, to.at, from.passed + 1, to.passed)
    }
}

fn places(corridor: &Corridor<'_>, found: Corner, ends: bool) -> [Option<Choice>; 3] {
    let choice = |moved, passed, at| Choice {
        corner: Corner {
            at,
            passed,
            ..found
        },
        off: 0,
        before: 0,
        moved,
    };
    let point = |passed: usize| {
        let at = corridor.points.get(passed).filter(|_| !ends);
        at.map(|&at| choice(true, passed, at))
    };
    let here = choice(false, found.passed, found.at);
    [Some(here), point(found.passed), point(found.passed + 1)]
}

fn best_of_each(layers: &[[Option<Choice>; 3]]) -> Vec<Corner> {
    let mut choice = 0;
    let mut corners: Vec<Corner> = Vec::with_capacity(layers.len());
    for layer in layers.iter().rev() {
        let best = layer[choice].expect("what was found is joined to what was found");
        corners.push(best.corner);
        choice = best.before;
    }
    corners.reverse();
    corners
}
