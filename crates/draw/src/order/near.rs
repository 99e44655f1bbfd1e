//! The neighbours that a search tries to join a node with.

use dobot_geometry::{Bounds, Point};

use super::point_tree::PointTree;

/// The nearest few of every node, the nearest first, and then the nearest in each direction where
/// none of them lies: a dense cloud has to know its surroundings. Never the node's mate; where there
/// are fewer, the node itself stands in.
pub(super) fn near(tree: &PointTree, at: &[Point], mate: &[u32]) -> Vec<[u32; NEAR]> {
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
fn nearest(tree: &PointTree, at: &[Point], p: Point, not: [u32; 2]) -> [(f64, u32); NEAR] {
    let mut found = [(f64::INFINITY, not[0]); NEAR];
    tree.around(at, p, None, &mut |other, distance2| {
        if !not.contains(&other) {
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
fn missing(at: &[Point], p: Point, found: &[(f64, u32)]) -> impl Iterator<Item = Bounds> + use<> {
    let mut seen = [false; 4];
    for &(distance2, other) in found {
        let away = at[other as usize] - p;
        if distance2 > 0.0 {
            seen[usize::from(away.x < 0.0) + 2 * usize::from(away.y < 0.0)] = true;
        }
    }
    let corners = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    let quadrants = corners.into_iter().zip(seen).filter(|(_, seen)| !seen);
    quadrants
        .map(move |((x, y), _)| Bounds::of([p, Point::new(x * f64::INFINITY, y * f64::INFINITY)]))
}

/// The nearest in a quadrant that is not at the same place.
fn nearest_in(
    quadrant: Bounds,
    tree: &PointTree,
    at: &[Point],
    p: Point,
    not: [u32; 2],
) -> Option<(f64, u32)> {
    let mut best = None;
    tree.around(at, p, Some(quadrant), &mut |other, distance2| {
        let here = Bounds::of([at[other as usize]]);
        if distance2 > 0.0 && !not.contains(&other) && here.touches(quadrant) {
            best = Some((distance2, other));
        }
        best.map_or(f64::INFINITY, |best| best.0)
    });
    best
}

/// How many neighbours a node has.
pub(super) const NEAR: usize = NEAREST + 3;
const NEAREST: usize = 7;
