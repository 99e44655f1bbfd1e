//! Splicing: a path combined from the best parts of others.
//!
//! Of several paths in a corridor, each is the fastest somewhere, and none of them everywhere.
//! Plans provide the duration of each vector. The spliced path follows one of them until it pays to
//! switch to another.
//!
//! ```text
//!     *----.____                  ___.*     One vector leads from a corner of the one path to a corner of the other:
//!               *---.___  ___.---'          it passes the stroke as they do, is not seen to turn too fast, and takes
//!     o--------o.________o_________.o       as long as theirs in the mean.
//! ```

use std::iter::successors;

use dobot_geometry::Point;
use dobot_plan::DurationEstimator;

use super::corridor::{Corner, Corridor};
use super::timed::{TOO_SHARP_S, seen_mm};
use super::visibility::Visibility;

/// Returns the path of least time with a cost per switch, in s; `None` if it is one of the given
/// paths. Each of these comes with the durations of its vectors, in s; all have the same ends.
pub(super) fn spliced<'a>(
    corridor: &Corridor<'_>,
    planned: impl Iterator<Item = (&'a [Corner], &'a [f64])>,
    change_s: f64,
    estimator: &DurationEstimator,
) -> Option<Vec<Corner>> {
    let lengths = Lengths::of(corridor);
    let paths = Paths {
        all: planned
            .map(|(path, durations_s)| PlannedPath::new(&lengths, path, durations_s))
            .collect(),
        corridor,
        estimator,
        change_s,
    };
    let nodes = paths.nodes();
    let labels = paths.labels(&nodes);
    let last = (0..nodes.len())
        .filter(|node| paths.next_corner(nodes[*node]).is_none())
        .min_by(|a, b| labels[*a].time_s.total_cmp(&labels[*b].time_s))?;
    let before = |at: &usize| labels[*at].before;
    let mut found: Vec<Node> = successors(Some(last), before)
        .map(|node| nodes[node])
        .collect();
    found.reverse();
    let changes = found.windows(2).any(|pair| pair[0].path != pair[1].path);
    changes.then(|| found.iter().map(|node| paths.corner(*node)).collect())
}

/// A path with the planned times of its corners.
#[derive(Debug)]
struct PlannedPath<'a> {
    corners: &'a [Corner],
    /// The time of each corner, in s.
    times_s: Vec<f64>,
    /// The distance of each corner along the stroke, in mm.
    covered_mm: Vec<f64>,
}

impl<'a> PlannedPath<'a> {
    fn new(lengths: &Lengths<'_>, corners: &'a [Corner], durations_s: &[f64]) -> Self {
        let (mut times_s, mut covered_mm) = (vec![0.0], Vec::with_capacity(corners.len()));
        times_s.extend(durations_s.iter().scan(0.0, |time_s, duration_s| {
            *time_s += duration_s;
            Some(*time_s)
        }));
        // On a stroke that turns back, a corner may lie before its predecessor.
        covered_mm.extend(corners.iter().scan(0.0_f64, |covered_mm, corner| {
            *covered_mm = covered_mm.max(lengths.covered_mm(corner));
            Some(*covered_mm)
        }));
        Self {
            corners,
            times_s,
            covered_mm,
        }
    }

    /// Returns the tool position at a time.
    fn at(&self, t_s: f64) -> Point {
        let after = self.times_s.partition_point(|corner_s| *corner_s <= t_s);
        let after = after.clamp(1, self.corners.len() - 1);
        let (from_s, to_s) = (self.times_s[after - 1], self.times_s[after]);
        let share = ((t_s - from_s) / (to_s - from_s)).clamp(0.0, 1.0);
        self.corners[after - 1]
            .at
            .lerp(self.corners[after].at, share)
    }

    /// Returns the time at a distance along the stroke, in s.
    fn time_s(&self, covered_mm: f64) -> f64 {
        let after = self
            .covered_mm
            .partition_point(|corner_mm| *corner_mm <= covered_mm);
        let after = after.clamp(1, self.corners.len() - 1);
        let (from_mm, to_mm) = (self.covered_mm[after - 1], self.covered_mm[after]);
        let share = (covered_mm - from_mm) / (to_mm - from_mm).max(f64::MIN_POSITIVE);
        let (from_s, to_s) = (self.times_s[after - 1], self.times_s[after]);
        from_s + share.clamp(0.0, 1.0) * (to_s - from_s)
    }

