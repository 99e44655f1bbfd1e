//! The path that takes the least time, as far as one vector after the other can tell.
//!
//! Places for corners lie along the stroke, a few for each vector of the path with the fewest, on the stroke and to both
//! sides of it. From each place to those that one vector reaches goes a way that takes a time: that of the
//! fastest motion along the stroke, or more where the corner at its begin is too sharp for that, or where the
//! link brings no more vectors. The ways that together take the least time are the path.
//!
//! ```text
//!     o   o   o   o   o       each o is a place; the vector goes on from *, whose own vector came from
//!   ..o...o...*---o--.o..     farther left: so the corner at * is known, and the time up to it
//!     o   o   o   o   o
//! ```

use dobot_geometry::{Point, Vec2};
use dobot_plan::{ChainVector, Pace};

use super::corridor::{Corner, Corridor};
use super::visibility::Visibility;

/// The corners of the path that takes the least time in a corridor; `None` if no vectors lead to its end.
/// `fewest` is the path with the fewest vectors, and `slowness` says how long the fastest motion takes, in s
/// for each mm, from each point to the next.
pub(super) fn timed(
    corridor: &Corridor<'_>,
    fewest: &[Corner],
    slowness: &[f64],
    pace: &Pace,
) -> Option<Vec<Corner>> {
    let places = places(corridor, fewest, slowness);
    let mut labels = vec![Label::UNREACHED; places.len()];
    labels[0].time_s = 0.0;
    for here in 0..places.len() - 1 {
        if labels[here].time_s.is_finite() {
            go_on(corridor, &places, &mut labels, here, pace);
        }
    }
    path(&places, &labels)
}

/// A place where a corner may be.
#[derive(Clone, Copy, Debug)]
struct Place {
    at: Point,
    /// The last point of the stroke that is passed here.
    passed: usize,
    /// Which step along the stroke it belongs to.
    step: usize,
    /// When the fastest motion comes by, in s.
    time_s: f64,
    /// How fast it is there, in mm/s.
    speed_mm_s: f64,
}

/// How a place is reached in the least time.
#[derive(Clone, Copy, Debug)]
struct Label {
    time_s: f64,
    /// The place before.
    before: usize,
    /// The vector that leads here.
    way: Vec2,
    /// How long it takes, in s.
    took_s: f64,
    /// By how much it turned from the one before, in radians, to the left.
    turn: f64,
}

impl Label {
    const UNREACHED: Self = Self {
        time_s: f64::INFINITY,
        before: 0,
        way: Vec2::ZERO,
        took_s: 0.0,
        turn: 0.0,
    };

    /// How the next place is reached from this one.
    fn next(&self, from: &Place, to: &Place, before: usize, pace: &Pace) -> Self {
        let way = to.at - from.at;
        let turn = self.way.cross(way).atan2(self.way.dot(way));
        let arm_s = to.time_s - from.time_s + self.corner_s(way, turn, from, to, pace);
        let took_s = arm_s.max(SLOWER_LINK * pace.link.period_s);
        Self {
            time_s: self.time_s + took_s,
            took_s,
            before,
            way,
            turn,
        }
    }

    /// How much longer it takes because of the corner before a vector, in s.
    fn corner_s(&self, way: Vec2, turn: f64, from: &Place, to: &Place, pace: &Pace) -> f64 {
        if self.way == Vec2::ZERO {
            return 0.0;
        }
        let speed_mm_s = from.speed_mm_s;
        let [before, after] =
            [self.way, way].map(|it| ChainVector::of([it.x, it.y, 0.0], pace.speed_mm_s));
        let junction_mm_s = pace.cornering.junction(&before, &after).speed_mm_s();
        // Other corners within the window are seen together with this one.
        let (a, window_s) = (pace.cornering.acceleration_mm_s2, pace.cornering.window_s);
        let next_s = to.time_s - from.time_s;
        let beside = |took_s: f64| (1.0 - took_s / window_s).max(0.0);
        let seen = (turn + self.turn * beside(self.took_s) + turn * beside(next_s)).abs();
        let along = ((to.speed_mm_s - speed_mm_s) / next_s / a).clamp(-MOST_ALONG, MOST_ALONG);
        let seen_mm_s = a * (1.0 - along * along).sqrt() * window_s / seen;
        let corner_mm_s = junction_mm_s.min(seen_mm_s);
        let missing_mm_s = speed_mm_s - corner_mm_s;
        if missing_mm_s <= 0.0 {
            return 0.0;
        }
        // Braking and speeding up again, or as slow all the way from the middle of one vector to that of the next.
        let dip_s = missing_mm_s * missing_mm_s / (pace.cornering.acceleration_mm_s2 * speed_mm_s);
        let slow_mm = 0.5 * (before.length_mm + after.length_mm);
        dip_s.min(slow_mm / corner_mm_s - slow_mm / speed_mm_s)
    }
}

