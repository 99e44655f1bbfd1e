//! The candidate neighbours of each node in the search.

use std::collections::HashMap;

use dobot_geometry::{BoxTree, CancelToken, Point};

/// Returns the nearest nodes of every node, nearest first, followed by the nearest of the others
/// joined with it by a triangulation: dense groups of nodes need links to each other. A node's mate
/// is never included; missing neighbours, and all once it is cancelled, are filled with the node
/// itself.
pub(super) fn near(
    tree: &BoxTree,
    at: &[Point],
    mate: &[u32],
    cancel: &CancelToken,
) -> Vec<[u32; NEAR]> {
    let net = Net::new(at);
    (0..)
        .zip(at)
        .map(|(node, &p)| {
            let not = [node, mate[node as usize]];
            let mut near = [node; NEAR];
            if cancel.is_cancelled() {
                return near;
            }
            near[..NEAREST].copy_from_slice(&nearest(tree, at, p, not));
            let mut beyond: Vec<(f64, u32)> = net
                .joined(node)
                .filter(|other| !not.contains(other) && !near.contains(other))
                .map(|other| (at[other as usize].distance_squared(p), other))
                .collect();
            beyond.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
            for (slot, (_, other)) in near[NEAREST..].iter_mut().zip(beyond) {
                *slot = other;
            }
            near
        })
        .collect()
}

/// Returns the nearest nodes.
fn nearest(tree: &BoxTree, at: &[Point], p: Point, not: [u32; 2]) -> [u32; NEAREST] {
    let mut found = [(f64::INFINITY, not[0]); NEAREST];
    tree.around(p, f64::INFINITY, &|_, _| true, &mut |others| {
        for other in others.filter(|other| !not.contains(other)) {
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
    found.map(|(_, other)| other)
}

/// A Delaunay triangulation of the nodes: the shortest edge between any two groups of nodes is one
/// of its sides.
struct Net {
    /// The place of each node; several nodes may share a place.
    place: Vec<u32>,
    /// The first node at each place.
    node: Vec<u32>,
    /// The sides of the triangles as pairs of places, in both directions, sorted.
    sides: Vec<(u32, u32)>,
}

impl Net {
    fn new(at: &[Point]) -> Self {
        let mut known = HashMap::with_capacity(at.len());
        let mut node = Vec::with_capacity(at.len());
        let place = (0..).zip(at).map(|(this, p)| {
            let bits = [p.x, p.y].map(f64::to_bits);
            *known.entry(bits).or_insert_with(|| {
                node.push(this);
                index(node.len() - 1)
            })
        });
        let place = place.collect();
        let places = node.iter().map(|&node: &u32| {
            let Point { x, y } = at[node as usize];
            delaunator::Point { x, y }
        });
        let net = delaunator::triangulate(&places.collect::<Vec<_>>());
        let corners = net.triangles.chunks_exact(3);
        let sides = corners.flat_map(|triangle| {
            [
                (triangle[0], triangle[1]),
                (triangle[1], triangle[2]),
                (triangle[2], triangle[0]),
            ]
        });
        // Collinear points have no triangles, but a hull.
        let hull = net.hull.windows(2).map(|pair| (pair[0], pair[1]));
        let sides = sides.chain(hull).flat_map(|(a, b)| [(a, b), (b, a)]);
        let mut sides: Vec<_> = sides.map(|(a, b)| (index(a), index(b))).collect();
        sides.sort_unstable();
        sides.dedup();
        Self { place, node, sides }
    }

    /// Returns the nodes joined with a node.
    fn joined(&self, node: u32) -> impl Iterator<Item = u32> {
        let place = self.place[node as usize];
        let begin = self.sides.partition_point(|side| side.0 < place);
        let sides = self.sides[begin..].iter();
        let sides = sides.take_while(move |side| side.0 == place);
        sides.map(|side| self.node[side.1 as usize])
    }
}

fn index(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than the nodes")
}

/// The number of neighbours of a node.
pub(super) const NEAR: usize = NEAREST + 4;
const NEAREST: usize = 7;

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a node of `one` has a neighbour in `other`.
    fn is_joined(one: &[Point], other: &[Point]) -> bool {
        let mut points = [one, other].concat();
        let tree = BoxTree::sort(&mut points, |&p| (p, p));
        let alone: Vec<u32> = (0..).take(points.len()).collect();
        let found = near(&tree, &points, &alone, &CancelToken::default());
        points.iter().zip(found).any(|(p, near)| {
            let is_other = |node: u32| other.contains(&points[node as usize]);
            one.contains(p) && near.into_iter().any(is_other)
        })
    }

    fn row(count: u32, at: impl Fn(f64) -> Point) -> Vec<Point> {
        (0..count).map(|i| at(f64::from(i))).collect()
    }

    #[test]
    fn dense_rows_of_endpoints_are_neighbours_across_a_gap() {
        let facing = |x: f64| row(40, move |i| Point::new(x + 0.1 * (2.0 * i).sin(), 0.6 * i));
        assert!(is_joined(&facing(0.0), &facing(15.0)));
        assert!(is_joined(&facing(15.0), &facing(0.0)));
    }

    #[test]
    fn a_cluster_has_neighbours_outside_of_it() {
        let heap = vec![Point::new(3.0, 4.0); 30];
        assert!(is_joined(&heap, &row(9, |i| Point::new(i, 20.0))));
        assert!(is_joined(&heap, &[Point::new(50.0, 50.0)]));
    }

    #[test]
    fn collinear_points_are_connected_too() {
        let along = |begin: f64| row(20, move |i| Point::new(begin + 0.5 * i, 7.0));
        assert!(is_joined(&along(0.0), &along(100.0)));
    }
}
