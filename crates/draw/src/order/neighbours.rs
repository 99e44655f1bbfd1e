//! The neighbours that a search tries to join a node with.

use dobot_geometry::{BoxTree, Point, Rect, bounds};

/// The nearest few of every node, the nearest first, and then the nearest in each direction where
/// none of them lies: a dense cloud has to know its surroundings. Never the node's mate; where there
/// are fewer, the node itself stands in.
pub(super) fn near(tree: &BoxTree, at: &[Point], mate: &[u32]) -> Vec<[u32; NEAR]> {
    (0..)
        .zip(at)
        .map(|(node, &p)| {
            let not = [node, mate[node as usize]];
            let mut found = nearest(tree, at, p, not);
            let mut count = NEAREST;
            for quadrant in missing(at, p, &found[..NEAREST]) {
                if count < NEAR
                    && let Some(other) = nearest_in(quadrant, tree, at, p, not)
                {
                    found[count] = other;
                    count += 1;
                }
            }
            found[NEAREST..count].sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
            found.map(|(_, other)| other)
        })
        .collect()
}

/// The nearest of all, with their squared distances.
fn nearest(tree: &BoxTree, at: &[Point], p: Point, not: [u32; 2]) -> [(f64, u32); NEAR] {
    let mut found = [(f64::INFINITY, not[0]); NEAR];
    tree.around(p, f64::INFINITY, &|_, _| true, &mut |others| {
        for other in others.filter(|it| !not.contains(it)) {
            let distance2 = at[other as usize].distance_squared(p);
            if distance2 >= found[NEAREST - 1].0 {
                continue;
            }
            let mut slot = NEAREST - 1;
            while slot > 0 && found[slot - 1].0 > distance2 {
                found[slot] = found[slot - 1];
                slot -= 1;
            }
            found[slot] = (distance2, other);
        }
        found[NEAREST - 1].0
    });
    found
}

/// The quadrants around `p` in which nothing was found.
fn missing(at: &[Point], p: Point, found: &[(f64, u32)]) -> impl Iterator<Item = Rect> + use<> {
    let mut seen = [false; 4];
    for &(distance2, other) in found {
        let away = at[other as usize] - p;
        if distance2 > 0.0 {
            seen[usize::from(away.x < 0.0) + 2 * usize::from(away.y < 0.0)] = true;
        }
    }
    let corners = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    let quadrants = corners.into_iter().zip(seen).filter(|(_, seen)| !seen);
    quadrants.map(move |((x, y), _)| bounds([p, Point::new(x * f64::INFINITY, y * f64::INFINITY)]))
}

/// The nearest in a quadrant that is not at the same place.
fn nearest_in(
    quadrant: Rect,
    tree: &BoxTree,
    at: &[Point],
    p: Point,
    not: [u32; 2],
) -> Option<(f64, u32)> {
    let mut best = (f64::INFINITY, None);
    let is_here = |there: Rect| there == Rect::from_points(p, p);
    // Most of what lies outside is left out, and heaps of points at `p` itself.
    let is_sought = |_, there: Rect| there.overlaps(quadrant) && !is_here(there);
    tree.around(p, f64::INFINITY, &is_sought, &mut |others| {
        for other in others.filter(|it| !not.contains(it)) {
            let there = at[other as usize];
            let distance2 = there.distance_squared(p);
            let is_in = Rect::from_points(there, there).overlaps(quadrant);
            if distance2 < best.0 && distance2 > 0.0 && is_in {
                best = (distance2, Some(other));
            }
        }
        best.0
    });
    best.1.map(|other| (best.0, other))
}

/// How many neighbours a node has.
pub(super) const NEAR: usize = NEAREST + 3;
const NEAREST: usize = 7;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point() -> impl Strategy<Value = Point> {
        (-9..9_i32, -9..9_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)))
    }

    proptest! {
        #[test]
        fn the_nearest_of_a_quadrant_is_as_near_as_by_looking_at_all_of_them(
            mut points in proptest::collection::vec(point(), 1..80),
            p in point(),
            right in any::<bool>(),
            down in any::<bool>(),
        ) {
            let tree = BoxTree::sort(&mut points, |&p| (p, p));
            let far = |positive| if positive { f64::INFINITY } else { f64::NEG_INFINITY };
            let quadrant = bounds([p, Point::new(far(right), far(down))]);
            let none = u32::MAX;
            let found = nearest_in(quadrant, &tree, &points, p, [none, none]).map(|it| it.0);
            let is_in = |it: &&Point| {
                let beside = if right { it.x >= p.x } else { it.x <= p.x };
                let along = if down { it.y >= p.y } else { it.y <= p.y };
                beside && along && **it != p
            };
            let away2 = |it: &Point| (it.x - p.x).powi(2) + (it.y - p.y).powi(2);
            let looked = points.iter().filter(is_in).map(away2).min_by(f64::total_cmp);
            prop_assert_eq!(found, looked);
        }
    }
}
