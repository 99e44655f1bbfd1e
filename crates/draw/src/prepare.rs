//! The whole way from a source to a plan.

mod layers;
mod settings;

use std::fmt;
use std::sync::Arc;

use dobot_arm::Position;
use thiserror::Error;

pub use self::settings::Settings;
use crate::artwork::Layer;
use crate::order::order;
use crate::place::{PlaceError, Placed, check_reach};
use crate::plan::{Pass, Plan, PlanError};
use crate::point::{Point, Stroke};
use crate::simplify::{MIN_VECTOR_MM, simplify};
use crate::source::{ReadOptions, Source, SourceError, Warning};

/// A drawing, ready to be sent.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The path wanted: the file's curves in the base frame, within a tenth of the tolerance.
    pub wanted: Vec<Stroke>,
    /// What is drawn with one tool each, in order.
    pub passes: Vec<Pass>,
    /// What the arm is to do.
    pub plan: Plan,
    /// How much larger than the file says it becomes.
    pub scale: f64,
    /// What the pen does not show.
    pub warnings: Vec<Warning>,
}

/// Reads a source, places it, puts its strokes in order, merges what the tolerance allows and
/// plans the vectors. `reachable` tells which places the arm gets to.
///
/// # Errors
///
/// [`PrepareError`] with the step that failed.
pub fn prepare<E: fmt::Display>(
    source: &Source,
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    let tolerance_mm = settings.tolerance_mm;
    if !(tolerance_mm >= LEAST_TOLERANCE_MM && tolerance_mm.is_finite()) {
        return Err(PrepareError::Tolerance { tolerance_mm });
    }
    let flatten_mm = tolerance_mm * FLATTEN_SHARE;
    let (Placed { layers, scale }, warnings) = read(source, settings, flatten_mm)?;
    let (mut wanted, mut passes) = (Vec::new(), Vec::<Pass>::new());
    let mut here = settings.placement.area.max;
    for layer in layers::chosen(layers, settings)? {
        let (tool, message) = (
            layers::tool(&layer, settings),
            layers::message(&layer, passes.last(), settings),
        );
        let name = layer.name.clone();
        let mut strokes = lines(layer, here);
        here = strokes.last().and_then(Stroke::last).unwrap_or(here);
        passes.push(Pass {
            name,
            tool,
            strokes: merged(&strokes, tolerance_mm - flatten_mm),
            message,
        });
        wanted.append(&mut strokes);
    }
    let plan = Plan::new(&passes, &settings.paper, &settings.machine)?;
    check_reach(&plan, &settings.paper, reachable)?;
    Ok(Prepared {
        wanted,
        passes,
        plan,
        scale,
        warnings,
    })
}

/// Why a drawing cannot be prepared.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// Vectors this short would not be vectors any more.
    #[error("the tolerance is {tolerance_mm} mm; it must be a number from 0.02 mm up")]
    Tolerance {
        /// What was asked for.
        tolerance_mm: f64,
    },
    /// The source cannot be drawn.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// No layer has this name.
    #[error("there is no layer {name:?}; the layers are {layers}")]
    NoSuchLayer {
        /// What was asked for.
        name: String,
        /// What there is.
        layers: String,
    },
    /// It does not fit on the paper.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// It cannot be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

/// The layers on the paper, within `flatten_mm` of the curves there.
fn read(
    source: &Source,
    settings: &Settings,
    flatten_mm: f64,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let mut options = ReadOptions {
        tolerance_mm: flatten_mm,
        layers: settings.layers.unwrap_or_default(),
        fonts: Arc::clone(&settings.fonts),
        ..ReadOptions::default()
    };
    let (artwork, warnings) = source.read(&options)?;
    let placed = settings.placement.place(artwork)?;
    if placed.scale <= 1.0 {
        return Ok((placed, warnings));
    }
    // What is enlarged must be read more finely; the size is known only now.
    options.scale = placed.scale;
    options.tolerance_mm = (flatten_mm / placed.scale).max(1e-6);
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// The lines of a layer in a good order, for a tool that comes from `here`.
fn lines(layer: Layer, here: Point) -> Vec<Stroke> {
    order(layer.strokes, here)
}

fn merged(strokes: &[Stroke], tolerance_mm: f64) -> Vec<Stroke> {
    strokes
        .iter()
        .map(|stroke| simplify(stroke, tolerance_mm))
        .collect()
}

const FLATTEN_SHARE: f64 = 0.1;
const LEAST_TOLERANCE_MM: f64 = 4.0 * MIN_VECTOR_MM;
#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::deviation::deviation;
    use crate::place::Size;
    use crate::plan::MoveKind;

    const EXAMPLES: [&str; 3] = [
        include_str!("../../../examples/drawings/harbour.svg"),
        include_str!("../../../examples/drawings/rosette.svg"),
        include_str!("../../../examples/drawings/square.svg"),
    ];

    fn anywhere(p: Position) -> Result<(), &'static str> {
        if p.is_finite() {
            Ok(())
        } else {
            Err("nowhere")
        }
    }

    fn in_reach(p: Position) -> Result<(), String> {
        let reach = p.reach().0;
        if (129.0..=321.0).contains(&reach) {
            Ok(())
        } else {
            Err(format!("reach is {reach}"))
        }
    }

    #[test]
    fn the_examples_are_planned_within_tolerance_and_reach() {
        for svg in EXAMPLES {
            let prepared = prepare(&svg.into(), &Settings::default(), in_reach).unwrap();
            let planned = prepared.plan.paths(MoveKind::Draw);
            let worst = deviation(&prepared.wanted, &planned);
            assert!(worst.largest_mm() <= 0.045 + 1e-5, "{worst:?}");
            assert_eq!(prepared.warnings, []);
        }
    }

    #[test]
    fn an_enlarged_drawing_keeps_the_tolerance() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="2mm" height="2mm" viewBox="0 0 2 2">
            <path d="M0 2C0 0 2 0 2 2" stroke="red" fill="none"/></svg>"#;
        let mut settings = Settings::default();
        settings.placement.size = Size::Fit;
        let prepared = prepare(&svg.into(), &settings, anywhere).unwrap();
        assert!((prepared.scale - 80.0).abs() < 0.1, "{}", prepared.scale);
        // The curve is 2 mm wide and 1.5 mm high, its top at t = 1/2; the area is 120 mm deep.
        let top = prepared.wanted[0]
            .points
            .iter()
            .fold(0.0, |top: f64, p| top.max(p.x));
        assert!((top - 270.0).abs() < 0.01, "{top}");
        let planned = prepared.plan.paths(MoveKind::Draw);
        assert!(deviation(&prepared.wanted, &planned).largest_mm() <= 0.0451);
        assert!(prepared.wanted[0].points.len() > 60);
    }

    #[test]
    fn a_tolerance_below_what_vectors_can_follow_is_refused() {
        let settings = Settings {
            tolerance_mm: 0.01,
            ..Settings::default()
        };
        let error = prepare(&EXAMPLES[2].into(), &settings, anywhere).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the tolerance is 0.01 mm; it must be a number from 0.02 mm up"
        );
    }

    #[test]
    fn what_is_out_of_reach_is_refused() {
        let mut settings = Settings::default();
        settings.placement.center = Some(Point::new(320.0, 0.0));
        let error = prepare(&EXAMPLES[2].into(), &settings, in_reach).unwrap_err();
        assert!(
            matches!(error, PrepareError::Place(PlaceError::OutOfReach { .. })),
            "{error}"
        );
    }
}
