//! Local search for shorter tours: exchanges of a few edges, and kicks.

use dobot_geometry::Random;
use std::collections::VecDeque;

use super::nodes::{Near, Nodes};
use super::tour::{MAX_EDGES, Tour};
use dobot_geometry::CancelToken;

/// Exchanges edges while the tour gets shorter (Lin-Kernighan): removes an edge, adds a shorter one
/// to a near node, removes an edge there, and so on, until joining the two loose ends leaves a
/// gain.
#[derive(Debug)]
pub(super) struct LocalSearch<'a> {
    nodes: &'a Nodes,
    tour: Tour,
    /// The edges of each node in the tour.
    joined: Vec<Joined>,
    /// The edges of nodes before changes that may be undone.
    undo: Vec<(u32, Joined)>,
    /// The nodes next to changes, each once.
    queue: VecDeque<u32>,
    queued: Vec<bool>,
    /// The ends of the removed edges, in pairs.
    ends: [u32; 2 * MAX_EDGES],
    cancel: &'a CancelToken,
}

impl<'a> LocalSearch<'a> {
    pub(super) fn new(nodes: &'a Nodes, tour: Vec<u32>, cancel: &'a CancelToken) -> Self {
        let size = tour.len();
        Self {
            joined: joined(nodes, &tour),
            undo: Vec::new(),
            nodes,
            queue: VecDeque::with_capacity(size),
            queued: vec![false; size],
            tour: Tour::new(tour, (WRITES / size).max(MIN_REACH)),
            ends: [0; 2 * MAX_EDGES],
            cancel,
        }
    }

    /// Searches around every node until there is no gain left.
    pub(super) fn settle_all(&mut self) {
        for place in 0..self.tour.len() {
            self.touch(self.tour.at(place));
        }
        self.settle();
        self.commit();
    }

    /// Continues with another tour.
    pub(super) fn set(&mut self, tour: Vec<u32>) {
        self.replace(tour);
        self.settle_all();
    }

    /// Applies kicks, each followed by a local search. A worse result is undone, except for losses
    /// that are accepted with decreasing probability, so that the search leaves local minima.
    /// `mean` is the mean cost of the travel between strokes, or less with few kicks.
    pub(super) fn anneal(&mut self, kicks: u32, mean: f64, random: &mut Random) {
        let work = u64::from(kicks) * KICK_WRITES;
        let begin = self.tour.written();
        let mut gain = 0.0;
        let before = self.tour.order().to_vec();
        for kick in 0_u64.. {
            // Count written places rather than time, so that a seed gives the same order
            // everywhere.
            let done = kick * KICK_WRITES + (self.tour.written() - begin);
            if done >= work || self.cancel.is_cancelled() {
                break;
            }
            #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
            let left = 1.0 - done as f64 / work as f64;
            // Cool down quadratically: accept losses early and refine at the end.
            gain += self.kick(WARMTH * mean * left * left, random);
        }
        if gain < 0.0 {
            self.replace(before);
        }
    }

    fn replace(&mut self, tour: Vec<u32>) {
        self.joined = joined(self.nodes, &tour);
        self.tour.set(tour);
        self.undo.clear();
    }

    /// Makes all changes permanent.
    fn commit(&mut self) {
        self.tour.commit();
        self.undo.clear();
    }

    /// Undoes all changes since the last `commit`.
    fn revert(&mut self) {
        self.tour.revert();
        while let Some((node, before)) = self.undo.pop() {
            self.joined[node as usize] = before;
        }
    }

    /// Replaces the edges (0, 1), (2, 3) and so on of `ends` by (1, 2), (3, 4), ... and from the
    /// last to the first.
    fn rejoin(&mut self, ends: &[u32]) {
        let mut slots = [0; 2 * MAX_EDGES];
        for (i, (&end, slot)) in ends.iter().zip(&mut slots).enumerate() {
            let joined = self.joined[end as usize];
            self.undo.push((end, joined));
            *slot = usize::from(joined.node[1] == ends[i ^ 1]);
        }
        // A node may lose both of its edges.
        for i in (1..ends.len()).step_by(2) {
            let next = if i + 1 == ends.len() { 0 } else { i + 1 };
            let cost = self.nodes.edge_cost(ends[i], ends[next]);
            for (this, other) in [(i, next), (next, i)] {
                let joined = &mut self.joined[ends[this] as usize];
                joined.node[slots[this]] = ends[other];
                joined.cost[slots[this]] = cost;
            }
        }
    }

