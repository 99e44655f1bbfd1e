//! The fastest path in a corridor, with neither the fewest vectors nor the most.
//!
//! Where the link limits the speed, fewer vectors are faster. Where the arm does, more vectors turn
//! more gently and are closer to the curve. Therefore the corridor is narrowed where vectors take
//! longer than the link needs for the next, and widened again where they take less.
//!
//! ```text
//!   width    ______              ______   the tolerance: the link limits the tight turn
//!                  \            /
//!                   `--.____.--'          the arm limits the long one
//! ```

use dobot_plan::DurationEstimator;

use super::MIN_VECTOR_MM;
use super::corridor::{Corner, Corridor};
use super::search::fewest;
use super::smooth::{as_given, smooth};
use super::timed::{Course, FEW_SIDES, SIDES, TimedPath};

/// Returns the corners of the fastest path found in a corridor or a narrower one; `None` if every
/// path has vectors that are too short.
pub(super) fn fastest(
    mut corridor: Corridor<'_>,
    estimator: &DurationEstimator,
) -> Option<Vec<Corner>> {
    let path = fewest(&corridor)?;
    Some(Found::new(&mut corridor, path, estimator).best.path)
}

/// Returns the fastest path and, on a curve, alternatives: some with vectors in whole ticks, the
/// one with the fewest vectors, which is given, and the one with the fewest within half the
/// tolerance. Only a plan decides which is the fastest.
pub(super) fn fast_ways(
    mut corridor: Corridor<'_>,
    fewest: Vec<Corner>,
    estimator: &DurationEstimator,
) -> Vec<Vec<Corner>> {
    let most_mm = corridor.radii[0];
    let mut found = Found::new(&mut corridor, fewest, estimator);
    let mut timed = Vec::new();
    if found.is_curved {
        if let Some(fine) = fine(&mut corridor, most_mm, estimator) {
            found.smoothest = found.smoothest.or_smoother(fine);
        }
        timed = found.timed(&mut corridor, most_mm, estimator);
    }
    let mut ways = vec![found.best.path];
    ways.extend(timed);
    ways.extend(found.plain.into_iter().map(|attempt| attempt.path));
    ways
}

/// Returns the fastest path by estimate, without a plan; the one with the fewest vectors is given.
/// On a curve it has vectors in whole ticks of the fastest motion of the arm or the link, or is the
/// better of the given path and one in a corridor that is narrowed once.
pub(super) fn seemingly_fastest(
    mut corridor: Corridor<'_>,
    fewest: Vec<Corner>,
    estimator: &DurationEstimator,
) -> Vec<Corner> {
    let most_mm = corridor.radii[0];
    let few = Attempt::of(fewest, &corridor, estimator);
    // On straight lines more vectors only add packets.
    if !few.is_curved(&corridor, most_mm / NARROWEST) {
        return few.path;
    }
    let given = as_given(&corridor).map(|path| Attempt::of(path, &corridor, estimator));
    let begin = (few.clone(), few.clone());
    let best = narrowed(&mut corridor, most_mm, estimator, &ROUNDS[..1], begin);
    let sooner_s = best.arm_s().min(few.arm_s());
    let smoothest = match given.filter(|attempt| attempt.arm_s() < sooner_s) {
        // Without tremor there is no smoother path.
        Some(given) => given,
        None => match fine(&mut corridor, most_mm, estimator) {
            Some(fine) => few.or_smoother(fine),
            None => few,
        },
    };
    // The attempts above narrowed the corridor; the timed paths may use all of it.
    corridor.radii.fill(most_mm);
    let [as_the_arm, as_the_link] = gentler(estimator);
    let (sides, arm_seems, best_seems) = if estimator.has_ticks() {
        (&SIDES[..], 1.0, 1.0)
    } else {
        (&FEW_SIDES[..], ARM_SEEMS, BEST_SEEMS)
    };
    let link = Course::along(
        &best.path,
        estimator.link.period_s,
        as_the_link[0],
        estimator,
    );
    let arm = Course::along(&smoothest.path, 0.0, as_the_arm[0], estimator);
    let timed = [(link, 1.0), (arm, arm_seems)].map(|(course, seems)| {
        let TimedPath { path, time_s } = course.timed(&corridor, sides, estimator)?;
        // With ticks, the time in the graph is the better estimate, because it counts whole ticks.
        if estimator.has_ticks() {
            return Some((time_s, path));
        }
        let attempt = Attempt::of(path, &corridor, estimator);
        Some((seems * attempt.time_s, attempt.path))
    });
    let best = (best_seems * best.time_s, best.path);
    let sooner = |a: (f64, Vec<Corner>), b: (f64, Vec<Corner>)| if b.0 <= a.0 { b } else { a };
    timed.into_iter().flatten().fold(best, sooner).1
}

