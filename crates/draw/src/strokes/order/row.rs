//! A sequence of strokes with the cost of the travel between them, given the best direction of each
//! stroke.

use std::ops::Range;

use super::nodes::Nodes;

/// An order of strokes that begins with the start. The travel cost of any part, in either direction
/// and for all directions of its end strokes, is available in logarithmic time.
#[derive(Clone, Debug)]
pub(super) struct Row<'a> {
    nodes: &'a Nodes,
    /// The start node of each stroke if it is not reversed; the first is the pen's start.
    begins: Vec<u32>,
    /// The position in the order of each node's stroke.
    places: Vec<u32>,
    /// The costs from each stroke's predecessor.
    gaps: Vec<Ways>,
    /// A segment tree: the costs through a part are combined from its two halves and the gap
    /// between them. The root has index 1; the last half are the single strokes, padded to a power
    /// of two.
    parts: Vec<Ways>,
    /// The current cost of the travel to each stroke; 0 after the last.
    costs: Vec<f64>,
    cost: f64,
    is_turned: Vec<bool>,
    /// For each stroke the best direction of its predecessor, if this one is not reversed and if it
    /// is.
    before: Vec<[u8; 2]>,
    /// The least costs up to each stroke, if it is not reversed and if it is, above the smaller of
    /// both.
    reached: Vec<[f64; 2]>,
    /// The places that differ from those of the last order that was kept.
    changed: Range<usize>,
}

/// The travel costs through a part, by the directions of its first and last stroke: not reversed or
/// reversed.
type Ways = [[f64; 2]; 2];

/// The strokes of a half-open range of positions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) is_backward: bool,
}

impl<'a> Row<'a> {
    /// Creates the order of a tour.
    pub(super) fn new(nodes: &'a Nodes, tour: &[u32]) -> Self {
        let begins = begins(nodes, tour);
        let count = begins.len();
        // A power of two keeps the positions of children simple; the padding costs nothing.
        let leaves = count.next_power_of_two();
        let mut parts = vec![NONE; 2 * leaves];
        parts[leaves] = START;
        let mut row = Self {
            nodes,
            begins,
            places: vec![0; nodes.len() as usize],
            gaps: vec![NONE; leaves],
            parts,
            costs: vec![0.0; count + 1],
            cost: 0.0,
            is_turned: vec![false; count],
            before: vec![[0; 2]; count],
            reached: vec![[0.0, f64::INFINITY]; count],
            changed: 0..0,
        };
        for place in 1..count {
            row.gaps[place] = row.gap(row.last(place - 1), row.begins[place]);
        }
        row.changed(0, count);
        row
    }

    /// Returns the tour through the strokes.
    pub(super) fn tour(&self) -> Vec<u32> {
        let mut tour = vec![self.nodes.start()];
        for (&begin, &turned) in self.begins.iter().zip(&self.is_turned).skip(1) {
            let end = self.nodes.mate(begin);
            tour.push(if turned { end } else { begin });
            if end != begin {
                tour.push(if turned { begin } else { end });
            }
        }
        tour.push(self.nodes.end());
        tour
    }

    /// Returns the number of strokes, including the start.
    pub(super) const fn len(&self) -> usize {
        self.begins.len()
    }

    /// Returns the total travel cost.
    pub(super) const fn cost(&self) -> f64 {
        self.cost
    }

    /// Returns the cost of the travel to a stroke; 0 after the last.
    pub(super) fn way(&self, place: usize) -> f64 {
        self.costs[place]
    }

    /// Returns a node of a stroke.
    pub(super) fn node(&self, place: usize) -> u32 {
        self.begins[place]
    }

    /// Returns the position of a node's stroke.
    pub(super) fn place(&self, node: u32) -> usize {
        self.places[node as usize] as usize
    }

    /// Returns the minimum cost of the travel between two strokes; 0 after the last.
    pub(super) fn least(&self, a: usize, b: usize) -> f64 {
        if a >= self.len() || b >= self.len() {
            return 0.0;
        }
        let ends = |place: usize| [self.begins[place], self.last(place)];
        self.nodes.least_cost(ends(a), ends(b))
    }

    /// Returns the total cost if the parts, which must cover the order, were arranged like this.
    pub(super) fn cost_of(&self, parts: &[Part]) -> f64 {
        let mut ways = NONE;
        let mut last = None;
        for part in parts.iter().filter(|part| part.from < part.to) {
            let (first, end) = self.ends(part);
            let gap = last.map_or(NONE, |last| self.gap(last, first));
            ways = through(&ways, &gap, &self.ways(part));
            last = Some(end);
        }
        least(&ways)
    }