    /// Kicks the tour, settles it, and undoes a loss beyond a random limit, which is `warmth` on
    /// average. Returns the gain.
    fn kick(&mut self, warmth: f64, random: &mut Random) -> f64 {
        let Some(places) = self.kick_places(random) else {
            return 0.0;
        };
        let mut gain = 0.0;
        let [first, second, third, fourth] = places;
        let ends = |place| [self.tour.at(place), self.after(place)];
        let ends = [ends(first), ends(second), ends(third), ends(fourth)];
        for [a, b] in ends {
            gain += self.nodes.cost(a, b);
        }
        if gain <= EPSILON {
            // A zero cost cannot be improved.
            return 0.0;
        }
        // A double bridge cannot be undone by one exchange of three edges, so settling does not
        // simply revert it.
        let [[a0, b0], [a1, b1], [a2, b2], [a3, b3]] = ends;
        for [a, b] in [[a0, b2], [a3, b1], [a2, b0], [a1, b3]] {
            gain -= self.nodes.cost(a, b);
        }
        self.tour.apply(&Tour::bridge(places));
        self.rejoin(&[a0, b0, a2, b2]);
        self.rejoin(&[a1, b1, a3, b3]);
        for end in ends.into_iter().flatten() {
            self.touch(end);
        }
        gain += self.settle();
        // The Metropolis criterion: a loss is accepted with probability exp(gain / warmth).
        // `chance` is above 0, so that its logarithm is finite.
        let chance = f64::from(random.below(CHANCES) + 1) / f64::from(CHANCES);
        if gain < warmth * chance.ln() - EPSILON {
            self.revert();
            gain = 0.0;
        }
        self.commit();
        gain
    }

    pub(super) fn tour(&self) -> &[u32] {
        self.tour.order()
    }

    /// Returns four close places of the tour after which it may be cut.
    fn kick_places(&self, random: &mut Random) -> Option<[u32; 4]> {
        let size = self.tour.len();
        let window = WINDOW.min(size);
        let first = random.below(size - window + 1);
        let mut places = [first; 4];
        for place in &mut places {
            *place += random.below(window);
            if self
                .nodes
                .is_stroke(self.tour.at(*place), self.after(*place))
            {
                // The edge is a stroke and must stay; the next one is travel.
                *place = if *place + 1 == size { 0 } else { *place + 1 };
            }
        }
        places.sort_unstable();
        let distinct = places.windows(2).all(|pair| pair[0] < pair[1]);
        distinct.then_some(places)
    }

    fn after(&self, place: u32) -> u32 {
        self.tour.next(self.tour.at(place))
    }

    fn touch(&mut self, node: u32) {
        if !std::mem::replace(&mut self.queued[node as usize], true) {
            self.queue.push_back(node);
        }
    }

    /// Processes the queue and returns the gain.
    fn settle(&mut self) -> f64 {
        let mut gain = 0.0;
        while let Some(node) = self.queue.pop_front() {
            self.queued[node as usize] = false;
            // Keep emptying the queue, so that no node stays marked as queued.
            if self.cancel.is_cancelled() {
                continue;
            }
            while let Some(more) = self.improve(node) {
                gain += more;
            }
        }
        gain
    }

    /// Removes an edge of a node, if that leads to a gain.
    fn improve(&mut self, node: u32) -> Option<f64> {
        let Joined { node: others, cost } = self.joined[node as usize];
        for (other, cost) in others.into_iter().zip(cost) {
            if cost != STROKE {
                self.ends[0] = node;
                self.ends[1] = other;
                let gain = self.exchange_from(cost.into());
                if gain.is_some() {
                    return gain;
                }
            }
        }
        None
    }

    /// Exchanges edges after the removal of the first, which leaves the loose ends 0 and 1 and this gain.
    fn exchange_from(&mut self, open: f64) -> Option<f64> {
        self.deepen::<1>(open, |search, open| {
            search.deepen::<2>(open, |search, open| search.deepen::<3>(open, |_, _| None))
        })
    }

    /// Adds an edge from the last loose end and removes one at its other end.
    #[inline]
    fn deepen<const DEPTH: usize>(
        &mut self,
        open: f64,
        further: impl Fn(&mut Self, f64) -> Option<f64>,
    ) -> Option<f64> {
        let (steps, count) = self.steps::<DEPTH>(open);
        for step in &steps[..count] {
            self.ends[2 * DEPTH] = step.to;
            self.ends[2 * DEPTH + 1] = step.out;
            let gain = self
                .close(2 * DEPTH + 2, step.open)
                .or_else(|| further(self, step.open));
            if gain.is_some() {
                return gain;
            }
        }
        None
    }

    /// Joins the loose ends, if that gives a tour with a gain.
    #[inline]
    fn close(&mut self, count: usize, open: f64) -> Option<f64> {
        let [first, last] = [self.ends[0], self.ends[count - 1]];
        if !self.nodes.may_cost_less(last, first, open) {
            return None;
        }
        let gain = open - self.nodes.cost(last, first);
        if gain <= EPSILON {
            return None;
        }
        self.apply(count).then_some(gain)
    }

    /// Exchanges the edges between the first ends, unless the tour would fall apart.
    fn apply(&mut self, count: usize) -> bool {
        let ends = self.ends;
        let Some(exchange) = self.tour.exchange(&ends[..count]) else {
            return false;
        };
        self.tour.apply(&exchange);
        self.rejoin(&ends[..count]);
        for &end in &ends[..count] {
            self.touch(end);
        }
        true
    }

