//! The vectors of a pass.

use dobot_geometry::Stroke;
use dobot_plan::{DrawingTool, Pace, Pass, Plan, acceleration};

use super::{PrepareError, Settings};
use crate::calibrated::shortened;
use crate::simplify::{fast_ways_at, simplify};

/// How much of a drawing may still be planned to find the fastest vectors.
#[derive(Debug)]
pub(super) struct Trials {
    /// How many vectors, where those in ticks count as [`TICKS_COUNT`].
    left: usize,
}

impl Trials {
    /// Those of one drawing.
    pub(super) const fn new() -> Self {
        Self { left: MOST_TRIED }
    }

    /// Whether there is enough left to plan a stroke in all ways, the fewest vectors of which are given.
    fn take(&mut self, fewest: &Stroke, has_ticks: bool) -> bool {
        let count = fewest.points.len() * WAYS * if has_ticks { TICKS_COUNT } else { 1 };
        let enough = count <= self.left;
        self.left = self.left.saturating_sub(count);
        enough
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
        settings.give_up.check()?;
        let fewest = simplify(it, tolerance_mm);
        let simple = if pass.tool.burns() || fewest.points.len() == it.points.len() {
            fewest
        } else {
            faster(it, fewest, pass.tool, settings, trials)
        };
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

/// A stroke of a pen with the vectors that the plan takes the least time for: those of its pace, those that take whole
/// ticks, the fewest, or the fewest within half of the tolerance. In a long drawing the last strokes are only estimated.
fn faster(
    stroke: &Stroke,
    fewest: Stroke,
    tool: DrawingTool,
    settings: &Settings,
    trials: &mut Trials,
) -> Stroke {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let pace = Pace::of(&settings.machine, &tool);
    let tries = trials.take(&fewest, settings.machine.has_ticks);
    let ways = fast_ways_at(stroke, tolerance_mm, &pace, if tries { WAYS } else { 1 });
    if !tries {
        let soonest = ways
            .into_iter()
            .min_by(|a, b| a.about_s.total_cmp(&b.about_s));
        return soonest.map_or(fewest, |it| it.stroke);
    }
    let mut ways: Vec<Stroke> = ways.into_iter().map(|it| it.stroke).collect();
    ways.push(simplify(stroke, 0.5 * tolerance_mm));
    if ways[0] != fewest {
        ways.push(fewest.clone());
    }
    ways.dedup();
    if ways.len() == 1 {
        return fewest;
    }
    let mut best = (f64::INFINITY, fewest);
    for way in ways {
        let time_s = planned_s(&way, tool, settings);
        if time_s < best.0 * WORTH_FEWER {
            best = (time_s, way);
        }
    }
    best.1
}

/// How long the plan for a stroke takes, in s; infinite where there is none. What comes out too sharp in the ticks of a stock
/// arm counts as that much slower.
fn planned_s(stroke: &Stroke, tool: DrawingTool, settings: &Settings) -> f64 {
    let pass = Pass::new(tool, vec![stroke.clone()]);
    let plan = Plan::new(&[pass], &settings.paper, &settings.machine);
    let cornering = settings.machine.cornering();
    plan.map_or(f64::INFINITY, |plan| {
        let sharp = if settings.machine.has_ticks {
            acceleration(&plan, cornering.window_s) / (SHARP * cornering.acceleration_mm_s2)
        } else {
            1.0
        };
        plan.duration_s() * sharp.max(1.0)
    })
}

/// Fewer vectors, which are farther from the curve, are taken if so much faster.
const WORTH_FEWER: f64 = 0.998;
/// In so many ways at the most a stroke is planned.
const WAYS: usize = 8;
/// So many vectors of a drawing are planned to choose among them: a second or two of a processor.
const MOST_TRIED: usize = 150_000;
/// How many times as long as without ticks it takes to plan with them.
const TICKS_COUNT: usize = 4;
/// So many times the acceleration may be seen in ticks.
const SHARP: f64 = 1.02;

#[cfg(test)]
mod tests {
    use super::*;
    use dobot_geometry::{Point, Vec2, deviation};

    #[test]
    fn where_no_more_may_be_tried_the_way_that_seems_the_fastest_is_taken() {
        let at = |i: u32| Point::new(220.0, 0.0) + Vec2::from_angle(f64::from(i) / 500.0) * 30.0;
        let arc = Stroke::open((0..2000).map(at).collect());
        let mut settings = Settings::default();
        settings.machine.has_ticks = true;
        let fewest = simplify(&arc, 0.045);
        let chosen = |left: usize| {
            let mut trials = Trials { left };
            let way = faster(&arc, fewest.clone(), settings.tool, &settings, &mut trials);
            let off = deviation(std::slice::from_ref(&arc), std::slice::from_ref(&way));
            assert!(off.largest_mm() <= 0.0451, "{off:?}");
            (planned_s(&way, settings.tool, &settings), trials.left)
        };
        let ((tried_s, left), (estimated_s, none)) = (chosen(100_000), chosen(0));
        assert!(left < 100_000 && none == 0);
        let few_s = planned_s(&fewest, settings.tool, &settings);
        assert!(
            tried_s <= few_s && tried_s <= estimated_s,
            "{tried_s}, {few_s}, {estimated_s} s"
        );
        assert!(
            estimated_s < 1.1 * tried_s,
            "{estimated_s} instead of {tried_s} s"
        );
    }
}
