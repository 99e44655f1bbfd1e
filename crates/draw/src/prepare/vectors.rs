//! The vectors of a pass.

use dobot_arm::TICK_S;
use dobot_geometry::{Stroke, deviation};
use dobot_plan::{
    DrawingTool, DurationEstimator, MIN_BURN_MM, MoveKind, Pass, Plan, acceleration, burned_corners,
};

use super::{PrepareError, Settings};
use crate::arm::calibrated::shortened;
use crate::strokes::simplify::{
    Approximation, PlannedApproximation, fast_ways_at, fewest_at, fewest_long_at,
    seemingly_fastest_at, spliced_at,
};

/// The remaining budget for planning variants to find the fastest vectors.
#[derive(Debug)]
pub(super) struct Trials {
    /// The number of vectors; those in ticks count as [`TICKS_COUNT`].
    left: usize,
    /// The total number of points, and the number of those already considered.
    points: usize,
    points_done: usize,
}

impl Trials {
    /// Creates the budget of a drawing.
    pub(super) fn new(passes: &[Pass]) -> Self {
        let strokes = passes.iter().flat_map(|pass| &pass.strokes);
        Self {
            left: MAX_TRIED,
            points: strokes.map(|stroke| stroke.points.len()).sum(),
            points_done: 0,
        }
    }

    /// Takes the budget for planning all variants of a stroke, given its fewest vectors; returns
    /// whether there is enough and the stroke is not too long.
    fn take(&mut self, stroke: &Stroke, fewest: &Stroke, has_ticks: bool) -> bool {
        self.points_done += stroke.points.len();
        let count = (EACH + fewest.points.len()) * WAYS;
        let count = if has_ticks {
            TICKS_COUNT * count
        } else {
            count
        };
        let enough = self.left > 0 && count <= MAX_OF_STROKE;
        self.left = self.left.saturating_sub(count);
        if self.are_rare() {
            self.left = 0;
        }
        enough
    }

    /// Whether only a small part of the drawing could be planned with all variants: then it is not
    /// worth the time.
    fn are_rare(&self) -> bool {
        let taken = MAX_TRIED - self.left;
        taken > MAX_TRIED / FIRST_SHARE && RARE * MAX_TRIED * self.points_done < taken * self.points
    }
}

/// Returns the pass with its fastest vectors, or with the fewest for a laser, which burns at
/// constant speed.
pub(super) fn simplified(
    pass: &Pass,
    settings: &Settings,
    trials: &mut Trials,
) -> Result<Pass, PrepareError> {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let strokes = pass.strokes.iter().map(|stroke| {
        settings.cancel.check()?;
        let fewest = fewest_at(stroke, tolerance_mm);
        let simple = if pass.tool.burns() {
            fewest_long_at(stroke, tolerance_mm, MIN_BURN_MM)
                .unwrap_or_else(|| burned(stroke, fewest.stroke, tolerance_mm))
        } else if fewest.stroke.points.len() == stroke.points.len() {
            fewest.stroke
        } else {
            faster(stroke, fewest, pass.tool, settings, trials)
        };
        settings.progress.advance(stroke.points.len());
        Ok(shortened(simple, &settings.paper))
    });
    let strokes: Result<_, PrepareError> = strokes.collect();
    Ok(Pass {
        name: pass.name.clone(),
        color: pass.color,
        tool: pass.tool,
        strokes: strokes?,
        message: pass.message.clone(),
    })
}

/// Returns the fewest vectors of a stroke that keep the tolerance without the corners that a laser
/// omits because they are too close to others. A smaller tolerance moves the corners. If none keeps
/// it, returns the closest.
fn burned(stroke: &Stroke, fewest: Stroke, tolerance_mm: f64) -> Stroke {
    let off_mm = |vectors: &Stroke| {
        let corners = burned_corners(vectors);
        if corners.len() == vectors.points.len() {
            return 0.0;
        }
        let both = [stroke.clone(), Stroke::open(corners)];
        deviation(&both[..1], &both[1..]).largest_mm()
    };
    let mut best = (off_mm(&fewest), fewest);
    for share in BURNED_WITHIN {
        if best.0 <= tolerance_mm {
            break;
        }
        let other = fewest_at(stroke, share * tolerance_mm).stroke;
        let off_mm = off_mm(&other);
        if off_mm < best.0 {
            best = (off_mm, other);
        }
    }
    best.1
}