    /// Returns the most promising next steps, and their number.
    #[inline]
    fn steps<const DEPTH: usize>(&self, open: f64) -> ([Step; MAX_STEPS], usize) {
        let mut steps = [NO_STEP; MAX_STEPS];
        let (mut count, most) = (0, const { BREADTH[DEPTH - 1] });
        let from = self.ends[2 * DEPTH - 1];
        let around = self.joined[from as usize].node;
        for &Near { node: to, cost } in self.nodes.near(from) {
            let left = open - f64::from(cost);
            // Neighbours are sorted by cost, so no later one can leave a gain either.
            if left <= EPSILON {
                break;
            }
            // An edge of the tour cannot be added, and a node listed as its own neighbour is a
            // filler.
            if around.contains(&to) || to == from {
                continue;
            }
            let Joined { node: outs, cost } = self.joined[to as usize];
            for (out, cost) in outs.into_iter().zip(cost) {
                let open = left + f64::from(cost);
                // A stroke leaves less than no step.
                if open <= steps[most - 1].open || self.is_out::<DEPTH>(to, out) {
                    continue;
                }
                let mut slot = most - 1;
                count = (count + 1).min(most);
                // Insertion sort: there are at most five steps.
                while slot > 0 && steps[slot - 1].open < open {
                    steps[slot] = steps[slot - 1];
                    slot -= 1;
                }
                steps[slot] = Step { to, out, open };
            }
        }
        (steps, count)
    }

    /// Whether an edge is already removed.
    #[inline]
    fn is_out<const DEPTH: usize>(&self, a: u32, b: u32) -> bool {
        self.ends[..2 * DEPTH]
            .chunks_exact(2)
            .any(|edge| edge == [a, b] || edge == [b, a])
    }
}

/// The edges of a node in the tour: its two neighbours, and the costs of the ways to them.
#[derive(Clone, Copy, Debug)]
struct Joined {
    node: [u32; 2],
    /// [`STROKE`] for an edge that must stay.
    cost: [f32; 2],
}

/// Returns the edges of each node.
fn joined(nodes: &Nodes, tour: &[u32]) -> Vec<Joined> {
    let none = Joined {
        node: [0; 2],
        cost: [0.0; 2],
    };
    let mut joined = vec![none; tour.len()];
    let next = tour.iter().cycle().skip(1);
    for (&a, &b) in tour.iter().zip(next) {
        let cost = nodes.edge_cost(a, b);
        for (node, other, slot) in [(a, b, 1), (b, a, 0)] {
            joined[node as usize].node[slot] = other;
            joined[node as usize].cost[slot] = cost;
        }
    }
    joined
}

/// An added and a removed edge.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// The other end of the added edge.
    to: u32,
    /// The other end of the edge removed there.
    out: u32,
    /// The gain before the loose ends are joined.
    open: f64,
}

/// The cost of an edge that is a stroke, so that its removal never gains anything.
pub(super) const STROKE: f32 = f32::NEG_INFINITY;
/// Less than what any step leaves, and no more than what the removal of a stroke does.
const NO_STEP: Step = Step {
    to: 0,
    out: 0,
    open: f64::NEG_INFINITY,
};
/// The number of steps tried after each removed edge.
const BREADTH: [usize; MAX_EDGES - 1] = [5, 3, 1];

const MAX_STEPS: usize = 5;
/// A kick cuts the tour in four places within this window.
const WINDOW: u32 = 100;

/// The initial mean loss accepted after a kick, in mean travel costs.
const WARMTH: f64 = 4.0;
const CHANCES: u32 = 1 << 30;
/// The cost of a kick in written places; exchanges in large tours write far more.
const KICK_WRITES: u64 = 8_000;

/// The minimum gain, in mm or s: above rounding errors.
const EPSILON: f64 = 1e-9;
/// The maximum number of places an exchange may write, multiplied by the number of nodes.
const WRITES: usize = 10_000_000_000;
const MIN_REACH: usize = 1000;

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke};

    use super::super::stops::given;
    use super::super::travel::Travel;
    use super::*;

    #[test]
    fn edges_of_nodes_are_those_of_the_tour_after_kicks_that_are_undone_too() {
        let mut random = Random::new(7);
        let mut points = Random::new(8);
        let mut point = || Point::new(points.share() * 50.0, points.share() * 50.0);
        let strokes: Vec<Stroke> = (0..60)
            .map(|i| match i % 3 {
                0 => Stroke::open(vec![point()]),
                _ => Stroke::open(vec![point(), point()]),
            })
            .collect();
        let way = given(&strokes);
        let cancel = CancelToken::default();
        let nodes = Nodes::new(&strokes, &way, Point::default(), Travel::Length, &cancel);
        let sorted = |joined: &[Joined]| -> Vec<[(u32, u32); 2]> {
            let sorted = joined.iter().map(|Joined { node, cost }| {
                let mut edges = [0, 1].map(|i| (node[i], cost[i].to_bits()));
                edges.sort_unstable();
                edges
            });
            sorted.collect()
        };
        let mut search = LocalSearch::new(&nodes, nodes.tour(&way), &cancel);
        search.settle_all();
        for _ in 0..100 {
            search.anneal(10, 1.0, &mut random);
            let expected = joined(&nodes, search.tour());
            assert_eq!(sorted(&search.joined), sorted(&expected));
        }
    }
}
