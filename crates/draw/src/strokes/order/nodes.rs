//! The ends of the strokes as nodes of a tour.

use dobot_geometry::{BoxTree, CancelToken, Point, Random, Stroke};

use super::neighbours::{NEAR, near};
use super::search::STROKE;
use super::stops::Stop;
use super::travel::{Fare, Travel};

/// The nodes: two for a stroke that may be drawn from either end, one for a dot or a closed stroke,
/// one for the pen's start, and one that ends the tour.
#[derive(Debug)]
pub(super) struct Nodes {
    /// The positions, with neighbours close together in memory. The last one, which ends the tour,
    /// is NaN, so that the way to it costs nothing.
    at: Vec<Point>,
    /// The other end of the same stroke, or the node itself.
    mate: Vec<u32>,
    /// The stroke and its point represented by the node.
    stops: Vec<Stop>,
    /// The nearest neighbours of each node.
    near: Vec<[Near; NEAR]>,
    fare: Fare,
}

/// A neighbour and the cost of the way to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) node: u32,
    /// In single precision, as all costs are, so that sums of them agree.
    pub(super) cost: f32,
}

impl Nodes {
    /// Creates the nodes of ordered strokes with their starts. Once it is cancelled, nodes have no
    /// neighbours.
    pub(super) fn new(
        strokes: &[Stroke],
        way: &[Stop],
        start: Point,
        travel: Travel,
        cancel: &CancelToken,
    ) -> Self {
        // The position, stroke (if any) and point of each node.
        let mut stops = vec![(
            start,
            Stop {
                stroke: NONE,
                point: 0,
            },
        )];
        for &stop in way {
            let (begin, end) = (stop.begin(strokes), stop.end(strokes));
            stops.push((begin, stop));
            if end != begin {
                stops.push((end, stop.other_end(strokes)));
            }
        }
        let tree = BoxTree::sort(&mut stops, |stop| (stop.0, stop.0));
        let (mut at, mut stops): (Vec<Point>, Vec<Stop>) = stops.into_iter().unzip();
        let fare = Fare::of(travel);
        let near = (0..).zip(near(&tree, &at, &mates(&stops, strokes.len()), cancel));
        let near = near.map(|(node, near)| {
            near.map(|neighbour| Near {
                node: neighbour,
                cost: way_cost(fare, &at, node, neighbour),
            })
        });
        let near = near.collect();
        at.push(Point::new(f64::NAN, f64::NAN));
        stops.push(Stop {
            stroke: NONE,
            point: 0,
        });
        Self {
            mate: mates(&stops, strokes.len()),
            at,
            stops,
            near,
            fare,
        }
    }

    /// Returns the number of nodes, including start and end.
    pub(super) fn len(&self) -> u32 {
        u32::try_from(self.at.len()).expect("the tree has numbered them with 32 bits")
    }

    /// Returns the cost of the way between two nodes.
    #[inline]
    pub(super) fn cost(&self, a: u32, b: u32) -> f64 {
        way_cost(self.fare, &self.at, a, b).into()
    }

    /// Whether the cost of the way between two nodes may be below this one, which is above 0.
    #[inline]
    pub(super) fn may_cost_less(&self, a: u32, b: u32, cost: f64) -> bool {
        let way = self.at[b as usize] - self.at[a as usize];
        // The way to the end, which is NaN, costs nothing.
        way.hypot2().max(0.0) <= self.fare.most_mm2(cost)
    }

    /// Returns the least cost of the ways from any of these nodes to any of the others: that of the shortest.
    #[inline]
    pub(super) fn least_cost(&self, from: [u32; 2], to: [u32; 2]) -> f64 {
        let length2 = |a: u32, b: u32| (self.at[b as usize] - self.at[a as usize]).hypot2();
        let shortest2 = |a: u32| length2(a, to[0]).min(length2(a, to[1]));
        let shortest2 = shortest2(from[0]).min(shortest2(from[1]));
        rounded_cost(self.fare, shortest2).into()
    }

    /// Returns the cost of an edge of a tour: that of the way, or [`STROKE`].
    pub(super) fn edge_cost(&self, a: u32, b: u32) -> f32 {
        if self.is_stroke(a, b) {
            return STROKE;
        }
        way_cost(self.fare, &self.at, a, b)
    }

