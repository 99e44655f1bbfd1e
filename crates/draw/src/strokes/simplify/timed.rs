//! The path whose vectors take whole ticks of the fastest motion.
//!
//! Where the tool is at each tick of that motion there are places for corners, on the stroke and to both sides of it.
//! From each place to those that one vector reaches goes a way. It takes as many ticks as the motion from the one to
//! the other, and no fewer than the link needs for the next. What is seen of the corner at its begin may be too much;
//! that counts as time. The ways that together take the least time are the path.
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

/// The fastest motion along a path: what other paths are measured by.
#[derive(Debug)]
pub(super) struct Course<'a> {
    path: &'a [Corner],
    motion: Motion,
    /// How far along the path the tool is at each tick, in mm.
    gone_mm: Vec<f64>,
    /// Over which time the acceleration is seen, in s.
    window_s: f64,
}

impl<'a> Course<'a> {
    /// The motion along a path whose vectors take `least_s` each at the least. Speeds in curves are so many times lower than the pace
    /// allows; the largest speed is not.
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
        let mut gone_mm: Vec<f64> = times_s
            .take_while(|time_s| *time_s < motion.duration_s())
            .map(|time_s| motion.gone_mm(time_s))
            .collect();
        gone_mm.push(motion.gone_mm(motion.duration_s()));
        Self {
            motion,
            gone_mm,
            window_s: estimator.cornering.window_s,
            path,
        }
    }

    /// How far along the path the tool is after a time, in mm: between two ticks as if its speed were even.
    fn gone_mm(&self, time_s: f64) -> f64 {
        let ticks = (time_s * (1.0 / TICK_S)).max(0.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not below 0"
        )]
        let tick = ticks as usize;
        let last = self.gone_mm.len() - 1;
        if tick >= last {
            return self.gone_mm[last];
        }
        let [from, to] = [tick, tick + 1].map(|it| self.gone_mm[it]);
        from + (to - from) * ticks.fract()
    }

    /// The path in a corridor that takes the least time with speeds as here; `None` if no vectors lead to its end. Its corners
    /// are on the stroke or `sides` beside it, as shares of the tolerance.
    pub(super) fn timed(
        &self,
        corridor: &Corridor<'_>,
        sides: &[f64],
        estimator: &DurationEstimator,
    ) -> Option<TimedPath> {
        let places = Places::of(self, corridor, sides).all;
        let rates = Rates::of(estimator);
        let quickly = labels(corridor, &places, &rates, MOST_LATE_S);
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
    /// How long it takes, as far as is known without a plan, in s.
    pub(super) time_s: f64,
}

/// A place where a corner may be.
#[derive(Clone, Copy, Debug)]
struct Place {
    at: Point,
    /// The last point of the stroke that is passed here.
    passed: usize,
    /// Which step along the stroke it belongs to.
    step: usize,
    /// When the motion comes by, in s.
    time_s: f64,
    /// How far along its path the motion is then, and how far it goes in the window before and in that after, in mm.
    gone_mm: f64,
    before_mm: f64,
    after_mm: f64,
}

/// The places for corners, in their order; first the begin, last the end.
struct Places<'a> {
    course: &'a Course<'a>,
    corridor: &'a Corridor<'a>,
    sides: &'a [f64],
    step: usize,
    all: Vec<Place>,
    /// How many ticks there were since the last point of the stroke.
    since_point: usize,
    /// The last ticks that are farther from it than matters; they matter if the next point comes soon.
    far: VecDeque<TickPlace>,
}

/// Where the motion is at a tick.
#[derive(Clone, Copy, Debug)]
struct TickPlace {
    on_path: Point,
    /// The direction of the path there.
    unit: Vec2,
    passed: usize,
    time_s: f64,
    gone_mm: f64,
}

