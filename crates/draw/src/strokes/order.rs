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
/// On one core of a small computer, a thousand strokes take some 15 ms and a thousand kicks some 6 ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// The cost to minimise.
    pub travel: Travel,
    /// The number of kicks for 10,000 strokes: random changes after which the order is improved locally. Fewer
    /// strokes get fewer kicks, and so do more than 14,000. A worse result is undone, except for small losses at
    /// the beginning. In a long order, a kick that rewrites much counts as several. Without kicks, travel is
    /// about 5 % above the optimum; with five per stroke, less than 1 %.
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

/// Returns the best order found. With closed strokes the search runs in rounds, because a loop with
/// a new start may belong elsewhere in the order.
fn searched(
    strokes: &[Stroke],
    given: &[Stop],
    start: Point,
    search: &Search,
    cancel: &CancelToken,
) -> Vec<Stop> {
    let mut random = Random::new(search.seed);
    let turn = |way: &mut Vec<Stop>| turn_loops(strokes, way, start, search.travel);
    let nodes_of = |way: &[Stop]| Nodes::new(strokes, way, start, search.travel, cancel);
    let mut nodes = nodes_of(given);
    let Some(tour) = greedy(&nodes, cancel) else {
        return given.to_vec();
    };
    let mut way = nodes.way(&tour);
    // Without closed strokes the nodes never change, so a single round suffices.
    let rounds = if turn(&mut way) > 0.0 { ROUNDS } else { 1 };
    for _ in 0..rounds {
        // The starts of closed strokes may have moved, which moves their nodes.
        if rounds > 1 {
            nodes = nodes_of(&way);
        }
        let most = kicks(search, way.len());
        let tour = nodes.tour(&way);
        let mut local_search = LocalSearch::new(&nodes, tour, cancel);
        local_search.settle_all();
        let mean = cost(strokes, &way, start, search.travel) / lossy(way.len().max(1));
        let kicks = most / rounds;
        let warmth = mean * patience(most, way.len());
        // Half of the kicks exchange edges; the rest moves parts, which exchanges cannot do.
        local_search.anneal(kicks - kicks / 2, warmth, &mut random);
        let mut turns = Turns::new(&nodes, local_search.tour(), cancel);
        let left = moved(&mut turns, kicks / 2, &mut random);
        local_search.set(turns.tour());
        // Moved parts open new exchanges; start cooler, because the order is already good.
        local_search.anneal(left, warmth / 4.0, &mut random);
        way = nodes.way(local_search.tour());
        turn(&mut way);
    }
    way
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
/// In large drawings a kick costs more and gains less, so the number decreases again.
fn kicks(search: &Search, strokes: usize) -> u32 {
    let strokes = u32::try_from(strokes).unwrap_or(u32::MAX);
    let share = |part: u32, of: u32| u64::from(search.kicks) * u64::from(part) / u64::from(of);
    let kicks = if strokes < STROKES_FOR_ALL {
        share(strokes, STROKES_FOR_ALL) + u64::from(MIN_KICKS.min(search.kicks))
    } else {
        share(MANY_STROKES, strokes.max(MANY_STROKES))
    };
    u32::try_from(kicks).map_or(search.kicks, |kicks| kicks.min(search.kicks))
}

/// Returns the initial tolerance for worse orders, as a share of the best value for enough kicks
/// per stroke.
fn patience(kicks: u32, strokes: usize) -> f64 {
    (f64::from(kicks) / (f64::from(KICKS_FOR_EACH) * lossy(strokes.max(1)))).min(1.0)
}

#[expect(clippy::cast_precision_loss, reason = "far fewer than 2^53")]
const fn lossy(count: usize) -> f64 {
    count as f64
}

const ROUNDS: u32 = 2;
/// With this many kicks per stroke, the search begins with the full tolerance for worse orders.
const KICKS_FOR_EACH: u32 = 40;
/// The number of strokes from which on there are as many kicks as requested.
const STROKES_FOR_ALL: u32 = 10_000;
/// The number of strokes above which there are fewer kicks.
const MANY_STROKES: u32 = 14_000;
/// What is added for a handful of strokes, which takes no time.
const MIN_KICKS: u32 = 2000;
/// The kicks for moving parts are divided into this many shares, and end when a share shortens the
/// travel by less than [`WORTHWHILE`].
const SHARES: u32 = 4;
const WORTHWHILE: f64 = 0.001;

#[cfg(test)]
mod tests;
