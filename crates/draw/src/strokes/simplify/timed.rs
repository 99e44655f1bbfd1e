//! A path whose vectors take whole ticks of the fastest motion.
//!
//! At each tick of that motion, there are places for corners at the tool position, on the stroke
//! and to both sides of it. Places that one vector joins are connected by an edge, which takes as
//! many ticks as the motion between them, and at least as many as the link needs for the next
//! vector. Excess acceleration at the corner at its start counts as additional time. The result is
//! the shortest path in this graph.
//!
//! ```text
//!     o   o     o      o      o     each o is a place; the tool comes by at a tick. The vector goes on from *,
//!   ..o...o.....*------o-..   o     the place of a tick: so it takes whole ticks at the speed of the motion, and no
//!     o   o     o      o      o     time is lost when a stock arm cuts it into them
//! ```

use std::collections::VecDeque;
use std::ops::Range;

use dobot_arm::TICK_S;
use dobot_geometry::{Point, Vec2};
use dobot_plan::{DurationEstimator, Motion};

use super::corridor::{Corner, Corridor};
use super::visibility::Visibility;

/// The fastest motion along a path, by which other paths are measured.
#[derive(Debug)]
pub(super) struct Course<'a> {
    path: &'a [Corner],
    motion: Motion,
    /// The distance along the path at each tick, in mm.
    covered_mm: Vec<f64>,
    /// The sampling window of the acceleration, in s.
    window_s: f64,
}

impl<'a> Course<'a> {
    /// Creates the motion along a path whose vectors take at least `least_s` each. Speeds in curves
    /// are reduced by the factor `gentler`; the maximum speed is not.
    pub(super) fn along(
        path: &'a [Corner],
        least_s: f64,
        gentler: f64,
        estimator: &DurationEstimator,
    ) -> Self {
        let mut gentle = *estimator;
        gentle.cornering.acceleration_mm_s2 /= gentler * gentler;
        let increments = path.windows(2).map(|pair| {
            let way = pair[1].at - pair[0].at;
            [way.x, way.y, 0.0]
        });
        let motion = Motion::along(&gentle, least_s, increments);
        let times_s = (0_u32..).map(|tick| f64::from(tick) * TICK_S);
        let mut covered_mm: Vec<f64> = times_s
            .take_while(|time_s| *time_s < motion.duration_s())
            .map(|time_s| motion.covered_mm(time_s))
            .collect();
        covered_mm.push(motion.covered_mm(motion.duration_s()));
        Self {
            motion,
            covered_mm,
            window_s: estimator.cornering.window_s,
            path,
        }
    }

    /// Returns the distance along the path at a time, in mm, with constant speed between ticks.
    fn covered_mm(&self, time_s: f64) -> f64 {
        let ticks = (time_s * (1.0 / TICK_S)).max(0.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not below 0"
        )]
        let tick = ticks as usize;
        let last = self.covered_mm.len() - 1;
        if tick >= last {
            return self.covered_mm[last];
        }
        let (from, to) = (self.covered_mm[tick], self.covered_mm[tick + 1]);
        from + (to - from) * ticks.fract()
    }

    /// Returns the path in a corridor with the least time at the speeds of this motion; `None` if
    /// no vectors lead to its end. Its corners are on the stroke or `sides` beside it, as shares of
    /// the tolerance.
    pub(super) fn timed(
        &self,
        corridor: &Corridor<'_>,
        sides: &[f64],
        estimator: &DurationEstimator,
    ) -> Option<TimedPath> {
        let places = CornerPlaces::of(self, corridor, sides).all;
        let rates = Rates::of(estimator);
        // Pruning late places is fast, but may cut off the only path; then search without it.
        let quickly = labels(corridor, &places, &rates, MAX_LATE_S);
        let reached = |labels: &[Label]| labels[labels.len() - 1].time_s.is_finite();
        let labels = if reached(&quickly) {
            quickly
        } else {
            labels(corridor, &places, &rates, f64::INFINITY)
        };
        reached(&labels).then(|| TimedPath {
            path: path(&places, &labels),
            time_s: labels[labels.len() - 1].time_s,
        })
    }
}

/// A path whose vectors take whole ticks.
#[derive(Debug)]
pub(super) struct TimedPath {
    pub(super) path: Vec<Corner>,
    /// Its estimated duration without a plan, in s.
    pub(super) time_s: f64,
}