/// The results of the search in ever narrower corridors.
struct Found {
    best: Attempt,
    /// The path on which the arm would be fastest without a link.
    smoothest: Attempt,
    /// The fewest vectors within the tolerance and, if more could be faster, within half of it.
    plain: Vec<Attempt>,
    /// Whether more vectors could be faster than the fewest.
    is_curved: bool,
}

impl Found {
    /// Searches within the tolerance, half of it and so on, so that a larger tolerance is never
    /// slower than a smaller one. The path with the fewest vectors is given.
    fn new(
        corridor: &mut Corridor<'_>,
        fewest: Vec<Corner>,
        estimator: &DurationEstimator,
    ) -> Self {
        let mut most_mm = corridor.radii[0];
        let mut here = Attempt::of(fewest, corridor, estimator);
        let mut found = Self {
            best: here.clone(),
            smoothest: here.clone(),
            plain: Vec::new(),
            is_curved: false,
        };
        // A smaller tolerance only adds vectors, so stop once the initial path is clearly slower.
        while here.time_s <= found.best.time_s * WORTH_MORE {
            found.smoothest = found.smoothest.or_smoother(here.clone());
            let curved = here.is_curved(corridor, most_mm / NARROWEST);
            if found.plain.len() < 2 {
                found.plain.push(here.clone());
            }
            found.best = found.best.or(here.clone());
            if !curved {
                break;
            }
            found.is_curved = true;
            found.best = narrowed(corridor, most_mm, estimator, &ROUNDS, (here, found.best));
            // Start again with half of it: a larger tolerance must not give a slower path.
            most_mm *= 0.5;
            if most_mm < NARROWEST * MIN_VECTOR_MM {
                break;
            }
            corridor.radii.fill(most_mm);
            let Some(next) = Attempt::new(corridor, estimator) else {
                break;
            };
            here = next;
        }
        found
    }

    /// Returns paths with vectors in whole ticks, at the speeds of the fastest motion of the arm
    /// along the smoothest or a smoother path, or of the link, or slightly lower ones, and within
    /// half the tolerance.
    fn timed(
        &self,
        corridor: &mut Corridor<'_>,
        most_mm: f64,
        estimator: &DurationEstimator,
    ) -> Vec<Vec<Corner>> {
        let [as_the_arm, as_the_link] = gentler(estimator);
        corridor.radii.fill(most_mm);
        let smoother = self.smoother(corridor, estimator);
        let arms = as_the_arm
            .iter()
            .map(|gentler| self.as_the_arm(*gentler, estimator));
        let smoother = smoother.iter().flat_map(|path| {
            let gentler = as_the_arm.iter();
            gentler.map(|gentler| Course::along(path, 0.0, *gentler, estimator))
        });
        let links = as_the_link
            .iter()
            .map(|gentler| self.as_the_link(*gentler, estimator));
        let timed = |course: Course<'_>| course.timed(corridor, &SIDES, estimator);
        let mut ways: Vec<TimedPath> = arms
            .chain(links)
            .chain(smoother)
            .filter_map(timed)
            .collect();
        // Closer to the stroke the curve is rounder, which may be faster where the arm is the
        // limit.
        corridor.radii.fill(0.5 * most_mm);
        let nearer = self.as_the_arm(as_the_arm[0], estimator);
        ways.extend(nearer.timed(corridor, &SIDES, estimator));
        ways.into_iter().map(|timed| timed.path).collect()
    }