    /// Returns the tool speed around a time, in mm/s.
    fn speed_mm_s(&self, t_s: f64) -> f64 {
        self.at(t_s - AROUND_S).distance(self.at(t_s + AROUND_S)) / (2.0 * AROUND_S)
    }
}

/// The distances of a stroke's points along it, in mm.
struct Lengths<'a> {
    points: &'a [Point],
    covered_mm: Vec<f64>,
}

impl<'a> Lengths<'a> {
    fn of(corridor: &Corridor<'a>) -> Self {
        let points = corridor.points;
        let lengths = points.windows(2).map(|pair| pair[0].distance(pair[1]));
        let mut covered_mm = vec![0.0];
        covered_mm.extend(lengths.scan(0.0, |covered_mm, length_mm| {
            *covered_mm += length_mm;
            Some(*covered_mm)
        }));
        Self { points, covered_mm }
    }

    /// Returns the distance of a corner along the stroke.
    fn covered_mm(&self, corner: &Corner) -> f64 {
        let i = corner.passed;
        let Some(next) = self.points.get(i + 1) else {
            return self.covered_mm[i];
        };
        let way = *next - self.points[i];
        let share = (corner.at - self.points[i]).dot(way) / way.hypot2().max(f64::MIN_POSITIVE);
        self.covered_mm[i] + share.clamp(0.0, 1.0) * way.length()
    }
}

/// A corner of one of the paths.
#[derive(Clone, Copy, Debug)]
struct Node {
    path: usize,
    corner: usize,
    covered_mm: f64,
}

/// The fastest way to reach a node.
#[derive(Clone, Copy, Debug)]
struct Label {
    time_s: f64,
    before: Option<usize>,
}

impl Label {
    /// Notes how a node is reached from another one, if that is sooner than known.
    fn reach(labels: &mut [Self], here: usize, there: usize, took_s: f64) {
        let time_s = labels[here].time_s + took_s;
        if time_s < labels[there].time_s {
            labels[there] = Self {
                time_s,
                before: Some(here),
            };
        }
    }
}

/// Paths with common start and end.
struct Paths<'a> {
    corridor: &'a Corridor<'a>,
    all: Vec<PlannedPath<'a>>,
    estimator: &'a DurationEstimator,
    /// The cost of a switch, in s.
    change_s: f64,
}

