//! The vectors of a pass.

use dobot_arm::TICK_S;
use dobot_geometry::{Stroke, deviation};
use dobot_plan::{
    DrawingTool, DurationEstimator, LEAST_BURN_MM, MoveKind, Pass, Plan, acceleration,
    burned_corners,
};

use super::{PrepareError, Settings};
use crate::arm::calibrated::shortened;
use crate::strokes::simplify::{
    PlannedWay, Way, fast_ways_at, fewest_at, fewest_long_at, seemingly_fastest_at, spliced_at,
};

/// How much of a drawing may still be planned to find the fastest vectors.
#[derive(Debug)]
pub(super) struct Trials {
    /// How many vectors, where those in ticks count as [`TICKS_COUNT`].
    left: usize,
    /// How many points the strokes have, and how many those have that were asked about.
    points: usize,
    points_done: usize,
}

impl Trials {
    /// Those of one drawing.
    pub(super) fn new(passes: &[Pass]) -> Self {
        let strokes = passes.iter().flat_map(|it| &it.strokes);
        Self {
            left: MOST_TRIED,
            points: strokes.map(|it| it.points.len()).sum(),
            points_done: 0,
        }
    }

    /// Whether a stroke is to be planned in all ways, the fewest vectors of which are given: as long as anything is left, if it is
    /// not that long itself.
    fn take(&mut self, stroke: &Stroke, fewest: &Stroke, has_ticks: bool) -> bool {
        self.points_done += stroke.points.len();
        let count = (EACH + fewest.points.len()) * WAYS;
        let count = if has_ticks {
            TICKS_COUNT * count
        } else {
            count
        };
        let enough = self.left > 0 && count <= MOST_OF_ONE;
        self.left = self.left.saturating_sub(count);
        if self.are_rare() {
            self.left = 0;
        }
        enough
    }

    /// Whether hardly any strokes of the drawing could be planned in all ways: then it is not worth the time.
    fn are_rare(&self) -> bool {
        let taken = MOST_TRIED - self.left;
        taken > MOST_TRIED / FIRST_SHARE
            && RARE * MOST_TRIED * self.points_done < taken * self.points
    }
}