/// Returns the vectors of a pen stroke with the shortest planned time: the fastest by estimate,
/// those in whole ticks, the fewest, the fewest within half the tolerance, or a combination of
/// their best parts. In a long drawing the last strokes are only estimated.
fn faster(
    stroke: &Stroke,
    fewest: Approximation,
    tool: DrawingTool,
    settings: &Settings,
    trials: &mut Trials,
) -> Stroke {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let estimator = DurationEstimator::of(&settings.arm_limits, &tool);
    if !trials.take(stroke, &fewest.stroke, settings.arm_limits.has_ticks) {
        return seemingly_fastest_at(stroke, tolerance_mm, fewest, &estimator).stroke;
    }
    let few = fewest.stroke.clone();
    let ways = fast_ways_at(stroke, tolerance_mm, fewest, &estimator);
    if ways.iter().all(|way| way.stroke == few) {
        return few;
    }
    let mut tried = PlannedVariants {
        tool,
        settings,
        planned: Vec::new(),
        best: (f64::INFINITY, 0),
    };
    for way in ways {
        tried.plan(way);
    }
    for change_s in CHANGES_S {
        if let Some(way) = spliced_at(stroke, tolerance_mm, &estimator, &tried.planned, change_s) {
            tried.plan(way);
        }
    }
    let best = tried.planned.into_iter().nth(tried.best.1);
    best.map_or(few, |planned| planned.way.stroke)
}

/// The planned variants of a stroke.
struct PlannedVariants<'a> {
    tool: DrawingTool,
    settings: &'a Settings,
    planned: Vec<PlannedApproximation>,
    /// The duration of the fastest variant, in s, and its index.
    best: (f64, usize),
}

impl PlannedVariants<'_> {
    /// Plans another variant, unless it is already included.
    fn plan(&mut self, way: Approximation) {
        if self
            .planned
            .iter()
            .any(|planned| planned.way.stroke == way.stroke)
        {
            return;
        }
        let pass = Pass::new(self.tool, vec![way.stroke.clone()]);
        let Ok(plan) = Plan::whole(&[pass], &self.settings.paper, &self.settings.arm_limits) else {
            return;
        };
        let draws = plan
            .moves
            .iter()
            .filter(|vector| vector.kind == MoveKind::Draw);
        let durations_s: Vec<f64> = draws.map(|vector| vector.duration_s.into()).collect();
        let time_s = durations_s.iter().sum::<f64>() * self.sharpness(&plan);
        if time_s < self.best.0 * WORTH_FEWER {
            self.best = (time_s, self.planned.len());
        }
        self.planned.push(PlannedApproximation { way, durations_s });
    }

    /// Returns the penalty factor of a plan whose motion is too sharp in the ticks of a stock arm.
    fn sharpness(&self, plan: &Plan) -> f64 {
        let cornering = self.settings.arm_limits.cornering();
        if !self.settings.arm_limits.has_ticks {
            return 1.0;
        }
        let seen_mm_s2 = acceleration(plan, cornering.window_s);
        (seen_mm_s2 / (SHARP * cornering.acceleration_mm_s2)).max(1.0)
    }
}

/// Fewer vectors, which deviate more from the curve, are preferred only if they are faster by this
/// factor.
const WORTH_FEWER: f64 = 0.998;
/// The maximum number of variants per stroke.
const WAYS: usize = 16;
/// The cost of switching to another variant, in s: for each cost the best parts are combined again,
/// including earlier results.
const CHANGES_S: [f64; 3] = [0.5 * TICK_S, 2.0 * TICK_S, 4.0 * TICK_S];
/// The number of vectors planned to choose among variants: a twentieth of a second. Ten times as many make a text
/// 0.4 % faster to draw.
const MAX_TRIED: usize = 20_000;
/// After one of this many shares of the budget, check whether it suffices for one of this many
/// parts of the drawing.
const FIRST_SHARE: usize = 8;
const RARE: usize = 10;
/// The fixed cost of planning a stroke, in vectors.
const EACH: usize = 8;
/// The maximum for one stroke.
const MAX_OF_STROKE: usize = 400_000;
/// The time factor of planning with ticks.
const TICKS_COUNT: usize = 9;
/// The factor by which the sampled acceleration may exceed the limit in ticks.
const SHARP: f64 = 1.01;