/// A possible place of a corner.
#[derive(Clone, Copy, Debug)]
struct CornerPlace {
    at: Point,
    /// The last point of the stroke that is passed here.
    passed: usize,
    /// The index of its step along the stroke.
    step: usize,
    /// The time of the motion, in s.
    time_s: f64,
    /// The distance of the motion along its path, and its distances in the windows before and
    /// after, in mm.
    covered_mm: f64,
    before_mm: f64,
    after_mm: f64,
}

/// The possible places of corners in order; the start first, the end last.
struct CornerPlaces<'a> {
    course: &'a Course<'a>,
    corridor: &'a Corridor<'a>,
    sides: &'a [f64],
    step: usize,
    all: Vec<CornerPlace>,
    /// The number of ticks since the last point of the stroke.
    since_point: usize,
    /// The last ticks that are too far from that point; they are needed if the next point comes
    /// soon.
    far: VecDeque<TickPlace>,
}

/// The position of the motion at a tick.
#[derive(Clone, Copy, Debug)]
struct TickPlace {
    on_path: Point,
    /// The unit direction of the path.
    unit: Vec2,
    passed: usize,
    time_s: f64,
    covered_mm: f64,
}

impl<'a> CornerPlaces<'a> {
    fn of(course: &'a Course<'a>, corridor: &'a Corridor<'a>, sides: &'a [f64]) -> Self {
        let mut places = Self {
            course,
            corridor,
            sides,
            step: 0,
            all: Vec::new(),
            since_point: 0,
            far: VecDeque::new(),
        };
        let (path, last) = (course.path, corridor.points.len() - 1);
        places.add([path[0].at], 0, 0.0, 0.0);
        let (mut tick, mut begin_mm) = (1.0, 0.0);
        for pair in path.windows(2) {
            let way = pair[1].at - pair[0].at;
            let (length_mm, unit) = (way.length(), way * (1.0 / way.length()));
            let mut passed = pair[0].passed;
            loop {
                let time_s = tick * TICK_S;
                let covered_mm = course.covered_mm(time_s);
                let ends =
                    time_s >= course.motion.duration_s() || covered_mm >= begin_mm + length_mm;
                let until_mm = if ends {
                    f64::INFINITY
                } else {
                    covered_mm - begin_mm
                };
                while passed < pair[1].passed {
                    let along_mm = (corridor.points[passed + 1] - pair[0].at).dot(unit);
                    if along_mm > until_mm {
                        break;
                    }
                    passed += 1;
                    places.pass_point();
                    places.add_sharp(passed, begin_mm + along_mm.clamp(0.0, length_mm));
                }
                if ends {
                    break;
                }
                places.pass_tick(TickPlace {
                    on_path: pair[0].at + unit * until_mm,
                    unit,
                    passed,
                    time_s,
                    covered_mm,
                });
                tick += 1.0;
            }
            begin_mm += length_mm;
        }
        places.pass_point();
        places.add(
            [path[path.len() - 1].at],
            last,
            course.motion.duration_s(),
            begin_mm,
        );
        places
    }

    /// Adds the places of a tick. A corner in the middle of a long straight line is useless.
    fn pass_tick(&mut self, tick: TickPlace) {
        self.since_point += 1;
        if self.since_point <= NEAR_A_POINT {
            self.add_tick(tick);
            return;
        }
        self.far.push_back(tick);
        if self.far.len() > NEAR_A_POINT {
            self.far.pop_front();
        }
    }

    /// Records that a point of the stroke is passed.
    fn pass_point(&mut self) {
        self.since_point = 0;
        while let Some(tick) = self.far.pop_front() {
            self.add_tick(tick);
        }
    }

    /// Adds the places of a tick: around the point of the stroke closest to the motion.
    fn add_tick(&mut self, tick: TickPlace) {
        let corridor = self.corridor;
        let next = (tick.passed + 1).min(corridor.points.len() - 1);
        let (from, to) = (corridor.points[tick.passed], corridor.points[next]);
        let way = to - from;
        let share = (tick.on_path - from).dot(way) / way.hypot2().max(f64::MIN_POSITIVE);
        let at = from + way * share.clamp(0.0, 1.0);
        let across = tick.unit.turn_90() * corridor.radii[tick.passed].min(corridor.radii[next]);
        let places = self.sides.iter().map(|side| at + across * *side);
        self.add(places, tick.passed, tick.time_s, tick.covered_mm);
    }

