//! The order of strokes: less way to go with the pen up.

mod greedy;
mod near;
mod nodes;
mod random;
mod search;
mod stop;
mod tour;
mod travel;
mod tree;

use self::greedy::greedy;
use self::nodes::Nodes;
use self::random::Random;
use self::stop::Stop;
pub use self::travel::{Travel, travel_mm};
use crate::point::{Point, Stroke};

/// How long to search for a good order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// What is to be small.
    pub travel: Travel,
    /// How many times a good order is disturbed and made good again.
    pub kicks: u32,
    /// Decides where it is disturbed: the same seed gives the same order.
    pub seed: u64,
}

impl Search {
    /// Enough for most drawings: within about 1 % of the best order known, in well under a second.
    #[must_use]
    pub const fn of(travel: Travel) -> Self {
        Self {
            travel,
            kicks: 20_000,
            seed: 1,
        }
    }
}

/// Puts strokes in an order in which the pen, beginning at `start`, travels little between them.
/// Open strokes may be drawn from either end and closed ones from any corner. Never worse than the
/// order given.
#[must_use]
pub fn order(strokes: Vec<Stroke>, start: Point, search: &Search) -> Vec<Stroke> {
    let given: Vec<Stop> = (0..)
        .zip(&strokes)
        .filter(|(_, stroke)| !stroke.points.is_empty())
        .map(|(stroke, _)| Stop { stroke, point: 0 })
        .collect();
    let best = searched(&strokes, &given, start, search);
    if cost(&strokes, &best, start, search.travel) < cost(&strokes, &given, start, search.travel) {
        drawn(strokes, &best)
    } else {
        strokes
    }
}

fn searched(strokes: &[Stroke], given: &[Stop], start: Point, search: &Search) -> Vec<Stop> {
    let mut random = Random(search.seed);
    let nodes = Nodes::new(strokes, given, start, search.travel);
    let mut way = nodes.way(&greedy(&nodes));
    let loops = reloop(strokes, &mut way, start, search.travel);
    let rounds = if loops { 4 } else { 1 };
    for round in 0..rounds {
        let nodes = Nodes::new(strokes, &way, start, search.travel);
        let mut tour = search::Search::new(&nodes, nodes.tour(&way));
        tour.settle_all();
        if round >= 2 || rounds == 1 {
            for _ in 0..search.kicks / if rounds == 1 { 1 } else { 2 } {
                tour.kick(&mut random);
            }
        }
        way = nodes.way(tour.tour());
        reloop(strokes, &mut way, start, search.travel);
    }
    way
}

fn reloop(strokes: &[Stroke], way: &mut [Stop], start: Point, travel: Travel) -> bool {
    let mut any = false;
    let mut here = start;
    for i in 0..way.len() {
        let stroke = &strokes[way[i].stroke as usize];
        if stroke.closed && stroke.points.len() > 2 {
            any = true;
            let next = way.get(i + 1).map(|n| n.begin(&strokes[n.stroke as usize]));
            let cost = |p: Point| {
                travel.cost(here.distance(p)) + next.map_or(0.0, |n| travel.cost(n.distance(p)))
            };
            let mut best = (cost(way[i].begin(stroke)), way[i].point);
            for (c, &p) in (0..).zip(&stroke.points[1..]) {
                if cost(p) < best.0 {
                    best = (cost(p), c + 1);
                }
            }
            way[i].point = best.1;
        }
        here = way[i].end(stroke);
    }
    any
}

fn cost(strokes: &[Stroke], way: &[Stop], start: Point, travel: Travel) -> f64 {
    let mut here = start;
    let mut sum = 0.0;
    for stop in way {
        let stroke = &strokes[stop.stroke as usize];
        sum += travel.cost(here.distance(stop.begin(stroke)));
        here = stop.end(stroke);
    }
    sum
}

fn drawn(mut strokes: Vec<Stroke>, way: &[Stop]) -> Vec<Stroke> {
    way.iter()
        .map(|stop| stop.drawn(std::mem::take(&mut strokes[stop.stroke as usize])))
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SEARCH: Search = Search {
        travel: Travel::Length,
        kicks: 100,
        seed: 1,
    };

    fn line(points: &[(f64, f64)]) -> Stroke {
        Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
    }

    #[test]
    fn goes_on_with_the_nearest_and_turns_it_where_that_is_nearer() {
        let strokes = vec![
            line(&[(50.0, 0.0), (60.0, 0.0)]),
            line(&[(20.0, 0.0), (11.0, 0.0)]),
            line(&[(0.0, 0.0), (10.0, 0.0)]),
        ];
        let ordered = order(strokes, Point::default(), &SEARCH);
        let starts: Vec<f64> = ordered.iter().map(|s| s.points[0].x).collect();
        assert_eq!(starts, [0.0, 11.0, 50.0]);
    }

    #[test]
    fn a_closed_stroke_begins_at_its_nearest_corner() {
        let mut square = line(&[(9.0, 9.0), (5.0, 9.0), (5.0, 5.0), (9.0, 5.0), (9.0, 9.0)]);
        square.closed = true;
        let ordered = order(vec![square], Point::default(), &SEARCH);
        assert_eq!(
            ordered[0].points,
            line(&[(5.0, 5.0), (9.0, 5.0), (9.0, 9.0), (5.0, 9.0), (5.0, 5.0)]).points
        );
    }

    fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
        let point = (0.0..100.0_f64, 0.0..100.0_f64).prop_map(|(x, y)| Point::new(x, y));
        let stroke = (proptest::collection::vec(point, 1..6), any::<bool>()).prop_map(
            |(mut points, closed)| {
                if closed {
                    points.push(points[0]);
                }
                Stroke { points, closed }
            },
        );
        proptest::collection::vec(stroke, 0..40)
    }

    /// What a stroke draws, whichever way it is drawn.
    fn ink(stroke: &Stroke) -> Vec<String> {
        let mut ink: Vec<String> = stroke
            .segments()
            .map(|(a, b)| {
                if (a.x, a.y) < (b.x, b.y) {
                    (a, b)
                } else {
                    (b, a)
                }
            })
            .chain(stroke.points.iter().map(|&p| (p, p)))
            .map(|pair| format!("{pair:?}"))
            .collect();
        ink.sort();
        ink.dedup();
        ink
    }

    proptest! {
        #[test]
        fn draws_every_stroke_once_and_travels_no_further(strokes in strokes()) {
            let ordered = order(strokes.clone(), Point::default(), &SEARCH);
            prop_assert!(travel_mm(&ordered, Point::default()) <= travel_mm(&strokes, Point::default()));
            let mut before: Vec<_> = strokes.iter().map(ink).collect();
            let mut after: Vec<_> = ordered.iter().map(ink).collect();
            before.sort();
            after.sort();
            prop_assert_eq!(before, after);
        }
    }
}