    /// Rearranges the parts, which must cover the order. The first one, with the start, and the
    /// last one keep their positions.
    pub(super) fn put(&mut self, parts: &[Part]) {
        let [first, moved @ .., rest] = parts else {
            return;
        };
        let (mut begins, mut gaps) = (Vec::new(), Vec::new());
        let mut last = self.last(first.to - 1);
        for part in moved.iter().filter(|part| part.from < part.to) {
            let (begin, end) = self.ends(part);
            gaps.push(self.gap(last, begin));
            let (places, ways) = (part.from..part.to, part.from + 1..part.to);
            if part.is_backward {
                begins.extend(places.rev().map(|place| self.last(place)));
                gaps.extend(ways.rev().map(|place| turned(&self.gaps[place])));
            } else {
                begins.extend_from_slice(&self.begins[places]);
                gaps.extend_from_slice(&self.gaps[ways]);
            }
            last = end;
        }
        if rest.from < rest.to {
            gaps.push(self.gap(last, self.begins[rest.from]));
        }
        self.begins[first.to..rest.from].copy_from_slice(&begins);
        self.gaps[first.to..first.to + gaps.len()].copy_from_slice(&gaps);
        self.changed(first.to, rest.from);
    }

    /// Applies the changes of this order to another one, which was equal before them.
    pub(super) fn commit(&mut self, to_other: &mut Self) {
        to_other.copy(self, self.changed.clone());
        self.changed = 0..0;
    }

    /// Undoes the changes since the last call of [`commit`](Self::commit) with this other order.
    pub(super) fn undo(&mut self, to_other: &Self) {
        self.copy(to_other, self.changed.clone());
        self.changed = 0..0;
    }

    /// Copies the places of a range from another order, which is equal in the others.
    fn copy(&mut self, other: &Self, range: Range<usize>) {
        let Range { start, end } = range;
        let places = |last: usize| start..end.min(last);
        let strokes = places(self.len());
        self.begins[strokes.clone()].copy_from_slice(&other.begins[strokes.clone()]);
        self.number(strokes.clone());
        self.is_turned[strokes.clone()].copy_from_slice(&other.is_turned[strokes.clone()]);
        self.before[strokes.clone()].copy_from_slice(&other.before[strokes.clone()]);
        self.reached[strokes.clone()].copy_from_slice(&other.reached[strokes.clone()]);
        let costs = places(self.costs.len());
        self.costs[costs.clone()].copy_from_slice(&other.costs[costs]);
        let gaps = places(self.gaps.len());
        self.gaps[gaps.clone()].copy_from_slice(&other.gaps[gaps]);
        // The gap before a part is in the part around both.
        let leaves = self.parts.len() / 2;
        let (mut from, mut to) = (start.max(1) - 1 + leaves, end.min(leaves - 1) + leaves);
        while from > 1 {
            (from, to) = (from / 2, to / 2);
            self.parts[from..=to].copy_from_slice(&other.parts[from..=to]);
        }
        self.cost = other.cost;
    }

    /// Returns the first and last node of a part if neither stroke is reversed.
    fn ends(&self, part: &Part) -> (u32, u32) {
        if part.is_backward {
            (self.last(part.to - 1), self.begins[part.from])
        } else {
            (self.begins[part.from], self.last(part.to - 1))
        }
    }

    /// Returns the last node of a stroke if it is not reversed.
    fn last(&self, place: usize) -> u32 {
        let begin = self.begins[place];
        // The mate of the start is the end of the tour.
        if place == 0 {
            begin
        } else {
            self.nodes.mate(begin)
        }
    }

    /// Returns the costs between a stroke that ends at one node and a stroke that begins at
    /// another.
    fn gap(&self, last: u32, first: u32) -> Ways {
        let mate = |node| {
            if node == self.nodes.start() {
                node
            } else {
                self.nodes.mate(node)
            }
        };
        let (last_mate, first_mate) = (mate(last), mate(first));
        let cost = |last, first| self.nodes.cost(last, first);
        [
            [cost(last, first), cost(last, first_mate)],
            [cost(last_mate, first), cost(last_mate, first_mate)],
        ]
    }