/// Shares of the tolerance to try when a laser omits corners.
const BURNED_WITHIN: [f64; 7] = [0.93, 0.86, 0.79, 0.72, 0.65, 0.5, 0.35];

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use dobot_geometry::{Point, Random, Vec2, deviation};

    /// Returns the budget of a drawing with one stroke.
    fn trials_of(left: usize) -> Trials {
        Trials {
            left,
            points: 0,
            points_done: 0,
        }
    }

    #[test]
    fn when_no_more_trials_are_allowed_the_estimated_fastest_path_is_used() {
        let at = |i: u32| Point::new(220.0, 0.0) + Vec2::from_angle(f64::from(i) / 500.0) * 30.0;
        let arc = Stroke::open((0..2000).map(at).collect());
        let mut settings = Settings::default();
        settings.arm_limits.has_ticks = true;
        let fewest = fewest_at(&arc, 0.045);
        let planned_s = |way: Stroke| {
            let pass = Pass::new(settings.tool, vec![way]);
            let plan = Plan::new(&[pass], &settings.paper, &settings.arm_limits);
            plan.expect("a plan").duration_s()
        };
        let chosen = |left: usize| {
            let mut trials = trials_of(left);
            let way = faster(&arc, fewest.clone(), settings.tool, &settings, &mut trials);
            let off = deviation(std::slice::from_ref(&arc), std::slice::from_ref(&way));
            assert!(off.largest_mm() <= 0.0451, "{off:?}");
            (planned_s(way), trials.left)
        };
        let ((tried_s, left), (estimated_s, none)) = (chosen(MAX_TRIED), chosen(0));
        assert!(left < MAX_TRIED && none == 0);
        let few_s = planned_s(fewest.stroke.clone());
        assert!(
            tried_s <= few_s && tried_s <= estimated_s,
            "{tried_s}, {few_s}, {estimated_s} s"
        );
        assert!(
            estimated_s < 1.1 * tried_s,
            "{estimated_s} instead of {tried_s} s"
        );
    }

    #[test]
    fn strokes_are_tried_as_long_as_they_are_a_large_part_of_the_drawing() {
        let stroke = Stroke::open(vec![Point::default(); 200]);
        let fewest = Stroke::open(vec![Point::default(); 40]);
        let tried = |strokes: usize| {
            let pass = Pass::new(DrawingTool::default(), vec![stroke.clone(); strokes]);
            let mut trials = Trials::new(&[pass]);
            let takes = (0..strokes).filter(|_| trials.take(&stroke, &fewest, false));
            takes.count()
        };
        // 16 variants of 48 vectors take 768 of 20,000: enough for 27 strokes.
        assert_eq!([10, 27, 250].map(tried), [10, 27, 27]);
        // A tenth of 260 could be tried. For more, an eighth of 20,000 shows that the share is lower.
        assert_eq!(tried(300), 4);
    }

    /// A line with a wandering direction: tight curves, in which the link limits the speed as often
    /// as the arm.
    fn scrawl(random: &mut Random) -> Stroke {
        let (mut at, mut curve, mut angle) = (Point::new(220.0, 0.0), 0.0, TAU * random.share());
        let mut points = vec![at];
        for _ in 0..200 {
            curve = 0.97 * (curve + 0.7 * random.share() - 0.35);
            angle += 0.5 * curve;
            at += Vec2::from_angle(angle) * 0.15;
            points.push(at);
        }
        Stroke::open(points)
    }

    #[test]
    fn estimated_strokes_are_almost_as_fast_as_tried_ones() {
        let settings = Settings::default();
        let mut random = Random::new(1);
        let scrawls: Vec<Stroke> = (0..60).map(|_| scrawl(&mut random)).collect();
        let planned_s = |left: usize| -> f64 {
            let chosen = scrawls.iter().map(|scrawl| {
                let mut trials = trials_of(left);
                let fewest = fewest_at(scrawl, 0.045);
                let way = faster(scrawl, fewest, settings.tool, &settings, &mut trials);
                let pass = Pass::new(settings.tool, vec![way]);
                let plan = Plan::new(&[pass], &settings.paper, &settings.arm_limits);
                plan.expect("a plan").duration_s()
            });
            chosen.sum()
        };
        let (tried_s, estimated_s) = (planned_s(MAX_TRIED), planned_s(0));
        assert!(
            estimated_s < 1.03 * tried_s,
            "{estimated_s} instead of {tried_s} s"
        );
    }

    /// A line with a slowly swinging direction, 120 mm long, in points 0.02 mm apart.
    fn swinging(random: &mut Random) -> Vec<Point> {
        let begins = [0, 1].map(|_| TAU * random.share());
        let directions = (0..6000).map(|i| {
            let share = f64::from(i) / 6000.0;
            let swing = (9.0 * share + begins[0]).sin() + 0.6 * (23.0 * share + begins[1]).sin();
            Vec2::from_angle(swing)
        });
        directions
            .scan(Point::new(200.0, -40.0), |at, direction| {
                *at += direction * 0.02;
                Some(*at)
            })
            .collect()
    }

    #[test]
    fn a_line_of_a_trembling_hand_takes_hardly_longer_than_the_intended_line() {
        let mut settings = Settings::default();
        settings.arm_limits.has_ticks = true;
        let mut random = Random::new(2);
        let planned_s = |points: Vec<Point>| {
            let line = Stroke::open(points);
            let fewest = fewest_at(&line, 0.045);
            let way = faster(
                &line,
                fewest,
                settings.tool,
                &settings,
                &mut trials_of(MAX_TRIED),
            );
            let off = deviation(std::slice::from_ref(&line), std::slice::from_ref(&way));
            assert!(off.largest_mm() <= 0.0451, "{off:?}");
            let pass = Pass::new(settings.tool, vec![way]);
            let plan = Plan::new(&[pass], &settings.paper, &settings.arm_limits);
            plan.expect("a plan").duration_s()
        };
        let (mut meant_s, mut trembling_s) = (0.0, 0.0);
        for _ in 0..4 {
            let meant = swinging(&mut random);
            let mut off = || 0.02 * (2.0 * random.share() - 1.0);
            let trembling = meant
                .iter()
                .step_by(15)
                .map(|p| *p + Vec2::new(off(), off()));
            trembling_s += planned_s(trembling.collect());
            meant_s += planned_s(meant);
        }
        assert!(
            trembling_s < 1.01 * meant_s,
            "{trembling_s} instead of {meant_s} s"
        );
    }
}