    /// Returns a path on which the arm would be faster than on the smoothest one, if any: along the
    /// given points, or without their tremor.
    fn smoother(
        &self,
        corridor: &Corridor<'_>,
        estimator: &DurationEstimator,
    ) -> Option<Vec<Corner>> {
        let paths = [as_given(corridor), smooth(corridor)].into_iter().flatten();
        let attempts = paths.map(|path| Attempt::of(path, corridor, estimator));
        let fastest = attempts.min_by(|a, b| a.arm_s().total_cmp(&b.arm_s()))?;
        (fastest.arm_s() * SAME < self.smoothest.arm_s()).then_some(fastest.path)
    }

    /// Returns the fastest motion of the arm alone.
    fn as_the_arm(&self, gentler: f64, estimator: &DurationEstimator) -> Course<'_> {
        Course::along(&self.smoothest.path, 0.0, gentler, estimator)
    }

    /// Returns the fastest motion of the arm with the link.
    fn as_the_link(&self, gentler: f64, estimator: &DurationEstimator) -> Course<'_> {
        Course::along(&self.best.path, estimator.link.period_s, gentler, estimator)
    }
}

/// Returns the fewest vectors in a much narrower corridor: without a link the arm may be faster on
/// them.
fn fine(
    corridor: &mut Corridor<'_>,
    most_mm: f64,
    estimator: &DurationEstimator,
) -> Option<Attempt> {
    corridor.radii.fill(most_mm / FINE);
    Attempt::new(corridor, estimator)
}

/// Returns the factors by which speeds in curves are reduced for trial, for the motion of the arm
/// and of the link.
fn gentler(estimator: &DurationEstimator) -> [&'static [f64]; 2] {
    if estimator.has_ticks() {
        [&GENTLER_IN_TICKS, &GENTLER_LINK_IN_TICKS]
    } else {
        [&GENTLER, &GENTLER_LINK]
    }
}

/// Narrows a corridor of constant width in several rounds, beginning with the path `last` found in
/// it. Returns the best path, including the given one.
fn narrowed(
    corridor: &mut Corridor<'_>,
    most_mm: f64,
    estimator: &DurationEstimator,
    rounds: &[f64],
    (mut last, mut best): (Attempt, Attempt),
) -> Attempt {
    for periods in rounds {
        if !last.narrow(corridor, most_mm, periods * estimator.link.period_s) {
            break;
        }
        let Some(next) = Attempt::new(corridor, estimator) else {
            break;
        };
        best = best.or(next.clone());
        last = next;
    }
    best
}

/// A path with its estimated duration.
#[derive(Clone, Debug)]
struct Attempt {
    path: Vec<Corner>,
    /// The arm's duration of each vector, in s.
    durations_s: Vec<f64>,
    /// The total duration with the link, in s.
    time_s: f64,
    /// The sum of the corridor's width over all points, in mm.
    width_mm: f64,
}

impl Attempt {
    /// Finds the fewest vectors in a corridor.
    fn new(corridor: &Corridor<'_>, estimator: &DurationEstimator) -> Option<Self> {
        Some(Self::of(fewest(corridor)?, corridor, estimator))
    }

    /// Evaluates a path in a corridor.
    fn of(path: Vec<Corner>, corridor: &Corridor<'_>, estimator: &DurationEstimator) -> Self {
        let increments = path.windows(2).map(|pair| {
            let way = pair[1].at - pair[0].at;
            [way.x, way.y, 0.0]
        });
        let durations_s = estimator.durations_s(increments);
        Self {
            time_s: estimator.time_s(&durations_s),
            durations_s,
            width_mm: corridor.radii.iter().sum(),
            path,
        }
    }

    /// Returns the arm's duration without a link, in s.
    fn arm_s(&self) -> f64 {
        self.durations_s.iter().sum()
    }

    /// Returns the path that takes the arm alone less time; this one if they are about equal.
    fn or_smoother(self, other: Self) -> Self {
        if other.arm_s() * SAME < self.arm_s() {
            other
        } else {
            self
        }
    }