    /// Adds the places at a sharp turn of the stroke, at any time.
    fn add_sharp(&mut self, i: usize, covered_mm: f64) {
        let points = self.corridor.points;
        if i + 1 < points.len() && is_sharp(points[i - 1], points[i], points[i + 1]) {
            let [left, right] = self.corridor.beside(i);
            let time_s = self.course.motion.reached_s(covered_mm);
            self.add([points[i], left, right], i, time_s, covered_mm);
        }
    }

    fn add(
        &mut self,
        at: impl IntoIterator<Item = Point>,
        passed: usize,
        time_s: f64,
        covered_mm: f64,
    ) {
        let gone = |t_s: f64| self.course.covered_mm(t_s);
        let window_s = self.course.window_s;
        let (before_mm, after_mm) = (
            covered_mm - gone(time_s - window_s),
            gone(time_s + window_s) - covered_mm,
        );
        let places = at.into_iter().map(|at| CornerPlace {
            at,
            passed,
            step: self.step,
            time_s,
            covered_mm,
            before_mm,
            after_mm,
        });
        self.all.extend(places);
        self.step += 1;
    }
}

fn is_sharp(before: Point, here: Point, after: Point) -> bool {
    let (incoming, outgoing) = (here - before, after - here);
    incoming.dot(outgoing) < SHARP_COS * incoming.length() * outgoing.length()
}

/// The fastest way to reach a place.
#[derive(Clone, Copy, Debug)]
struct Label {
    time_s: f64,
    /// The place before.
    before: usize,
    /// The displacement of the tool in the window before its arrival.
    displacement: Vec2,
}

impl Label {
    const UNREACHED: Self = Self {
        time_s: f64::INFINITY,
        before: 0,
        displacement: Vec2::ZERO,
    };

    /// Returns how the next place is reached from this one.
    fn next(&self, [from, to]: [&CornerPlace; 2], here: usize, rates: &Rates) -> Self {
        let took_s = rates.took_s(from, to);
        let (way, along_mm) = (to.at - from.at, to.covered_mm - from.covered_mm);
        let speed = ((to.time_s - from.time_s) / took_s).min(1.0);
        let part = |mm: f64| {
            if mm < along_mm {
                way * (mm / along_mm * speed)
            } else {
                way * speed
            }
        };
        // The arm reports positions a window apart; the difference of two displacements is what it
        // measures as acceleration.
        let seen = (part(from.after_mm) - self.displacement).length() / rates.seen_mm;
        let beyond = (seen - SEEN_SHARE).max(0.0);
        Self {
            time_s: self.time_s + took_s + TOO_SHARP_S * beyond * beyond,
            before: here,
            displacement: part(to.before_mm),
        }
    }
}

/// The limits on the time of the next corner.
struct Rates {
    /// The link's minimum duration of a vector in whole ticks, in s.
    least_s: f64,
    /// The allowed change of displacement between windows, in mm.
    seen_mm: f64,
}

impl Rates {
    fn of(estimator: &DurationEstimator) -> Self {
        Self {
            least_s: whole_ticks_s(estimator.link.period_s),
            seen_mm: seen_mm(estimator),
        }
    }

    /// Returns the duration of a vector regardless of its predecessor, in s.
    fn took_s(&self, from: &CornerPlace, to: &CornerPlace) -> f64 {
        whole_ticks_s(to.time_s - from.time_s).max(self.least_s)
    }
}

/// Returns the allowed change of displacement between windows, in mm.
pub(super) fn seen_mm(estimator: &DurationEstimator) -> f64 {
    let (a, window_s) = (
        estimator.cornering.acceleration_mm_s2,
        estimator.cornering.window_s,
    );
    a * window_s * window_s
}

fn whole_ticks_s(duration_s: f64) -> f64 {
    let ticks = duration_s * (1.0 / TICK_S) - SPARE_TICKS;
    // Faster than `ceil`, which is a function call.
    #[expect(clippy::cast_possible_truncation, reason = "a handful")]
    let below = f64::from(ticks as i32);
    TICK_S * if below < ticks { below + 1.0 } else { below }
}