impl<'a> Places<'a> {
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
                let gone_mm = course.gone_mm(time_s);
                let ends = time_s >= course.motion.duration_s() || gone_mm >= begin_mm + length_mm;
                let until_mm = if ends {
                    f64::INFINITY
                } else {
                    gone_mm - begin_mm
                };
                while passed < pair[1].passed {
                    let along_mm = (corridor.points[passed + 1] - pair[0].at).dot(unit);
                    if along_mm > until_mm {
                        break;
                    }
                    passed += 1;
                    places.come_to_point();
                    places.add_sharp(passed, begin_mm + along_mm.clamp(0.0, length_mm));
                }
                if ends {
                    break;
                }
                places.come_by(TickPlace {
                    on_path: pair[0].at + unit * until_mm,
                    unit,
                    passed,
                    time_s,
                    gone_mm,
                });
                tick += 1.0;
            }
            begin_mm += length_mm;
        }
        places.come_to_point();
        places.add(
            [path[path.len() - 1].at],
            last,
            course.motion.duration_s(),
            begin_mm,
        );
        places
    }

    /// Adds the places of a tick. In the middle of a long straight line no corner is of use.
    fn come_by(&mut self, it: TickPlace) {
        self.since_point += 1;
        if self.since_point <= NEAR_A_POINT {
            self.add_tick(it);
            return;
        }
        self.far.push_back(it);
        if self.far.len() > NEAR_A_POINT {
            self.far.pop_front();
        }
    }

    /// Takes that a point of the stroke is passed.
    fn come_to_point(&mut self) {
        self.since_point = 0;
        while let Some(it) = self.far.pop_front() {
            self.add_tick(it);
        }
    }

    /// Adds the places of a tick: beside the one on the stroke that is nearest to where the motion is.
    fn add_tick(&mut self, it: TickPlace) {
        let corridor = self.corridor;
        let next = (it.passed + 1).min(corridor.points.len() - 1);
        let [from, to] = [it.passed, next].map(|i| corridor.points[i]);
        let way = to - from;
        let share = (it.on_path - from).dot(way) / way.hypot2().max(f64::MIN_POSITIVE);
        let at = from + way * share.clamp(0.0, 1.0);
        let across = it.unit.turn_90() * corridor.radii[it.passed].min(corridor.radii[next]);
        let places = self.sides.iter().map(|side| at + across * *side);
        self.add(places, it.passed, it.time_s, it.gone_mm);
    }

    /// Adds the places at a point where the stroke turns sharply, whenever the motion comes by.
    fn add_sharp(&mut self, i: usize, gone_mm: f64) {
        let points = self.corridor.points;
        if i + 1 < points.len() && is_sharp(points[i - 1], points[i], points[i + 1]) {
            let [left, right] = self.corridor.beside(i);
            let time_s = self.course.motion.reached_s(gone_mm);
            self.add([points[i], left, right], i, time_s, gone_mm);
        }
    }

    fn add(
        &mut self,
        at: impl IntoIterator<Item = Point>,
        passed: usize,
        time_s: f64,
        gone_mm: f64,
    ) {
        let gone = |t_s: f64| self.course.gone_mm(t_s);
        let window_s = self.course.window_s;
        let (before_mm, after_mm) = (
            gone_mm - gone(time_s - window_s),
            gone(time_s + window_s) - gone_mm,
        );
        let places = at.into_iter().map(|at| Place {
            at,
            passed,
            step: self.step,
            time_s,
            gone_mm,
            before_mm,
            after_mm,
        });
        self.all.extend(places);
        self.step += 1;
    }
}

fn is_sharp(before: Point, here: Point, after: Point) -> bool {
    let (came, goes) = (here - before, after - here);
    came.dot(goes) < SHARP_COS * came.length() * goes.length()
}

/// How a place is reached in the least time.
#[derive(Clone, Copy, Debug)]
struct Label {
    time_s: f64,
    /// The place before.
    before: usize,
    /// How the tool moves within the window before it is here.
    came: Vec2,
}

impl Label {
    const UNREACHED: Self = Self {
        time_s: f64::INFINITY,
        before: 0,
        came: Vec2::ZERO,
    };

    /// How the next place is reached from this one.
    fn next(&self, [from, to]: [&Place; 2], here: usize, rates: &Rates) -> Self {
        let took_s = rates.took_s(from, to);
        let (way, along_mm) = (to.at - from.at, to.gone_mm - from.gone_mm);
        let speed = ((to.time_s - from.time_s) / took_s).min(1.0);
        let part = |mm: f64| {
            if mm < along_mm {
                way * (mm / along_mm * speed)
            } else {
                way * speed
            }
        };
        let seen = (part(from.after_mm) - self.came).length() / rates.seen_mm;
        let beyond = (seen - SEEN_SHARE).max(0.0);
        Self {
            time_s: self.time_s + took_s + TOO_SHARP_S * beyond * beyond,
            before: here,
            came: part(to.before_mm),
        }
    }
}

