//! Ordering of strokes to reduce the pen-up travel.
//!
//! ```text
//!   strokes -> nodes -> greedy tour -> search, kicks -> parts moved, kicks -> tour -> strokes
//!              (nodes, near)            (tour)         (row)                   (way)
//! ```
//!
//! The ends of the strokes are the nodes of a closed tour, in which the two ends of a stroke stay
//! neighbours. A closed stroke is one node, at its start; between searches its start moves to the
//! best corner between its neighbours.

mod greedy;
mod neighbours;
mod nodes;
mod row;
mod search;
mod stops;
mod tour;
mod travel;
mod turns;

use self::greedy::greedy;
use self::nodes::Nodes;
use self::search::LocalSearch;
use self::stops::{Stop, cost, drawn, given, turn_loops};
pub use self::travel::Travel;
use self::turns::Turns;
use dobot_geometry::CancelToken;
use dobot_geometry::{Point, Random, Stroke};

/// The objective and effort of the search.
///
/// On one core of a small computer, a thousand strokes take some 15 ms and a thousand kicks some 10 ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// The cost to minimise.
    pub travel: Travel,
    /// The number of kicks for 10,000 strokes and more: random changes after which the order is improved locally.
    /// Fewer strokes get fewer kicks. A worse result is undone, except for small losses at the beginning. In a
    /// long order, a kick that rewrites much counts as several. Without kicks, travel is about 5 % above the
    /// optimum; with five per stroke, less than 1 %.
    pub kicks: u32,
    /// The random seed of the kicks: the same seed gives the same order.
    pub seed: u64,
}

/// Orders strokes for a short pen-up travel that begins at `start`. Open strokes may be drawn from
/// either end and closed ones from any corner. The result is never worse than the given order.
/// Strokes without points come last.
#[must_use]
pub fn order(strokes: Vec<Stroke>, start: Point, search: &Search) -> Vec<Stroke> {
    order_until(strokes, start, search, &CancelToken::default())
}

/// Like [`order`], but ends the search once the drawing is cancelled.
pub(crate) fn order_until(
    strokes: Vec<Stroke>,
    start: Point,
    search: &Search,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let given = given(&strokes);
    let mut way = searched(&strokes, &given, start, search, cancel);
    let cost = |way: &[Stop]| cost(&strokes, way, start, search.travel);
    // The search may end early or find nothing, but must never make the order worse.
    if cost(&way) >= cost(&given) {
        way = given;
    }
    drawn(strokes, &way)
}

/// Returns the best order found.
fn searched(
    strokes: &[Stroke],
    given: &[Stop],
    start: Point,
    search: &Search,
    cancel: &CancelToken,
) -> Vec<Stop> {
    let mut random = Random::new(search.seed);
    let nodes = Nodes::new(strokes, given, start, search.travel, cancel);
    let Some(tour) = greedy(&nodes, cancel) else {
        return given.to_vec();
    };
    let mut order = Improved {
        strokes,
        start,
        travel: search.travel,
        way: nodes.way(&tour),
        nodes,
        cancel,
    };
    order.turn_loops();
    let kicks = kicks(search, given.len());
    let count = lossy(given.len().max(1));
    let warmth = order.cost() / count * patience(kicks, count);
    // Half of the kicks exchange edges; the rest moves parts, which exchanges cannot do.
    order.improve(|_, search| search.anneal(kicks / 2, warmth, &mut random));
    order.turn_loops();
    order.improve(|nodes, search| {
        let mut turns = Turns::new(nodes, search.tour(), cancel);
        let left = moved(&mut turns, kicks - kicks / 2, &mut random);
        search.set(turns.tour());
        // Moved parts open new exchanges; start cooler, because the order is already good.
        search.anneal(left, warmth / 4.0, &mut random);
    });
    if order.turn_loops() {
        order.improve(|_, _| {});
        order.turn_loops();
    }
    order.way
}

/// An order that gets better.
struct Improved<'a> {
    strokes: &'a [Stroke],
    start: Point,
    travel: Travel,
    way: Vec<Stop>,
    /// The nodes of the order, up to the starts of a few closed strokes.
    nodes: Nodes,
    cancel: &'a CancelToken,
}

impl Improved<'_> {
    fn cost(&self) -> f64 {
        cost(self.strokes, &self.way, self.start, self.travel)
    }

    /// Moves the starts of closed strokes to the best corners. Returns whether this gained enough to search
    /// again: a loop with a new start may belong elsewhere in the order.
    fn turn_loops(&mut self) -> bool {
        let gain = turn_loops(self.strokes, &mut self.way, self.start, self.travel);
        let is_much = gain > MUCH_TURNED * self.cost();
        if is_much {
            let Self {
                strokes,
                start,
                travel,
                cancel,
                ..
            } = *self;
            self.nodes = Nodes::new(strokes, &self.way, start, travel, cancel);
        }
        is_much
    }

    /// Searches around every node, and then as `further` does.
    fn improve(&mut self, further: impl FnOnce(&Nodes, &mut LocalSearch<'_>)) {
        let tour = self.nodes.tour(&self.way);
        let mut search = LocalSearch::new(&self.nodes, tour, self.cancel);
        search.settle_all();
        further(&self.nodes, &mut search);
        self.way = self.nodes.way(search.tour());
    }
}

/// Moves parts of a tour, with each stroke in its best direction, while that pays off. Returns the
/// number of remaining kicks.
fn moved(turns: &mut Turns, kicks: u32, random: &mut Random) -> u32 {
    turns.settle_all();
    let some = kicks.div_ceil(SHARES);
    let mut left = kicks;
    while left > 0 {
        let before = turns.cost();
        turns.kicks(some / turns.kicks_for_one(), random);
        left = left.saturating_sub(some);
        // The remaining kicks gain more as exchanges of edges.
        if turns.cost() > before * (1.0 - WORTHWHILE) {
            break;
        }
    }
    left
}

/// Returns the number of kicks: in proportion to the strokes up to [`STROKES_FOR_ALL`], because more gain nothing.
fn kicks(search: &Search, strokes: usize) -> u32 {
    let strokes = u32::try_from(strokes).unwrap_or(u32::MAX);
    let share = u64::from(search.kicks) * u64::from(strokes) / u64::from(STROKES_FOR_ALL);
    let kicks = share + u64::from(MIN_KICKS);
    u32::try_from(kicks).map_or(search.kicks, |kicks| kicks.min(search.kicks))
}

/// Returns the initial tolerance for worse orders, as a share of the best value for enough kicks
/// per stroke.
fn patience(kicks: u32, strokes: f64) -> f64 {
    (f64::from(kicks) / (f64::from(KICKS_FOR_EACH) * strokes)).min(1.0)
}

#[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53")]
const fn lossy(count: usize) -> f64 {
    count as f64
}

/// The share of the cost by which closed strokes with better starts must shorten an order to make it worth
/// another search.
const MUCH_TURNED: f64 = 0.0005;
/// With this many kicks per stroke, the search begins with the full tolerance for worse orders.
const KICKS_FOR_EACH: u32 = 15;
/// The number of strokes from which on there are as many kicks as requested.
const STROKES_FOR_ALL: u32 = 10_000;
/// What is added for a handful of strokes, which takes no time.
const MIN_KICKS: u32 = 800;
/// The kicks for moving parts are divided into this many shares, and end when a share shortens the
/// travel by less than [`WORTHWHILE`].
const SHARES: u32 = 4;
const WORTHWHILE: f64 = 0.001;

#[cfg(test)]
mod tests;
