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
            let (nearest, beyond) = near.split_at_mut(NEAREST);
            let mut found = Nearest::<NEAREST>::new(node);
            tree.around(p, f64::INFINITY, &|_, _| true, &mut |others| {
                found.add(others.filter(|other| !not.contains(other)), at, p)
            });
            nearest.copy_from_slice(&found.nodes);
            let joined = net.joined(node).iter().copied();
            let joined = joined.filter(|other| !not.contains(other) && !nearest.contains(other));
            let mut found = Nearest::<FARTHER>::new(node);
            found.add(joined, at, p);
            beyond.copy_from_slice(&found.nodes);
            near
        })
        .collect()
}

/// The nearest of some nodes, in order; missing ones are filled.
struct Nearest<const COUNT: usize> {
    distances2: [f64; COUNT],
    nodes: [u32; COUNT],
}

impl<const COUNT: usize> Nearest<COUNT> {
    const fn new(filler: u32) -> Self {
        Self {
            distances2: [f64::INFINITY; COUNT],
            nodes: [filler; COUNT],
        }
    }

    /// Adds nodes. Returns the squared distance beyond which no other is of interest.
    fn add(&mut self, nodes: impl Iterator<Item = u32>, at: &[Point], p: Point) -> f64 {
        for node in nodes {
            let distance2 = at[node as usize].distance_squared(p);
            if distance2 >= self.distances2[COUNT - 1] || self.nodes.contains(&node) {
                continue;
            }
            let mut slot = COUNT - 1;
            while slot > 0 && self.distances2[slot - 1] > distance2 {
                self.distances2[slot] = self.distances2[slot - 1];
                self.nodes[slot] = self.nodes[slot - 1];
                slot -= 1;
            }
            self.distances2[slot] = distance2;
            self.nodes[slot] = node;
        }
        self.distances2[COUNT - 1]
    }
}

/// A Delaunay triangulation of the nodes: the shortest edge between any two groups of nodes is one
/// of its sides.
struct Net {
    /// The place of each node; several nodes may share a place.
    place: Vec<u32>,
    /// The first of the nodes joined with each place, and the end of the last.
    first: Vec<u32>,
    /// The nodes joined with each place, one after another.
    joined: Vec<u32>,
}

impl Net {
    fn new(at: &[Point]) -> Self {
        let mut known = HashMap::with_capacity(at.len());
        let mut node = Vec::with_capacity(at.len());
        let place = (0..).zip(at).map(|(this, p)| {
            let bits = [p.x.to_bits(), p.y.to_bits()];
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
        // Every side of two triangles is seen from both; a side of the hull only from one.
        let sides = corners.flat_map(|triangle| {
            [
                (triangle[0], triangle[1]),
                (triangle[1], triangle[2]),
                (triangle[2], triangle[0]),
            ]
        });
        // Collinear points have no triangles, but a hull.
        let ring = net.hull.iter().zip(net.hull.iter().cycle().skip(1));
        let hull = ring.flat_map(|(&a, &b)| [(a, b), (b, a)]);
        let sides = sides.chain(hull);
        let mut first = vec![0; node.len() + 1];
        for (from, _) in sides.clone() {
            first[from] += 1;
        }
        let mut end = 0;
        for first in &mut first {
            end += *first;
            *first = end;
        }
        let mut joined = vec![0; end as usize];
        for (from, to) in sides {
            first[from] -= 1;
            joined[first[from] as usize] = node[to];
        }
        Self {
            place,
            first,
            joined,
        }
    }

    /// Returns the nodes joined with a node; some may come twice.
    fn joined(&self, node: u32) -> &[u32] {
        let place = self.place[node as usize] as usize;
        &self.joined[self.first[place] as usize..self.first[place + 1] as usize]
    }
}

fn index(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than the nodes")
}

/// The number of neighbours of a node.
pub(super) const NEAR: usize = NEAREST + FARTHER;
const NEAREST: usize = 7;
const FARTHER: usize = 4;

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