/// What limits how soon the next corner may come.
struct Rates {
    /// How many ticks the link needs for a vector, in s.
    least_s: f64,
    /// How much of a turn may be seen within the window, in mm.
    seen_mm: f64,
}

impl Rates {
    fn of(estimator: &DurationEstimator) -> Self {
        Self {
            least_s: whole_ticks_s(estimator.link.period_s),
            seen_mm: seen_mm(estimator),
        }
    }

    /// How long a vector takes, wherever it comes from, in s.
    fn took_s(&self, from: &Place, to: &Place) -> f64 {
        whole_ticks_s(to.time_s - from.time_s).max(self.least_s)
    }
}

/// How much of a turn may be seen within the window, in mm.
pub(super) fn seen_mm(estimator: &DurationEstimator) -> f64 {
    let (a, window_s) = (
        estimator.cornering.acceleration_mm_s2,
        estimator.cornering.window_s,
    );
    a * window_s * window_s
}

fn whole_ticks_s(duration_s: f64) -> f64 {
    let ticks = duration_s * (1.0 / TICK_S) - SPARE_TICKS;
    // Faster than `ceil`, which is a call.
    #[expect(clippy::cast_possible_truncation, reason = "a handful")]
    let below = f64::from(ticks as i32);
    TICK_S * if below < ticks { below + 1.0 } else { below }
}

/// How each place is reached in the least time. From places that are so much later than the best of the last steps no vector leads
/// on.
fn labels(
    corridor: &Corridor<'_>,
    places: &[Place],
    rates: &Rates,
    most_late_s: f64,
) -> Vec<Label> {
    let mut labels = vec![Label::UNREACHED; places.len()];
    labels[0].time_s = 0.0;
    // How much later than the motion the best places of the last steps are reached.
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

/// Notes all places that one vector from here reaches sooner than was known. A vector that is over before the link brings the
/// next one is of use where no longer one leads on.
fn go_on(
    corridor: &Corridor<'_>,
    places: &[Place],
    labels: &mut [Label],
    here: usize,
    rates: &Rates,
) {
    let from = places[here];
    let farther = here + 1..places.len();
    let first = farther.clone().find(|it| {
        let to = &places[*it];
        to.step > from.step && to.time_s - from.time_s >= rates.least_s - SPARE_TICKS * TICK_S
    });
    let first = first.unwrap_or(places.len());
    if !go_to(corridor, places, labels, here, first..places.len(), rates) {
        go_to(corridor, places, labels, here, here + 1..first, rates);
    }
}

/// Notes those of some places, which lie farther along, that one vector from here reaches sooner than was known. Whether it
/// reaches any.
fn go_to(
    corridor: &Corridor<'_>,
    places: &[Place],
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
        if to.step > from.step + MOST_STEPS {
            break;
        }
        while passed < to.passed {
            passed += 1;
            if !visibility.pass(passed) {
                return reaches_any;
            }
        }
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

fn path(places: &[Place], labels: &[Label]) -> Vec<Corner> {
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

/// From places that are reached later than the best of so many steps, by so much, no vector leads on.
const STEPS_BACK: usize = 7;
const MOST_LATE_S: f64 = 2.0 * TICK_S;
/// A vector goes over at most so many steps.
const MOST_STEPS: usize = 24;
/// So many ticks before a point of the stroke and behind it there are places: a vector may go over all between two points.
const NEAR_A_POINT: usize = MOST_STEPS / 2 - 1;
/// How far beside the stroke places lie, as shares of the tolerance: many, and few.
pub(super) const SIDES: [f64; 5] = [0.0, 0.99, -0.99, 0.5, -0.5];
pub(super) const FEW_SIDES: [f64; 3] = [0.0, 0.99, -0.99];
/// The cosine of a turn of a stroke from which on the point itself is a place.
const SHARP_COS: f64 = 0.94;
/// By so much of a tick a vector may be too long for its ticks.
const SPARE_TICKS: f64 = 0.1;
/// The share of the acceleration that may be seen at a corner.
const SEEN_SHARE: f64 = 0.97;
/// How much time it counts for to be seen to accelerate twice as much, in s; in the square of what is too much.
pub(super) const TOO_SHARP_S: f64 = 50.0 * TICK_S;