    /// Returns the costs through a part.
    fn ways(&self, part: &Part) -> Ways {
        let leaves = self.parts.len() / 2;
        let (mut from, mut to, mut size) = (part.from + leaves, part.to + leaves, 1);
        let (mut left, mut right) = (NONE, NONE);
        let (mut left_to, mut right_from) = (part.from, part.to);
        let gap = |place| {
            if place == part.from || place == part.to {
                &NONE
            } else {
                &self.gaps[place]
            }
        };
        // Combine O(log n) nodes of the tree from both ends; their order matters, because costs
        // through parts do not commute.
        while from < to {
            if from % 2 == 1 {
                left = through(&left, gap(left_to), &self.parts[from]);
                left_to += size;
                from += 1;
            }
            if to % 2 == 1 {
                to -= 1;
                right = through(&self.parts[to], gap(right_from), &right);
                right_from -= size;
            }
            (from, to, size) = (from / 2, to / 2, 2 * size);
        }
        let ways = through(&left, gap(left_to), &right);
        if part.is_backward {
            turned(&ways)
        } else {
            ways
        }
    }

    /// Updates the order after the strokes of a range have changed.
    fn changed(&mut self, from: usize, to: usize) {
        self.number(from..to);
        // The gap before the first changed stroke changes too.
        self.rebuild(from.max(1) - 1, to);
        let priced = self.price(from, to);
        let (from, to) = (from.min(priced.start), to.max(priced.end) + 1);
        let changed = &self.changed;
        self.changed = if changed.is_empty() {
            from..to
        } else {
            changed.start.min(from)..changed.end.max(to)
        };
    }

    /// Notes the places of the nodes of a range.
    fn number(&mut self, range: Range<usize>) {
        for place in range {
            let begin = self.begins[place];
            for node in [begin, self.nodes.mate(begin)] {
                self.places[node as usize] = u32::try_from(place).expect("fewer than the nodes");
            }
        }
    }

    /// Rebuilds all parts of the tree with strokes of a range.
    fn rebuild(&mut self, from: usize, to: usize) {
        let leaves = self.parts.len() / 2;
        let (mut from, mut to) = (from + leaves, to.min(leaves - 1) + leaves);
        let mut half = 1;
        while from > 1 {
            (from, to) = (from / 2, to / 2);
            for part in from..=to {
                // The start of the second half of the part.
                let middle = (2 * part + 1) * half - leaves;
                let (first, second) = (&self.parts[2 * part], &self.parts[2 * part + 1]);
                self.parts[part] = through(first, &self.gaps[middle], second);
            }
            half *= 2;
        }
    }

    /// Computes the costs of the travels with the best directions of all strokes, after the gaps of
    /// a range have changed. Beyond it, it ends where nothing changes any more. Returns the range of the places
    /// computed.
    fn price(&mut self, from: usize, to: usize) -> Range<usize> {
        let mut place = from.max(1);
        let mut reached = self.reached[place - 1];
        while place < self.len() {
            let gap = &self.gaps[place];
            let best = |turned| {
                let (a, b) = (reached[0] + gap[0][turned], reached[1] + gap[1][turned]);
                if b < a { (b, 1) } else { (a, 0) }
            };
            let ((upright, before_upright), (turned, before_turned)) = (best(0), best(1));
            let least = smaller(upright, turned);
            reached = [upright - least, turned - least];
            let before = [before_upright, before_turned];
            let is_same = place > to && reached == self.reached[place];
            self.before[place] = before;
            if is_same {
                break;
            }
            self.reached[place] = reached;
            place += 1;
        }
        let end = place;
        // Walk back through the recorded choices to recover the directions.
        let mut turned = if place < self.len() {
            usize::from(self.is_turned[place])
        } else {
            place -= 1;
            usize::from(reached[1] < reached[0])
        };
        while place > 0 {
            let before = usize::from(self.before[place][turned]);
            let cost = self.gaps[place][before][turned];
            self.cost += cost - self.costs[place];
            self.costs[place] = cost;
            let is_same = place < from && self.is_turned[place] == (turned == 1);
            self.is_turned[place] = turned == 1;
            if is_same {
                break;
            }
            turned = before;
            place -= 1;
        }
        place..end
    }
}

/// Combines the costs of two parts and the gap between them.
#[inline]
fn through(a: &Ways, gap: &Ways, b: &Ways) -> Ways {
    times(&times(a, gap), b)
}

#[inline]
fn times(a: &Ways, b: &Ways) -> Ways {
    let least = |a: &[f64; 2], turned| smaller(a[0] + b[0][turned], a[1] + b[1][turned]);
    let [upright, turned] = a;
    [
        [least(upright, 0), least(upright, 1)],
        [least(turned, 0), least(turned, 1)],
    ]
}

