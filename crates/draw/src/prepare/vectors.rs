//! The vectors of a pass.

use dobot_geometry::Stroke;
use dobot_plan::{DrawingTool, Machine, Pace, Pass, Plan};

use super::{PrepareError, Settings};
use crate::calibrated::shortened;
use crate::simplify::{fast_ways_at, simplify, simplify_at};

/// The same pass with the vectors that are the fastest; of a laser, which burns at an even speed, with the
/// fewest.
pub(super) fn simplified(pass: &Pass, settings: &Settings) -> Result<Pass, PrepareError> {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let strokes = pass.strokes.iter().map(|it| {
        settings.give_up.check()?;
        let fewest = simplify(it, tolerance_mm);
        let simple = if pass.tool.burns() || fewest.points.len() == it.points.len() {
            fewest
        } else {
            faster(it, fewest, pass.tool, settings)
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

/// A stroke of a pen with the vectors that the plan takes the least time for: those of its pace, the fewest, the fewest
/// within half of the tolerance, or on an arm without ticks those chosen one by one.
fn faster(stroke: &Stroke, fewest: Stroke, tool: DrawingTool, settings: &Settings) -> Stroke {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let pace = Pace::of(&settings.machine, &tool);
    let mut ways = if settings.machine.has_ticks {
        vec![simplify_at(stroke, tolerance_mm, &pace)]
    } else {
        fast_ways_at(stroke, tolerance_mm, &pace)
    };
    ways.push(simplify(stroke, 0.5 * tolerance_mm));
    ways.push(fewest.clone());
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

/// How long the plan for a stroke takes, in s; infinite where there is none. The ticks of a stock arm make all ways longer,
/// and planning in them takes many times as long: they are left out.
fn planned_s(stroke: &Stroke, tool: DrawingTool, settings: &Settings) -> f64 {
    let pass = Pass::new(tool, vec![stroke.clone()]);
    let even = Machine {
        has_ticks: false,
        ..settings.machine
    };
    let plan = Plan::new(&[pass], &settings.paper, &even);
    plan.map_or(f64::INFINITY, |it| it.duration_s())
}

/// Fewer vectors, which are farther from the curve, are taken if so much faster.
const WORTH_FEWER: f64 = 0.995;