    /// Whether a vector passes points at which another could end, with enough deviation to matter.
    fn is_curved(&self, corridor: &Corridor<'_>, off_mm: f64) -> bool {
        self.path.windows(2).any(|pair| {
            let (from, way) = (pair[0].at, pair[1].at - pair[0].at);
            let passed = &corridor.points[pair[0].passed + 1..=pair[1].passed];
            let mut across = passed.iter().map(|p| (*p - from).cross(way).abs());
            passes_points(pair) && across.any(|off| off > off_mm * way.length())
        })
    }

    /// Returns the faster path; the one in the narrower corridor if they are about equal.
    fn or(self, other: Self) -> Self {
        let [near, far] = if self.width_mm < other.width_mm {
            [self, other]
        } else {
            [other, self]
        };
        if near.time_s <= far.time_s * SAME {
            near
        } else {
            far
        }
    }

    /// Narrows the corridor where vectors take longer than wanted, and widens it up to the maximum
    /// where they take less. Returns whether anything changed.
    fn narrow(&self, corridor: &mut Corridor<'_>, most_mm: f64, wanted_s: f64) -> bool {
        let range_mm = (most_mm / NARROWEST).max(MIN_VECTOR_MM)..=most_mm;
        let mut changed = false;
        for (i, pair) in self.path.windows(2).enumerate() {
            let share = (wanted_s / self.mean_s(i)).powf(STRENGTH);
            let share = share.clamp(1.0 / STEEPEST, STEEPEST);
            if share < 1.0 && !passes_points(pair) {
                continue;
            }
            for radius in &mut corridor.radii[pair[0].passed..pair[1].passed] {
                let new_mm = (*radius * share).clamp(*range_mm.start(), *range_mm.end());
                changed |= (new_mm / *radius - 1.0).abs() > SAME - 1.0;
                *radius = new_mm;
            }
        }
        changed
    }

    /// Returns the mean duration of the vectors around this one, in s.
    fn mean_s(&self, i: usize) -> f64 {
        let end = self.durations_s.len().min(i + AROUND + 1);
        let near = &self.durations_s[i.saturating_sub(AROUND)..end];
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let count = near.len() as f64;
        near.iter().sum::<f64>() / count
    }
}

fn passes_points(pair: &[Corner]) -> bool {
    pair[1].passed > pair[0].passed + 1
}

/// The target duration of a vector in link periods, per round.
const ROUNDS: [f64; 4] = [1.4, 1.2, 1.1, 1.3];
/// The factor below which durations are equal.
const SAME: f64 = 1.005;
/// Half the tolerance is examined if its initial path is at most this many times slower.
const WORTH_MORE: f64 = 1.05;
/// The maximum factor by which a corridor is narrowed.
const NARROWEST: f64 = 16.0;
/// The factors by which speeds in curves are reduced, so that corners are less sharp, and so that
/// the loss of a tick can be compensated; the first alone is the best.
const GENTLER: [f64; 3] = [1.005, 1.02, 1.05];
const GENTLER_IN_TICKS: [f64; 4] = [1.035, 1.005, 1.02, 1.05];
/// The factors for vectors that take as long as their packets.
const GENTLER_LINK: [f64; 2] = [1.0, 1.05];
const GENTLER_LINK_IN_TICKS: [f64; 1] = [1.05];
/// The factors by which the actual duration exceeds the estimate: for vectors of the arm's motion
/// relative to the link's, and for those that do not take whole ticks.
const ARM_SEEMS: f64 = 1.02;
const BEST_SEEMS: f64 = 1.08;
/// The narrowing factor of the corridor used to estimate the arm's maximum speed.
const FINE: f64 = 8.0;
/// The exponent with which the width follows the duration: with 2, a chord would take exactly the
/// wanted time.
const STRENGTH: f64 = 1.3;
/// The maximum factor of the width per round.
const STEEPEST: f64 = 4.0;
/// The number of neighbouring vectors that determine the width.
const AROUND: usize = 2;
