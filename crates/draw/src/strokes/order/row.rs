//! Strokes in a row, and what the ways between them cost if each is begun at the end that suits.

use super::nodes::Nodes;

/// The strokes in an order that begins with the start. Of any part of it, backwards or not, it knows at once what the
/// ways cost, whichever ends are used.
#[derive(Clone, Debug)]
pub(super) struct Row<'a> {
    nodes: &'a Nodes,
    /// For each stroke the node where it is begun if it is not turned; the first is the start.
    begins: Vec<u32>,
    /// For each node where its stroke stands in the row.
    places: Vec<u32>,
    /// The ways to each stroke from the one before.
    gaps: Vec<Ways>,
    /// A tree: the ways through a part are those through its two halves and the gap between. The root is at 1; the
    /// last half are the single strokes, filled up to a power of two.
    parts: Vec<Ways>,
    /// What the way to each stroke costs as all are turned now, and nothing after the last.
    costs: Vec<f64>,
    cost: f64,
    is_turned: Vec<bool>,
    /// For each stroke how the one before is turned best if this one is not, and if it is.
    before: Vec<[u8; 2]>,
}

/// What the ways through a part cost: with its first stroke as it is or turned, and its last as it is or turned.
type Ways = [[f64; 2]; 2];

/// The strokes from one place to before another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) is_backward: bool,
}

impl<'a> Row<'a> {
    /// The strokes of a tour.
    pub(super) fn new(nodes: &'a Nodes, tour: &[u32]) -> Self {
        let begins = begins(nodes, tour);
        let count = begins.len();
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
        };
        for place in 1..count {
            row.gaps[place] = row.gap(row.last(place - 1), row.begins[place]);
        }
        row.changed(0, count);
        row
    }

    /// The tour through the strokes.
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

    /// How many strokes there are, with the start.
    pub(super) const fn len(&self) -> usize {
        self.begins.len()
    }

    /// What all ways cost.
    pub(super) const fn cost(&self) -> f64 {
        self.cost
    }

    /// What the way to a stroke costs; nothing after the last.
    pub(super) fn way(&self, place: usize) -> f64 {
        self.costs[place]
    }

    /// A node of a stroke.
    pub(super) fn node(&self, place: usize) -> u32 {
        self.begins[place]
    }

    /// Where the stroke of a node stands.
    pub(super) fn place(&self, node: u32) -> usize {
        self.places[node as usize] as usize
    }

    /// The least that a way between two strokes costs; nothing after the last.
    pub(super) fn least(&self, a: usize, b: usize) -> f64 {
        if a >= self.len() || b >= self.len() {
            return 0.0;
        }
        let mut least = f64::INFINITY;
        for a in [self.begins[a], self.last(a)] {
            for b in [self.begins[b], self.last(b)] {
                least = least.min(self.nodes.cost(a, b));
            }
        }
        least
    }

    /// What all ways would cost if these parts, which make up the row, came in this order.
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

    /// Puts parts, which make up the row, in this order. The first, with the start, and the last stay where they are.
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

    /// Takes over another row of the same strokes.
    pub(super) fn restore(&mut self, other: &Self) {
        self.begins.copy_from_slice(&other.begins);
        self.places.copy_from_slice(&other.places);
        self.gaps.copy_from_slice(&other.gaps);
        self.parts.copy_from_slice(&other.parts);
        self.costs.copy_from_slice(&other.costs);
        self.is_turned.copy_from_slice(&other.is_turned);
        self.cost = other.cost;
    }

    /// Where a part begins, and where it ends, if neither stroke is turned.
    fn ends(&self, part: &Part) -> (u32, u32) {
        if part.is_backward {
            (self.last(part.to - 1), self.begins[part.from])
        } else {
            (self.begins[part.from], self.last(part.to - 1))
        }
    }

    /// Where a stroke ends if it is not turned.
    fn last(&self, place: usize) -> u32 {
        let begin = self.begins[place];
        // What is joined with the start is the end of the tour.
        if place == 0 {
            begin
        } else {
            self.nodes.mate(begin)
        }
    }

    /// The ways from a stroke that ends at one node to a stroke that begins at another.
    fn gap(&self, last: u32, first: u32) -> Ways {
        let mate = |node| {
            if node == self.nodes.start() {
                node
            } else {
                self.nodes.mate(node)
            }
        };
        [last, mate(last)]
            .map(|last| [first, mate(first)].map(|first| self.nodes.cost(last, first)))
    }

    /// The ways through a part.
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

    /// The strokes of some places have changed.
    fn changed(&mut self, from: usize, to: usize) {
        for place in from..to {
            let begin = self.begins[place];
            for node in [begin, self.nodes.mate(begin)] {
                self.places[node as usize] = u32::try_from(place).expect("fewer than the nodes");
            }
        }
        self.rebuild(from.max(1) - 1, to);
        self.price();
    }

    /// Builds all parts anew that hold strokes of these places.
    fn rebuild(&mut self, from: usize, to: usize) {
        let leaves = self.parts.len() / 2;
        let (mut from, mut to) = (from + leaves, to.min(leaves - 1) + leaves);
        let mut half = 1;
        while from > 1 {
            (from, to) = (from / 2, to / 2);
            for part in from..=to {
                // Where the second half of the part begins.
                let middle = (2 * part + 1) * half - leaves;
                let halves = [2 * part, 2 * part + 1].map(|it| &self.parts[it]);
                self.parts[part] = through(halves[0], &self.gaps[middle], halves[1]);
            }
            half *= 2;
        }
    }

    /// Finds out what each way costs with all strokes turned as is best for the whole.
    fn price(&mut self) {
        let mut costs = [0.0, f64::INFINITY];
        for place in 1..self.len() {
            let gap = &self.gaps[place];
            let found = [0, 1].map(|it| {
                let (a, b) = (costs[0] + gap[0][it], costs[1] + gap[1][it]);
                if b < a { (b, 1) } else { (a, 0) }
            });
            costs = found.map(|it| it.0);
            self.before[place] = found.map(|it| it.1);
        }
        let mut turned = usize::from(costs[1] < costs[0]);
        self.cost = costs[turned];
        for place in (1..self.len()).rev() {
            let before = usize::from(self.before[place][turned]);
            self.costs[place] = self.gaps[place][before][turned];
            self.is_turned[place] = turned == 1;
            turned = before;
        }
    }
}

