//! Moving of parts of the order, with every stroke in its best direction.
//!
//! Hatching lines go back and forth. If a line is inserted before them, all must be reversed, which
//! no exchange of a few edges can do:
//!
//! ```text
//!   ----.    .----             .----    ----.
//!   .---'    '---.   becomes   '---.    .---'
//!   '----    ----'             ----'    '----
//! ```

use dobot_geometry::Random;

use super::nodes::{Near, Nodes};
use super::row::{Part, Row};
use dobot_geometry::CancelToken;

/// Moves parts of an order while it gets shorter.
#[derive(Debug)]
pub(super) struct Turns<'a> {
    nodes: &'a Nodes,
    row: Row<'a>,
    /// The nodes of strokes next to changes.
    queue: Vec<u32>,
    cancel: &'a CancelToken,
}

impl<'a> Turns<'a> {
    pub(super) fn new(nodes: &'a Nodes, tour: &[u32], cancel: &'a CancelToken) -> Self {
        Self {
            nodes,
            row: Row::new(nodes, tour),
            queue: Vec::new(),
            cancel,
        }
    }

    /// Moves parts while that yields a gain.
    pub(super) fn settle_all(&mut self) {
        let places = (1..self.row.len()).rev();
        self.queue.extend(places.map(|place| self.row.node(place)));
        self.settle();
    }

    /// Rearranges a few parts, settles the order, and undoes it unless it is better; repeated for
    /// each kick.
    pub(super) fn kicks(&mut self, kicks: u32, random: &mut Random) {
        let mut best = self.row.clone();
        for _ in 0..kicks {
            if self.cancel.is_cancelled() {
                break;
            }
            let Some(places) = self.kick_places(random) else {
                continue;
            };
            self.kick(places, random);
            self.settle();
            // Only improvements are kept here; accepting losses is left to the exchanges of edges.
            if self.row.cost() < best.cost() - EPSILON {
                self.row.commit(&mut best);
            } else {
                self.row.undo(&best);
            }
        }
    }

    /// Returns the approximate number of edge kicks that take as long as one kick here.
    pub(super) fn kicks_for_one(&self) -> u32 {
        2 + self.count() / 400
    }

    pub(super) const fn cost(&self) -> f64 {
        self.row.cost()
    }

    pub(super) fn tour(&self) -> Vec<u32> {
        self.row.tour()
    }

    fn count(&self) -> u32 {
        u32::try_from(self.row.len()).expect("fewer than the nodes")
    }

    /// Rearranges the parts between four places, each in a random direction.
    fn kick(&mut self, [a, b, c, d]: [usize; 4], random: &mut Random) {
        let mut part = |from, to| Part {
            from,
            to,
            is_backward: random.below(2) == 0,
        };
        let mut parts = [part(a, b), part(b, c), part(c, d)];
        match random.below(3) {
            0 => parts.swap(0, 2),
            1 => parts.swap(0, 1),
            _ => parts.rotate_left(1),
        }
        let [first, second, third] = parts;
        self.put(&[
            forward(0, a),
            first,
            second,
            third,
            forward(d, self.row.len()),
        ]);
    }

    /// Returns close places with long travel.
    fn kick_places(&self, random: &mut Random) -> Option<[usize; 4]> {
        let any = |random: &mut Random| 1 + random.below(self.count() - 1) as usize;
        if self.row.len() < 5 {
            return None;
        }
        let mut first = any(random);
        // Prefer long travel, where a change can gain the most, but do not search for it forever.
        for _ in 0..MAX_LOOKED_AT {
            if self.is_long(first) {
                break;
            }
            first = any(random);
        }
        let mut places = [first; 4];
        let mut node = self.row.node(first);
        for place in &mut places[1..] {
            for _ in 0..=random.below(MAX_STEPS_ASIDE) {
                node = self.nodes.neighbour(node, random)?;
            }
            *place = self.long_way_from(self.row.place(node).max(1), random.below(2) == 0);
        }
        places.sort_unstable();
        let distinct = places.windows(2).all(|pair| pair[0] < pair[1]);
        distinct.then_some(places)
    }

    /// Moves from a place to the next long travel within a limited distance.
    fn long_way_from(&self, place: usize, ahead: bool) -> usize {
        let mut found = place;
        for _ in 0..MAX_STEPS_ALONG {
            if found <= 1 || found + 1 >= self.row.len() || self.is_long(found) {
                break;
            }
            found = if ahead { found + 1 } else { found - 1 };
        }
        found
    }