#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Returns the costs in reverse.
fn turned(ways: &Ways) -> Ways {
    let [[a, b], [c, d]] = *ways;
    [[a, c], [b, d]]
}

fn least(ways: &Ways) -> f64 {
    ways.iter()
        .flatten()
        .fold(f64::INFINITY, |a, &b| smaller(a, b))
}

/// Returns the start node of each stroke of a tour, beginning with the start.
fn begins(nodes: &Nodes, tour: &[u32]) -> Vec<u32> {
    let size = tour.len();
    let start = tour.iter().position(|&node| node == nodes.start());
    let start = start.expect("a tour passes its start");
    let forward = tour[(start + size - 1) % size] == nodes.end();
    let mut begins = vec![nodes.start()];
    let mut step = 1;
    while step < size - 1 {
        let place = if forward {
            start + step
        } else {
            start + size - step
        };
        let begin = tour[place % size];
        begins.push(begin);
        step += if nodes.mate(begin) == begin { 1 } else { 2 };
    }
    begins
}

/// A single stroke costs nothing, and is reversed at both ends or at none.
const NONE: Ways = [[0.0, f64::INFINITY], [f64::INFINITY, 0.0]];
/// The start cannot be reversed.
const START: Ways = [[0.0, f64::INFINITY], [f64::INFINITY, f64::INFINITY]];

#[cfg(test)]
mod tests {
    use dobot_geometry::{CancelToken, Point, Stroke};
    use proptest::prelude::*;

    use super::super::stops::{cost, given};
    use super::super::travel::Travel;
    use super::*;

    fn line(ends: [(i32, i32); 2]) -> Stroke {
        let point = |(x, y): (i32, i32)| Point::new(f64::from(x), f64::from(y));
        Stroke::open(ends.map(point).to_vec())
    }

    /// Returns the minimum cost in this order over all directions.
    fn least_of_all(nodes: &Nodes, strokes: &[Stroke], order: &[u32]) -> f64 {
        let costs = (0..1_u32 << order.len()).map(|turned| {
            let mut tour = vec![nodes.start()];
            for (i, &begin) in order.iter().enumerate() {
                let end = nodes.mate(begin);
                tour.extend(if turned >> i & 1 == 1 {
                    [end, begin]
                } else {
                    [begin, end]
                });
            }
            tour.push(nodes.end());
            tour.dedup();
            cost(strokes, &nodes.way(&tour), Point::default(), Travel::Length)
        });
        costs.fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn the_cost_of_a_row_is_that_of_its_best_turned_parts(
            ends in proptest::collection::vec([(0..9, 0..9), (0..9, 0..9)], 4..9),
            cuts in [0.0..1.0, 0.0..1.0, 0.0..1.0_f64],
            backward: [bool; 2],
        ) {
            let strokes: Vec<Stroke> = ends.into_iter().map(line).collect();
            let way = given(&strokes);
            let nodes = Nodes::new(&strokes, &way, Point::default(), Travel::Length, &CancelToken::default());
            let mut row = Row::new(&nodes, &nodes.tour(&way));
            let count = row.len();
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "few")]
            let mut cuts = cuts.map(|share| 1 + (share * (count - 1) as f64) as usize);
            cuts.sort_unstable();
            let [a, b, c] = cuts;
            let part = |from, to, is_backward| Part { from, to, is_backward };
            let parts = [
                part(0, a, false),
                part(b, c, backward[0]),
                part(a, b, backward[1]),
                part(c, count, false),
            ];
            let reported = row.cost_of(&parts);
            let mut kept = row.clone();
            row.commit(&mut kept);
            row.put(&parts);
            let order: Vec<u32> = (1..count).map(|place| row.node(place)).collect();
            let expected = least_of_all(&nodes, &strokes, &order);
            let tour = cost(&strokes, &nodes.way(&row.tour()), Point::default(), Travel::Length);
            let ways: f64 = (0..count).map(|place| row.way(place)).sum();
            let whole = row.cost_of(&[part(0, count, false)]);
            for found in [reported, row.cost(), tour, ways, whole] {
                // Costs are in single precision, seven digits of at most 13 mm for each stroke.
                prop_assert!((found - expected).abs() < 1e-5, "{found}, expected {expected} to 1e-5");
            }
            row.undo(&kept);
            let all = [part(0, count, false)];
            prop_assert_eq!(row.tour(), kept.tour());
            prop_assert_eq!([row.cost(), row.cost_of(&all)], [kept.cost(), kept.cost_of(&all)]);
            prop_assert_eq!(&row.places, &kept.places);
        }
    }
}