/// The same pass with the vectors that are the fastest; of a laser, which burns at an even speed, with the
/// fewest.
pub(super) fn simplified(
    pass: &Pass,
    settings: &Settings,
    trials: &mut Trials,
) -> Result<Pass, PrepareError> {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let strokes = pass.strokes.iter().map(|it| {
        settings.cancel.check()?;
        let fewest = fewest_at(it, tolerance_mm);
        let simple = if pass.tool.burns() {
            fewest_long_at(it, tolerance_mm, LEAST_BURN_MM)
                .unwrap_or_else(|| burned(it, fewest.stroke, tolerance_mm))
        } else if fewest.stroke.points.len() == it.points.len() {
            fewest.stroke
        } else {
            faster(it, fewest, pass.tool, settings, trials)
        };
        settings.progress.advance(it.points.len());
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

/// The fewest vectors of a stroke that keep within the tolerance without the corners that a laser leaves out, since they lie too
/// near to others: those within less than the tolerance lie elsewhere. If none do, those that come nearest to it.
fn burned(stroke: &Stroke, fewest: Stroke, tolerance_mm: f64) -> Stroke {
    let off_mm = |it: &Stroke| {
        let corners = burned_corners(it);
        if corners.len() == it.points.len() {
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

/// A stroke of a pen with the vectors that the plan takes the least time for: those of its pace, those that take whole
/// ticks, the fewest, the fewest within half of the tolerance, or the best parts of these. In a long drawing the last strokes are only estimated.
fn faster(
    stroke: &Stroke,
    fewest: Way,
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
    if ways.iter().all(|it| it.stroke == few) {
        return few;
    }
    let mut tried = Tried {
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
    best.map_or(few, |it| it.way.stroke)
}

/// The ways of a stroke that were planned.
struct Tried<'a> {
    tool: DrawingTool,
    settings: &'a Settings,
    planned: Vec<PlannedWay>,
    /// How long the fastest takes, in s, and which it is.
    best: (f64, usize),
}

impl Tried<'_> {
    /// Plans one more way, if it is none of those before.
    fn plan(&mut self, way: Way) {
        if self.planned.iter().any(|it| it.way.stroke == way.stroke) {
            return;
        }
        let pass = Pass::new(self.tool, vec![way.stroke.clone()]);
        let Ok(plan) = Plan::whole(&[pass], &self.settings.paper, &self.settings.arm_limits) else {
            return;
        };
        let draws = plan.moves.iter().filter(|it| it.kind == MoveKind::Draw);
        let durations_s: Vec<f64> = draws.map(|it| it.duration_s.into()).collect();
        let time_s = durations_s.iter().sum::<f64>() * self.sharpness(&plan);
        if time_s < self.best.0 * WORTH_FEWER {
            self.best = (time_s, self.planned.len());
        }
        self.planned.push(PlannedWay { way, durations_s });
    }

    /// As how many times slower a plan counts, since its motion comes out too sharp in the ticks of a stock arm.
    fn sharpness(&self, plan: &Plan) -> f64 {
        let cornering = self.settings.arm_limits.cornering();
        if !self.settings.arm_limits.has_ticks {
            return 1.0;
        }
        let seen_mm_s2 = acceleration(plan, cornering.window_s);
        (seen_mm_s2 / (SHARP * cornering.acceleration_mm_s2)).max(1.0)
    }
}

/// Fewer vectors, which are farther from the curve, are taken if so much faster.
const WORTH_FEWER: f64 = 0.998;
/// In so many ways at the most a stroke is planned.
const WAYS: usize = 16;
/// What it costs to go on along another way, in s: each time the parts are looked for again, those that were found before among
/// them.
const CHANGES_S: [f64; 3] = [0.5 * TICK_S, 2.0 * TICK_S, 4.0 * TICK_S];
/// So many vectors of a drawing are planned to choose among them: a second or two of a processor.
const MOST_TRIED: usize = 200_000;
/// Behind one of so many shares of these it is looked whether they are enough for one of so many parts of the drawing.
const FIRST_SHARE: usize = 8;
const RARE: usize = 10;
/// To plan a stroke takes as long as so many vectors more.
const EACH: usize = 8;
/// So many of one stroke.
const MOST_OF_ONE: usize = 400_000;
/// How many times as long as without ticks it takes to plan with them.
const TICKS_COUNT: usize = 9;
/// So many times the acceleration may be seen in ticks.
const SHARP: f64 = 1.01;

/// Shares of the tolerance to try where a laser leaves out corners.
const BURNED_WITHIN: [f64; 7] = [0.93, 0.86, 0.79, 0.72, 0.65, 0.5, 0.35];

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use dobot_geometry::{Point, Random, Vec2, deviation};

    /// So many of them for a drawing of one stroke.
    fn trials_of(left: usize) -> Trials {
        Trials {
            left,
            points: 0,
            points_done: 0,
        }
    }

    #[test]
    fn where_no_more_may_be_tried_the_way_that_seems_the_fastest_is_taken() {
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
        let ((tried_s, left), (estimated_s, none)) = (chosen(100_000), chosen(0));
        assert!(left < 100_000 && none == 0);
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
    fn strokes_are_tried_as_long_as_that_is_a_good_part_of_the_drawing() {
        let stroke = Stroke::open(vec![Point::default(); 200]);
        let fewest = Stroke::open(vec![Point::default(); 40]);
        let tried = |strokes: usize| {
            let pass = Pass::new(DrawingTool::default(), vec![stroke.clone(); strokes]);
            let mut trials = Trials::new(&[pass]);
            let takes = (0..strokes).filter(|_| trials.take(&stroke, &fewest, false));
            takes.count()
        };
        // In 16 ways of 48 each takes 768 of 200,000: that is enough for 261 of them.
        assert_eq!([10, 200, 2500].map(tried), [10, 200, 261]);
        // A tenth of 2,610 could be tried. Of more it is seen behind an eighth of 261 that it is less.
        assert_eq!(tried(3000), 33);
    }

    /// A line whose direction wanders: tight curves, in which the link limits the speed as often as the arm.
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
    fn strokes_that_are_only_estimated_are_nearly_as_fast_as_if_their_ways_were_tried() {
        let settings = Settings::default();
        let mut random = Random::new(1);
        let scrawls: Vec<Stroke> = (0..60).map(|_| scrawl(&mut random)).collect();
        let planned_s = |left: usize| -> f64 {
            let chosen = scrawls.iter().map(|it| {
                let mut trials = trials_of(left);
                let fewest = fewest_at(it, 0.045);
                let way = faster(it, fewest, settings.tool, &settings, &mut trials);
                let pass = Pass::new(settings.tool, vec![way]);
                let plan = Plan::new(&[pass], &settings.paper, &settings.arm_limits);
                plan.expect("a plan").duration_s()
            });
            chosen.sum()
        };
        let (tried_s, estimated_s) = (planned_s(100_000), planned_s(0));
        assert!(
            estimated_s < 1.03 * tried_s,
            "{estimated_s} instead of {tried_s} s"
        );
    }

    /// A line whose direction swings slowly, 120 mm long, in points 0.02 mm apart.
    fn swinging(random: &mut Random) -> Vec<Point> {
        let begins = [0, 1].map(|_| TAU * random.share());
        let directions = (0..6000).map(|i| {
            let share = f64::from(i) / 6000.0;
            let swing = (9.0 * share + begins[0]).sin() + 0.6 * (23.0 * share + begins[1]).sin();
            Vec2::from_angle(swing)
        });
        directions
            .scan(Point::new(200.0, -40.0), |at, it| {
                *at += it * 0.02;
                Some(*at)
            })
            .collect()
    }

    #[test]
    fn a_line_of_a_trembling_hand_takes_hardly_longer_than_the_line_that_it_meant() {
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
                &mut trials_of(MOST_TRIED),
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
                .map(|it| *it + Vec2::new(off(), off()));
            trembling_s += planned_s(trembling.collect());
            meant_s += planned_s(meant);
        }
        assert!(
            trembling_s < 1.01 * meant_s,
            "{trembling_s} instead of {meant_s} s"
        );
    }
}