    fn settle(&mut self) {
        while let Some(node) = self.queue.pop() {
            if self.cancel.is_cancelled() {
                continue;
            }
            while self.improve(node) || self.improve(self.nodes.mate(node)) {}
        }
    }

    /// Moves a part so that the stroke of a node is next to a closer one.
    fn improve(&mut self, node: u32) -> bool {
        let here = self.row.place(node);
        here > 0 && (self.reverse(node, here) || self.shift(node, here))
    }

    /// Reverses the strokes between two that are close to each other.
    fn reverse(&mut self, node: u32, here: usize) -> bool {
        let longest = self.row.way(here).max(self.row.way(here + 1));
        self.nearer(node, longest).any(|near| {
            let there = self.row.place(near.node);
            let (a, b) = (here.min(there), here.max(there));
            [(a + 1, b + 1), (a, b)].into_iter().any(|(from, to)| {
                from > 0
                    && from + 1 < to
                    && f64::from(near.cost) < self.row.way(from) + self.row.way(to)
                    && self.change(&[
                        forward(0, from),
                        Part {
                            from,
                            to,
                            is_backward: true,
                        },
                        forward(to, self.row.len()),
                    ])
            })
        })
    }

    /// Moves strokes that begin or end with that of a node next to another one.
    fn shift(&mut self, node: u32, here: usize) -> bool {
        let (outside, beyond) = (self.row.way(here), self.row.way(here + 1));
        let has_nearer = |way| self.nearer(node, way).next().is_some();
        let (is_outside, is_beyond) = (has_nearer(outside), has_nearer(beyond));
        is_outside && self.shift_any(node, here, outside, self.ends_after(here))
            || is_beyond && self.shift_any(node, here, beyond, self.begins_before(here))
    }

    /// Moves one of these parts, of which a stroke is at one end, next to a stroke that is nearer than the way
    /// `outside` of the part.
    fn shift_any(
        &mut self,
        node: u32,
        here: usize,
        outside: f64,
        other_ends: [usize; MAX_PARTS],
    ) -> bool {
        other_ends.into_iter().filter(|&end| end > 0).any(|end| {
            let (from, to) = if end > here {
                (here, end)
            } else {
                (end, here + 1)
            };
            let left_out = self.row.way(from) + self.row.way(to) - self.row.least(from - 1, to);
            self.nearer(node, outside).any(|near| {
                self.shift_beside((from, to), here, *near, left_out - f64::from(near.cost))
            })
        })
    }

    /// Moves a part so that its stroke `here` is next to another one, if that can yield a gain:
    /// `saved` is the gain without the travel removed there and the other new one.
    fn shift_beside(&mut self, part: (usize, usize), here: usize, near: Near, saved: f64) -> bool {
        let (from, to) = part;
        let far = if here == from { to - 1 } else { from };
        let there = self.row.place(near.node);
        [there, there + 1].into_iter().any(|at| {
            let beside = if there == at { at.max(1) - 1 } else { at };
            let saved = saved + self.row.way(at);
            at > 0
                && !(from..=to).contains(&at)
                && saved > EPSILON
                && saved - self.row.least(far, beside) > EPSILON
                && self.move_to(part, at)
        })
    }

    fn move_to(&mut self, (from, to): (usize, usize), at: usize) -> bool {
        let count = self.row.len();
        [false, true].into_iter().any(|is_backward| {
            let moved = Part {
                from,
                to,
                is_backward,
            };
            if at < from {
                self.change(&[forward(0, at), moved, forward(at, from), forward(to, count)])
            } else {
                self.change(&[forward(0, from), forward(to, at), moved, forward(at, count)])
            }
        })
    }

    /// Returns the neighbours of a node with a lower travel cost.
    fn nearer(&self, node: u32, cost: f64) -> impl Iterator<Item = &'a Near> + use<'a> {
        let near = self.nodes.near(node).iter();
        near.take_while(move |near| f64::from(near.cost) < cost)
    }

    /// Returns possible ends of parts that begin here: after few strokes, or before a long travel.
    /// 0 means none.
    fn ends_after(&self, here: usize) -> [usize; MAX_PARTS] {
        let is_end =
            |&to: &usize| to - here <= SHORT || to == self.row.len() || self.is_longer(to, to - 1);
        first_of((here + 1..=self.row.len()).take(LONGEST).filter(is_end))
    }

    /// Returns possible starts of parts of at least two strokes that end here.
    fn begins_before(&self, here: usize) -> [usize; MAX_PARTS] {
        let is_begin =
            |&from: &usize| here - from < SHORT || from == 1 || self.is_longer(from, from + 1);
        first_of((1..here).rev().take(LONGEST).filter(is_begin))
    }