impl Paths<'_> {
    /// Returns all corners, ordered along the stroke.
    fn nodes(&self) -> Vec<Node> {
        let mut nodes: Vec<Node> = Vec::new();
        for (path, planned) in self.all.iter().enumerate() {
            nodes.extend(
                planned
                    .covered_mm
                    .iter()
                    .enumerate()
                    .map(|(corner, covered_mm)| Node {
                        path,
                        corner,
                        covered_mm: *covered_mm,
                    }),
            );
        }
        // A stable sort keeps the corners of a path in order.
        nodes.sort_by(|a, b| a.covered_mm.total_cmp(&b.covered_mm));
        nodes
    }

    /// Returns the fastest way to reach each node.
    fn labels(&self, nodes: &[Node]) -> Vec<Label> {
        // The indices of each path's corners in the order.
        let mut places: Vec<Vec<usize>> = vec![Vec::new(); self.all.len()];
        for (place, node) in nodes.iter().enumerate() {
            places[node.path].push(place);
        }
        let begin = |node: &Node| Label {
            time_s: if node.corner == 0 { 0.0 } else { f64::INFINITY },
            before: None,
        };
        let mut labels: Vec<Label> = nodes.iter().map(begin).collect();
        // All edges lead forward along the stroke, so the label of a node is final when it is
        // expanded.
        for (here, node) in nodes.iter().enumerate() {
            if let Some(next) = self.next_corner(*node) {
                let times_s = &self.all[node.path].times_s;
                let took_s = times_s[next] - times_s[node.corner];
                let there = places[node.path][next];
                Label::reach(&mut labels, here, there, took_s);
                self.change(nodes, here, &mut labels);
            }
        }
        labels
    }

    fn corner(&self, node: Node) -> Corner {
        self.all[node.path].corners[node.corner]
    }

    /// Returns the next corner of the same path.
    fn next_corner(&self, node: Node) -> Option<usize> {
        let next = node.corner + 1;
        (next < self.all[node.path].corners.len()).then_some(next)
    }

    /// Updates the corners of other paths that one vector from here reaches sooner than known.
    fn change(&self, nodes: &[Node], here: usize, labels: &mut [Label]) {
        let (node, from) = (nodes[here], self.corner(nodes[here]));
        let own_mm = &self.all[node.path].covered_mm;
        let until_mm = own_mm[(node.corner + AHEAD).min(own_mm.len() - 1)];
        let mut visibility = Visibility::from(self.corridor, from, 0.0);
        let next = nodes.iter().enumerate().skip(here + 1);
        for (there, next) in next.take_while(|(_, node)| node.covered_mm <= until_mm) {
            let to = self.corner(*next);
            // Where the stroke turns back, distances need not follow the order of the points.
            if next.path == node.path || to.passed < visibility.passed {
                continue;
            }
            while visibility.passed < to.passed {
                if !visibility.pass(visibility.passed + 1) {
                    return;
                }
            }
            if visibility.reaches(to.at, to.passed) {
                let sooner_s = labels[there].time_s - labels[here].time_s;
                let took_s = self.took_s(node, *next, sooner_s);
                Label::reach(labels, here, there, took_s);
            }
        }
    }

    /// Returns the duration of the vector from one path to another, including the cost of the
    /// switch; only a part of it if that is far more than `sooner_s` already.
    fn took_s(&self, from: Node, to: Node, sooner_s: f64) -> f64 {
        let (own, other) = (&self.all[from.path], &self.all[to.path]);
        let (begin_s, end_s) = (own.times_s[from.corner], other.times_s[to.corner]);
        let beside_s = other.time_s(from.covered_mm);
        // Both paths cover this part of the stroke; use the mean of their durations.
        let took_s = 0.5 * (end_s - beside_s + own.time_s(to.covered_mm) - begin_s);
        let took_s = took_s.max(self.estimator.link.period_s);
        // What follows only adds to it. The margin is for rounding.
        if took_s + self.change_s > sooner_s + ROUNDING_S {
            return took_s + self.change_s;
        }
        let a = self.estimator.cornering.acceleration_mm_s2;
        let (has, wanted) = (own.speed_mm_s(begin_s), other.speed_mm_s(beside_s));
        // Changing from the speed of one path to that of the other takes time too.
        let unlike_s = (has - wanted).powi(2) / (2.0 * a * has.max(wanted).max(1.0));
        let (from_at, to_at) = (self.corner(from).at, self.corner(to).at);
        let at = |t_s: f64| {
            if t_s <= 0.0 {
                own.at(begin_s + t_s)
            } else if t_s >= took_s {
                other.at(end_s + t_s - took_s)
            } else {
                from_at.lerp(to_at, t_s / took_s)
            }
        };
        let window_s = self.estimator.cornering.window_s;
        let too_sharp_s = |t_s: f64| {
            let (before, now, after) = (at(t_s - window_s), at(t_s), at(t_s + window_s));
            let seen = ((after - now) - (now - before)).length() / seen_mm(self.estimator);
            TOO_SHARP_S * (seen - 1.0).max(0.0).powi(2)
        };
        took_s + self.change_s + unlike_s + too_sharp_s(0.0).max(too_sharp_s(took_s))
    }
}

/// More than the rounding of a time.
const ROUNDING_S: f64 = 1e-9;
/// The limit on the number of own corners that a vector to another path passes.
const AHEAD: usize = 2;
/// The time to both sides over which a speed is measured, in s.
const AROUND_S: f64 = 0.03;