/// Computes the fastest way to reach each place. Places that are much later than the best of the
/// last steps are not expanded.
fn labels(
    corridor: &Corridor<'_>,
    places: &[CornerPlace],
    rates: &Rates,
    most_late_s: f64,
) -> Vec<Label> {
    let mut labels = vec![Label::UNREACHED; places.len()];
    labels[0].time_s = 0.0;
    // The lateness relative to the motion of the best places in the last steps.
    let mut late_s = [f64::INFINITY; STEPS_BACK];
    let mut begin = 0;
    for places_of_step in places.chunk_by(|a, b| a.step == b.step) {
        let step = begin..begin + places_of_step.len();
        begin = step.end;
        let late = |labels: &[Label], here: usize| labels[here].time_s - places[here].time_s;
        late_s[places_of_step[0].step % STEPS_BACK] = step
            .clone()
            .map(|here| late(&labels, here))
            .fold(f64::INFINITY, f64::min);
        let least_s = late_s.iter().copied().fold(f64::INFINITY, f64::min);
        for here in step {
            if labels[here].time_s.is_finite() && late(&labels, here) <= least_s + most_late_s {
                go_on(corridor, places, &mut labels, here, rates);
            }
        }
    }
    labels
}

/// Updates all places that one vector from here reaches sooner than known. A vector that finishes
/// before the link delivers the next one is useful only if no longer one exists.
fn go_on(
    corridor: &Corridor<'_>,
    places: &[CornerPlace],
    labels: &mut [Label],
    here: usize,
    rates: &Rates,
) {
    let from = places[here];
    let farther = here + 1..places.len();
    let first = farther.clone().find(|index| {
        let to = &places[*index];
        to.step > from.step && to.time_s - from.time_s >= rates.least_s - SPARE_TICKS * TICK_S
    });
    let first = first.unwrap_or(places.len());
    if !go_to(corridor, places, labels, here, first..places.len(), rates) {
        go_to(corridor, places, labels, here, here + 1..first, rates);
    }
}

/// Updates places farther along that one vector from here reaches sooner than known. Returns
/// whether it reaches any.
fn go_to(
    corridor: &Corridor<'_>,
    places: &[CornerPlace],
    labels: &mut [Label],
    here: usize,
    wanted: Range<usize>,
    rates: &Rates,
) -> bool {
    let from = places[here];
    let corner = Corner {
        at: from.at,
        passed: from.passed,
        before: 0,
    };
    let mut visibility = Visibility::from(corridor, corner, 0.0);
    let mut passed = from.passed;
    let mut reaches_any = false;
    for there in wanted {
        let to = &places[there];
        if to.step == from.step {
            continue;
        }
        if to.step > from.step + MAX_STEPS {
            break;
        }
        while passed < to.passed {
            passed += 1;
            // No direction is left, so no farther place is visible either.
            if !visibility.pass(passed) {
                return reaches_any;
            }
        }
        // A lower bound without the corner's penalty: the costly visibility test is needed only if
        // it helps.
        let soonest_s = labels[here].time_s + rates.took_s(&from, to);
        if soonest_s < labels[there].time_s || !reaches_any {
            if !visibility.reaches(to.at, to.passed) {
                continue;
            }
            reaches_any = true;
            let next = labels[here].next([&from, to], here, rates);
            if next.time_s < labels[there].time_s {
                labels[there] = next;
            }
        }
    }
    reaches_any
}

fn path(places: &[CornerPlace], labels: &[Label]) -> Vec<Corner> {
    let mut at = places.len() - 1;
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
    path
}

/// Places reached later than the best of this many steps by [`MAX_LATE_S`] are not expanded.
const STEPS_BACK: usize = 7;
const MAX_LATE_S: f64 = 2.0 * TICK_S;
/// The maximum number of steps that a vector spans.
const MAX_STEPS: usize = 24;
/// The number of ticks with places before and after a point of the stroke, so that a vector can
/// span everything between two points.
const NEAR_A_POINT: usize = MAX_STEPS / 2 - 1;
/// The offsets of places from the stroke, as shares of the tolerance: many, and few.
pub(super) const SIDES: [f64; 5] = [0.0, 0.99, -0.99, 0.5, -0.5];
pub(super) const FEW_SIDES: [f64; 3] = [0.0, 0.99, -0.99];
/// The cosine of a turn from which the point of the stroke itself is a place.
const SHARP_COS: f64 = 0.94;
/// The share of a tick by which a vector may be too long for its ticks.
const SPARE_TICKS: f64 = 0.1;
/// The share of the sampled acceleration that is allowed at a corner.
const SEEN_SHARE: f64 = 0.97;
/// The time penalty for sampling twice the allowed acceleration, in s; it grows with the square of
/// the excess.
pub(super) const TOO_SHARP_S: f64 = 50.0 * TICK_S;