    fn is_long(&self, place: usize) -> bool {
        place > 1 && self.is_longer(place, place - 1)
    }

    fn is_longer(&self, way: usize, beside: usize) -> bool {
        self.row.way(way) > LONG * self.row.way(beside)
    }

    /// Applies another arrangement if it is better with the best directions of its strokes.
    fn change(&mut self, parts: &[Part]) -> bool {
        let better = self.row.cost_of(parts) < self.row.cost() - EPSILON;
        if better {
            self.put(parts);
        }
        better
    }

    fn put(&mut self, parts: &[Part]) {
        for part in parts.iter().filter(|part| part.from < part.to) {
            let ends = [part.from, part.to - 1];
            self.queue.extend(ends.map(|place| self.row.node(place)));
        }
        self.row.put(parts);
    }
}

const fn forward(from: usize, to: usize) -> Part {
    Part {
        from,
        to,
        is_backward: false,
    }
}

/// Returns the first few places, padded with zeros.
fn first_of(places: impl Iterator<Item = usize>) -> [usize; MAX_PARTS] {
    let mut found = [0; MAX_PARTS];
    for (slot, place) in found.iter_mut().zip(places) {
        *slot = place;
    }
    found
}

/// The number of parts tried that begin or end with a stroke.
const MAX_PARTS: usize = 12;
/// Parts of at most this many strokes may end anywhere.
const SHORT: usize = 3;
/// The maximum number of strokes in a moved part.
const LONGEST: usize = 300;
/// A travel is long if it costs this many times its neighbour.
const LONG: f64 = 1.6;
/// The number of places examined to find a long travel for a kick.
const MAX_LOOKED_AT: u32 = 100;
/// The maximum number of steps of the walk on paper to the next place of a kick.
const MAX_STEPS_ASIDE: u32 = 3;
/// The maximum number of strokes from there to a long travel.
const MAX_STEPS_ALONG: u32 = 30;
/// The minimum gain, in mm or s: above rounding errors.
const EPSILON: f64 = 1e-7;

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke};

    use super::super::stops::{cost, given};
    use super::super::travel::Travel;
    use super::*;

    const START: Point = Point::new(0.0, 0.0);

    /// Returns the cost of the given order, before and after moving parts.
    fn before_and_after(strokes: &[Stroke]) -> (f64, f64) {
        let way = given(strokes);
        let cancel = CancelToken::default();
        let nodes = Nodes::new(strokes, &way, START, Travel::Length, &cancel);
        let mut turns = Turns::new(&nodes, &nodes.tour(&way), &cancel);
        turns.settle_all();
        turns.kicks(50, &mut Random::new(1));
        let of = |way: &_| cost(strokes, way, START, Travel::Length);
        (of(&way), of(&nodes.way(&turns.tour())))
    }

    fn line(from: (f64, f64), to: (f64, f64)) -> Stroke {
        Stroke::open(vec![Point::from(from), Point::from(to)])
    }

    /// Returns lines in rows, drawn back and forth in the given order, the first from `begin` to
    /// `end`.
    fn to_and_fro(rows: impl Iterator<Item = i32>, begin: f64, end: f64) -> Vec<Stroke> {
        let ends = [(begin, end), (end, begin)].into_iter().cycle();
        let lines = rows.map(f64::from).zip(ends);
        let lines = lines.map(|(y, (from, to))| line((from, y), (to, y)));
        lines.collect()
    }

    #[test]
    fn a_whole_hatching_is_reversed_if_it_begins_on_the_wrong_side() {
        let lines = to_and_fro(0..40, 9.0, 0.0);
        assert_eq!(before_and_after(&lines), (48.0, 39.0));
    }

    #[test]
    fn late_lines_are_moved_forward_and_the_following_ones_reversed() {
        let rows = (0..5).chain(8..20).chain(5..8);
        let (before, after) = before_and_after(&to_and_fro(rows, 0.0, 9.0));
        assert!(before > 30.0 && after == 19.0, "{before}, {after} mm");
    }

    #[test]
    fn a_few_strokes_or_none_do_not_get_worse() {
        for count in 0..4 {
            let lines: Vec<Stroke> = (0..count)
                .map(|i| line((f64::from(i), 0.0), (f64::from(i), 5.0)))
                .collect();
            let (before, after) = before_and_after(&lines);
            assert!(after <= before, "{after}, {before} mm");
        }
    }
}
