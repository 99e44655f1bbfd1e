//! Construction of an initial tour: the shortest edges first.

use dobot_geometry::{CancelToken, SegmentIndex};

use super::nodes::Nodes;

/// Joins nodes by the shortest edges between neighbours, as long as no node gets more than two and
/// no ring closes, and then joins the fragments, each time the nearest. `None` if it is cancelled.
pub(super) fn greedy(nodes: &Nodes, cancel: &CancelToken) -> Option<Vec<u32>> {
    let mut fragments = Fragments::new(nodes);
    for (a, b) in shortest_first(nodes, cancel)? {
        fragments.join(a, b);
    }
    fragments.in_a_row(nodes, cancel)
}

fn shortest_first(nodes: &Nodes, cancel: &CancelToken) -> Option<Vec<(u32, u32)>> {
    let mut ways = Vec::new();
    for a in 0..nodes.end() {
        cancel.check().ok()?;
        for b in nodes.near(a).iter().map(|near| near.node) {
            // Of two mutual neighbours only the smaller one adds the edge; a node listed as its own
            // neighbour is a filler.
            if a < b || (a > b && !nodes.near(b).iter().any(|near| near.node == a)) {
                #[expect(clippy::cast_possible_truncation, reason = "only to sort by it")]
                let length = (nodes.point(b) - nodes.point(a)).length() as f32;
                // Non-negative floats sort like their bits.
                ways.push((length.to_bits(), a, b));
            }
        }
    }
    ways.sort_unstable();
    Some(ways.into_iter().map(|(_, a, b)| (a, b)).collect())
}

/// The fragments of a tour.
struct Fragments {
    /// Up to two neighbours of each node.
    joined: Vec<[u32; 2]>,
    /// For each end of a fragment, the other end.
    other_end: Vec<u32>,
}

impl Fragments {
    /// Creates a fragment per stroke; the edge to the start is set already.
    fn new(nodes: &Nodes) -> Self {
        let mut fragments = Self {
            joined: vec![[NONE; 2]; nodes.len() as usize],
            other_end: (0..nodes.len()).collect(),
        };
        for node in 0..nodes.len() {
            let mate = nodes.mate(node);
            if mate != node {
                fragments.joined[node as usize][0] = mate;
                fragments.other_end[node as usize] = mate;
            }
        }
        fragments
    }

    fn has_room(&self, node: u32) -> bool {
        self.joined[node as usize].contains(&NONE)
    }

    fn join(&mut self, a: u32, b: u32) {
        let (far_a, far_b) = (self.other_end[a as usize], self.other_end[b as usize]);
        if far_a == b || !self.has_room(a) || !self.has_room(b) {
            return;
        }
        for (node, other) in [(a, b), (b, a)] {
            let [first, second] = &mut self.joined[node as usize];
            *if *first == NONE { first } else { second } = other;
        }
        self.other_end[far_a as usize] = far_b;
        self.other_end[far_b as usize] = far_a;
    }

    /// Returns a tour from the start through all fragments.
    fn in_a_row(&self, nodes: &Nodes, cancel: &CancelToken) -> Option<Vec<u32>> {
        let ends: Vec<u32> = (0..nodes.end())
            .filter(|&node| self.has_room(node) && node != nodes.start())
            .filter(|&node| self.other_end[node as usize] != nodes.end())
            .collect();
        let place = |&node: &u32| (nodes.point(node), nodes.point(node));
        let mut index = SegmentIndex::new(ends.iter().map(place).collect());
        let mut tour = vec![nodes.end()];
        let mut here = self.walk(nodes.start(), &mut tour);
        while let Some((item, _)) = index.nearest(nodes.point(here)) {
            cancel.check().ok()?;
            let begin = ends[item as usize];
            index.remove(item);
            here = self.walk(begin, &mut tour);
            if let Ok(item) = ends.binary_search(&here)
                && here != begin
            {
                index.remove(u32::try_from(item).expect("fewer than the nodes"));
            }
        }
        tour.rotate_left(1);
        Some(tour)
    }

    /// Follows a fragment to its other end.
    fn walk(&self, begin: u32, tour: &mut Vec<u32>) -> u32 {
        let (mut here, mut before) = (begin, tour[tour.len() - 1]);
        loop {
            tour.push(here);
            let next = self.joined[here as usize]
                .into_iter()
                .find(|&next| next != NONE && next != before);
            let Some(next) = next else {
                return here;
            };
            before = here;
            here = next;
        }
    }
}

const NONE: u32 = u32::MAX;