/// Notes all places that one vector from here reaches sooner than was known.
fn go_on(
    corridor: &Corridor<'_>,
    places: &[Place],
    labels: &mut [Label],
    here: usize,
    pace: &Pace,
) {
    let from = places[here];
    let corner = Corner {
        at: from.at,
        passed: from.passed,
        before: 0,
    };
    let mut visibility = Visibility::from(corridor, corner, 0.0);
    let mut passed = from.passed;
    let farther = places.iter().enumerate().skip(here + 1);
    for (there, to) in farther.take_while(|(_, to)| to.step <= from.step + MOST_STEPS) {
        if to.step == from.step {
            continue;
        }
        while passed < to.passed {
            passed += 1;
            if !visibility.pass(passed) {
                return;
            }
        }
        let soonest_s = labels[here].time_s + at_least_s(&from, to, pace);
        if soonest_s < labels[there].time_s && visibility.reaches(to.at, to.passed) {
            let next = labels[here].next(&from, to, here, pace);
            if next.time_s < labels[there].time_s {
                labels[there] = next;
            }
        }
    }
}

/// How long a vector takes wherever it comes from, in s.
fn at_least_s(from: &Place, to: &Place, pace: &Pace) -> f64 {
    (to.time_s - from.time_s).max(SLOWER_LINK * pace.link.period_s)
}

/// The places for corners, in their order; first the begin, last the end.
fn places(corridor: &Corridor<'_>, fewest: &[Corner], slowness: &[f64]) -> Vec<Place> {
    let points = corridor.points;
    let mut places = vec![Place {
        at: fewest[0].at,
        passed: 0,
        step: 0,
        time_s: 0.0,
        speed_mm_s: 0.0,
    }];
    let (mut time_s, mut step) = (0.0, 0);
    for pair in fewest.windows(2) {
        let range = pair[0].passed..pair[1].passed;
        let length_mm: f64 = range
            .clone()
            .map(|i| points[i].distance(points[i + 1]))
            .sum();
        let apart_mm = length_mm / f64::from(STEPS);
        let mut next_mm = apart_mm * 0.5;
        for i in range {
            let (a, b) = (points[i], points[i + 1]);
            let long_mm = a.distance(b);
            if i > 0 && long_mm > 0.0 && is_sharp(points[i - 1], a, b) {
                step += 1;
                places.extend(beside(corridor, a, i, 0.0).map(|at| Place {
                    at,
                    passed: i,
                    step,
                    time_s,
                    speed_mm_s: 1.0 / slowness[i],
                }));
            }
            while next_mm < long_mm {
                step += 1;
                let at = a.lerp(b, next_mm / long_mm);
                let passing = Place {
                    at,
                    passed: i,
                    step,
                    time_s: time_s + next_mm * slowness[i],
                    speed_mm_s: 1.0 / slowness[i],
                };
                places.extend(beside(corridor, at, i, next_mm).map(|at| Place { at, ..passing }));
                next_mm += apart_mm;
            }
            next_mm -= long_mm;
            time_s += long_mm * slowness[i];
        }
    }
    places.push(Place {
        at: fewest[fewest.len() - 1].at,
        passed: points.len() - 1,
        step: step + 1,
        time_s,
        speed_mm_s: 0.0,
    });
    places
}

fn is_sharp(before: Point, here: Point, after: Point) -> bool {
    let (came, goes) = (here - before, after - here);
    came.dot(goes) < SHARP_COS * came.length() * goes.length()
}

/// A place on the stroke behind point `i`, and two beside it.
fn beside(corridor: &Corridor<'_>, at: Point, i: usize, behind_mm: f64) -> [Point; 3] {
    let [left, right] = corridor.beside(i);
    if behind_mm == 0.0 {
        return [at, left, right];
    }
    let way = corridor.points[i + 1] - corridor.points[i];
    let off = way.turn_90() * (SIDE * corridor.radii[i].min(corridor.radii[i + 1]) / way.length());
    [at, at + off, at - off]
}

fn path(places: &[Place], labels: &[Label]) -> Option<Vec<Corner>> {
    let mut at = places.len() - 1;
    if labels[at].time_s.is_infinite() {
        return None;
    }
    let corner = |at: usize| Corner {
        at: places[at].at,
        passed: places[at].passed,
        before: 0,
    };
    let mut path = vec![corner(at)];
    while at > 0 {
        at = labels[at].before;
        path.push(corner(at));
    }
    path.reverse();
    Some(path)
}

/// So many steps along the stroke for each vector of the fewest.
const STEPS: u32 = 6;
/// A vector goes over at most so many.
const MOST_STEPS: usize = 16;
/// How far beside the stroke places lie, as a share of the tolerance.
const SIDE: f64 = 0.99;
/// The cosine of a turn of a stroke from which on the point itself is a place.
const SHARP_COS: f64 = 0.94;
/// Vectors that take hardly longer than their packets would slow their neighbours down: the link counts as that many times
/// slower than it is.
const SLOWER_LINK: f64 = 1.2;
/// Of the acceleration this share at most counts as used along the way.
const MOST_ALONG: f64 = 0.95;