/// The ways through two parts and the gap between them.
#[inline]
fn through(a: &Ways, gap: &Ways, b: &Ways) -> Ways {
    times(&times(a, gap), b)
}

#[inline]
fn times(a: &Ways, b: &Ways) -> Ways {
    a.map(|a| [0, 1].map(|it| smaller(a[0] + b[0][it], a[1] + b[1][it])))
}

#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The same ways backwards.
fn turned(ways: &Ways) -> Ways {
    let [[a, b], [c, d]] = *ways;
    [[a, c], [b, d]]
}

fn least(ways: &Ways) -> f64 {
    ways.iter()
        .flatten()
        .fold(f64::INFINITY, |a, &b| smaller(a, b))
}

/// For each stroke of a tour the node where it is begun, after the start.
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

/// A single stroke costs nothing, and is turned at both of its ends or at none.
const NONE: Ways = [[0.0, f64::INFINITY], [f64::INFINITY, 0.0]];
/// The start cannot be turned.
const START: Ways = [[0.0, f64::INFINITY], [f64::INFINITY, f64::INFINITY]];

#[cfg(test)]
mod tests {
    use dobot_geometry::{Point, Stroke};
    use proptest::prelude::*;

    use super::super::stops::{cost, given};
    use super::super::travel::Travel;
    use super::*;

    fn line(ends: [(i32, i32); 2]) -> Stroke {
        let point = |(x, y): (i32, i32)| Point::new(f64::from(x), f64::from(y));
        Stroke::open(ends.map(point).to_vec())
    }

    /// The least that the strokes cost in this order, by turning them in all ways.
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
        fn parts_cost_what_they_cost_with_every_stroke_turned_as_is_best(
            ends in proptest::collection::vec([(0..9, 0..9), (0..9, 0..9)], 4..9),
            cuts in [0.0..1.0, 0.0..1.0, 0.0..1.0_f64],
            backward: [bool; 2],
        ) {
            let strokes: Vec<Stroke> = ends.into_iter().map(line).collect();
            let way = given(&strokes);
            let nodes = Nodes::new(&strokes, &way, Point::default(), Travel::Length);
            let mut row = Row::new(&nodes, &nodes.tour(&way));
            let count = row.len();
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "few")]
            let mut cuts = cuts.map(|it| 1 + (it * (count - 1) as f64) as usize);
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
            row.put(&parts);
            let order: Vec<u32> = (1..count).map(|place| row.node(place)).collect();
            let expected = least_of_all(&nodes, &strokes, &order);
            let tour = cost(&strokes, &nodes.way(&row.tour()), Point::default(), Travel::Length);
            let ways: f64 = (0..count).map(|place| row.way(place)).sum();
            let whole = row.cost_of(&[part(0, count, false)]);
            for found in [reported, row.cost(), tour, ways, whole] {
                prop_assert!((found - expected).abs() < 1e-9, "{found}, expected {expected}");
            }
        }
    }
}