    /// Whether the edge between two neighbours of the tour is a stroke, which must stay.
    #[inline]
    pub(super) fn is_stroke(&self, a: u32, b: u32) -> bool {
        self.mate[a as usize] == b
    }

    /// Returns the nearest neighbours in order, without the other end of the same stroke; missing
    /// ones are filled with the node itself.
    #[inline]
    pub(super) fn near(&self, node: u32) -> &[Near] {
        self.near.get(node as usize).map_or(&[], |near| near)
    }

    /// Returns a random neighbour of a node, or the other end of that neighbour's stroke.
    pub(super) fn neighbour(&self, node: u32, random: &mut Random) -> Option<u32> {
        let near = self.near(node);
        let count = u32::try_from(near.len()).expect("a handful");
        let next = near.get(random.below(count.max(1)) as usize)?.node;
        let mate = self.mate(next);
        let is_other_end = mate != self.end() && random.below(2) == 0;
        Some(if is_other_end { mate } else { next })
    }

    pub(super) fn point(&self, node: u32) -> Point {
        self.at[node as usize]
    }

    pub(super) fn mate(&self, node: u32) -> u32 {
        self.mate[node as usize]
    }

    pub(super) fn end(&self) -> u32 {
        self.len() - 1
    }

    /// Returns the start of the pen, which is joined with the end as if both were a stroke.
    pub(super) fn start(&self) -> u32 {
        self.mate(self.end())
    }

    /// Returns the tour through the strokes in an order.
    pub(super) fn tour(&self, way: &[Stop]) -> Vec<u32> {
        let most = way.iter().map(|stop| stop.stroke).max().unwrap_or(0);
        let mut of_stroke = vec![NONE; most as usize + 1];
        for (node, stop) in (0..).zip(&self.stops) {
            if stop.stroke != NONE {
                of_stroke[stop.stroke as usize] = node;
            }
        }
        let mut tour = vec![self.start()];
        for stop in way {
            let node = of_stroke[stop.stroke as usize];
            let mate = self.mate(node);
            let begins = self.stops[node as usize].point == stop.point;
            tour.push(if begins { node } else { mate });
            if mate != node {
                tour.push(if begins { mate } else { node });
            }
        }
        tour.push(self.end());
        tour
    }

    /// Returns the order of the strokes in a tour.
    pub(super) fn way(&self, tour: &[u32]) -> Vec<Stop> {
        let start = tour.iter().position(|&node| node == self.start());
        let start = start.expect("a tour passes its start");
        let size = tour.len();
        let forward = tour[(start + size - 1) % size] == self.end();
        let mut way = Vec::with_capacity(size);
        let mut last = NONE;
        for step in 1..size - 1 {
            let place = if forward {
                start + step
            } else {
                start + size - step
            };
            let stop = self.stops[tour[place % size] as usize];
            if stop.stroke != last {
                way.push(stop);
                last = stop.stroke;
            }
        }
        way
    }
}

#[inline]
fn way_cost(fare: Fare, at: &[Point], a: u32, b: u32) -> f32 {
    rounded_cost(fare, (at[b as usize] - at[a as usize]).hypot2())
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "seven digits suffice")]
fn rounded_cost(fare: Fare, length2: f64) -> f32 {
    // `max` returns the number if the other value is NaN: the way to the end costs nothing.
    fare.cost(length2.sqrt().max(0.0)) as f32
}

/// Returns for each node the other node of the same stroke, or itself.
fn mates(stops: &[Stop], strokes: usize) -> Vec<u32> {
    let mut mate: Vec<u32> = (0..).take(stops.len()).collect();
    let mut first = vec![NONE; strokes + 1];
    for (node, stop) in (0..).zip(stops) {
        let slot = if stop.stroke == NONE {
            strokes
        } else {
            stop.stroke as usize
        };
        let other = std::mem::replace(&mut first[slot], node);
        if other != NONE {
            mate[node as usize] = other;
            mate[other as usize] = node;
        }
    }
    mate
}

const NONE: u32 = u32::MAX;
