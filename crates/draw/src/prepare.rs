//! The whole way from a source to a plan.

mod layers;
mod settings;

use std::fmt;
use std::sync::Arc;

use dobot_arm::Position;
use thiserror::Error;

pub use self::settings::Settings;
pub(crate) use self::settings::TRIES;
use crate::calibrated::{shortened, told_passes, told_strokes};
use crate::clip::{Clipped, clip_to_reach};
use crate::hatch::{HatchError, hatch};
use crate::merge::merge;
use crate::order::order;
use crate::place::{PlaceError, Placed, check_reach};
use crate::simplify::simplify;
use crate::start::StartError;
use dobot_geometry::{Point, Rect, Stroke};
use dobot_plan::{DrawingTool, Pass, Plan, PlanError};
use dobot_source::{Artwork, Layer};
use dobot_source::{ReadOptions, Source, SourceError, Warning};

/// A drawing, ready to be sent.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The path wanted, in the order in which it is drawn: the curves in the base frame, within a
    /// tenth of the tolerance; of a calibrated arm in its own places, as the plan.
    pub passes: Vec<Pass>,
    /// What the arm is to do.
    pub plan: Plan,
    /// How much larger than the source says it becomes.
    pub scale: f64,
    /// What the pen does not show.
    pub warnings: Vec<Warning>,
}

impl Prepared {
    /// The path wanted, of all passes.
    #[must_use]
    pub fn wanted(&self) -> Vec<Stroke> {
        let strokes = self.passes.iter().flat_map(|it| &it.strokes);
        strokes.cloned().collect()
    }
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
    settings.check()?;
    let (Placed { layers, scale }, mut warnings) = read(source, settings)?;
    settings.give_up.check()?;
    let layers = layers::chosen(layers, settings)?;
    let passes = passes(layers, settings, &reachable, &mut warnings)?;
    let prepared = plan_passes(passes, settings, reachable)?;
    Ok(Prepared {
        scale,
        warnings,
        ..prepared
    })
}

/// Merges what the tolerance allows and plans the vectors of passes that are laid out already.
///
/// # Errors
///
/// [`PrepareError`] with the step that failed.
pub fn prepare_passes<E: fmt::Display>(
    passes: Vec<Pass>,
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    settings.check()?;
    plan_passes(told_passes(passes, settings)?, settings, reachable)
}

/// The same for passes in the arm's own places.
fn plan_passes<E: fmt::Display>(
    passes: Vec<Pass>,
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    let passes = match &settings.from {
        Some(from) => from.rest_of(passes)?,
        None => passes,
    };
    let simple: Result<Vec<Pass>, PrepareError> =
        passes.iter().map(|it| simplified(it, settings)).collect();
    let simple = simple?;
    let plan = Plan::new(&simple, &settings.paper, &settings.machine)?;
    check_reach(&plan, &settings.paper, reachable)?;
    Ok(Prepared {
        passes,
        plan,
        scale: 1.0,
        warnings: Vec::new(),
    })
}

/// Why a drawing cannot be prepared.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// Nobody wants it any more.
    #[error("the plan was given up before it was done")]
    GivenUp,
    /// Vectors this short would not be vectors any more.
    #[error("the tolerance is {0} mm; it must be a number from 0.02 mm up")]
    Tolerance(f64),
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
    /// Its areas cannot be hatched like that.
    #[error(transparent)]
    Hatch(#[from] HatchError),
    /// It cannot be begun there.
    #[error(transparent)]
    Start(#[from] StartError),
    /// It cannot be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

/// The layers on the paper, within the share of the tolerance that is for curves.
fn read(source: &Source, settings: &Settings) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let mut options = ReadOptions {
        tolerance_mm: settings.flatten_mm(),
        layers: settings.layers.unwrap_or_default(),
        shading: settings.shading,
        fonts: Arc::clone(&settings.fonts),
        ..ReadOptions::default()
    };
    if let Some(page) = source.picture_page()? {
        return read_picture(source, settings, options, page);
    }
    let (artwork, warnings) = source.read(&options)?;
    let placed = settings.placement.place(artwork)?;
    if placed.scale <= 1.0 {
        return Ok((placed, warnings));
    }
    // What is enlarged must be read more finely; the size is known only now.
    options.scale = placed.scale;
    options.tolerance_mm = (settings.flatten_mm() / placed.scale).max(1e-6);
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// The lines of a picture depend on how large it becomes. Its page tells that, but what counts is
/// the ink: where that is much smaller, it is read once more.
fn read_picture(
    source: &Source,
    settings: &Settings,
    mut options: ReadOptions,
    page: Point,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let corners = Layer {
        strokes: vec![Stroke::open(vec![Point::default(), page])],
        ..Layer::default()
    };
    let sheet = Artwork {
        layers: vec![corners],
        ..Artwork::default()
    };
    options.scale = settings.placement.place(sheet)?.scale;
    let (artwork, warnings) = source.read(&options)?;
    let placed = settings.placement.place(artwork)?;
    if (placed.scale / options.scale - 1.0).abs() < SAME_SCALE {
        return Ok((placed, warnings));
    }
    options.scale = placed.scale;
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// The layers as passes, each in a good order.
fn passes<E>(
    layers: Vec<Layer>,
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Pass>, PrepareError> {
    let mut passes = Vec::<Pass>::new();
    let Rect { x1, y1, .. } = settings.placement.area;
    let mut here = Point::new(x1, y1);
    for mut layer in layers {
        let tool = layers::tool(&layer, settings);
        let mut strokes = told_strokes(lines(&mut layer, settings)?, tool, settings)?;
        if settings.clips {
            let clipped = within_reach(&strokes, tool, settings, reachable);
            warnings.extend(cut_off(&clipped));
            strokes = clipped.strokes;
        }
        // Areas that are not hatched leave no ink.
        if strokes.is_empty() {
            continue;
        }
        settings.give_up.check()?;
        let strokes = ordered(strokes, here, tool, settings);
        here = strokes.last().and_then(Stroke::last).unwrap_or(here);
        let message = layers::message(&layer, passes.last(), settings);
        passes.push(Pass {
            name: layer.name,
            color: layer.color,
            tool,
            strokes,
            message,
        });
    }
    Ok(passes)
}

/// The lines of a layer, and those that its areas are hatched with.
fn lines(layer: &mut Layer, settings: &Settings) -> Result<Vec<Stroke>, PrepareError> {
    let mut lines = std::mem::take(&mut layer.strokes);
    if let Some(hatching) = &settings.hatch {
        for area in &layer.areas {
            settings.give_up.check()?;
            lines.append(&mut hatch(area, hatching)?);
        }
    }
    Ok(lines)
}

/// What of the strokes the arm reaches, the tool on the paper and lifted.
fn within_reach<E>(
    strokes: &[Stroke],
    tool: DrawingTool,
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
) -> Clipped {
    let inside = |p: Point| {
        let z_mm = settings.paper.z_at(p);
        let reaches = |z_mm| reachable(Position::new(p.x, p.y, z_mm)).is_ok();
        reaches(z_mm) && reaches(z_mm + tool.lift_mm())
    };
    clip_to_reach(strokes, inside)
}

fn cut_off(clipped: &Clipped) -> Option<Warning> {
    let Clipped {
        cut_mm, cut_dots, ..
    } = clipped;
    (!clipped.is_whole()).then(|| Warning {
        place: None,
        what: "layer out of reach".to_owned(),
        instead: format!("{cut_mm:.0} mm of its lines and {cut_dots} of its dots are cut off"),
        count: 1,
    })
}

/// The strokes, those that meet joined, in a good order, for a tool that comes from `here`.
fn ordered(
    strokes: Vec<Stroke>,
    here: Point,
    tool: DrawingTool,
    settings: &Settings,
) -> Vec<Stroke> {
    let strokes = merge(strokes, settings.tolerance_mm);
    match settings.search(tool) {
        Some(search) => order(strokes, here, &search),
        None => strokes,
    }
}

/// The same pass with the fewest vectors.
fn simplified(pass: &Pass, settings: &Settings) -> Result<Pass, PrepareError> {
    let tolerance_mm = settings.tolerance_mm - settings.flatten_mm();
    let strokes = pass.strokes.iter().map(|it| {
        settings.give_up.check()?;
        let simple = simplify(it, tolerance_mm);
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

/// How much larger than its page says the ink of a picture may become for its lines to stay.
const SAME_SCALE: f64 = 0.05;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::place::Size;
    use dobot_geometry::deviation;
    use dobot_plan::MoveKind;

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
            let worst = deviation(&prepared.wanted(), &planned);
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
        let top = prepared.wanted()[0]
            .points
            .iter()
            .fold(0.0, |top: f64, p| top.max(p.x));
        assert!((top - 270.0).abs() < 0.01, "{top}");
        let planned = prepared.plan.paths(MoveKind::Draw);
        assert!(deviation(&prepared.wanted(), &planned).largest_mm() <= 0.0451);
        assert!(prepared.wanted()[0].points.len() > 60);
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

    #[test]
    fn a_picture_much_larger_than_the_paper_is_hatched_as_wide_as_asked_for() {
        // All black, with a white margin as wide as itself on the right.
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 4800, 1600);
        encoder.set_depth(png::BitDepth::One);
        let row = [[0; 300], [255; 300]].concat();
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(&row.repeat(1600)).unwrap();
        drop(writer);
        let mut settings = Settings::default();
        settings.placement.size = Size::Fit;
        settings.shading.levels = 1;
        settings.tries = None;
        let prepared = prepare(&Source::Picture(file), &settings, anywhere).unwrap();
        let wanted = prepared.wanted();
        let length_mm: f64 = wanted.iter().map(Stroke::length_mm).sum();
        // The ink is as deep as the area and half as wide again.
        let lines_mm = 120.0 * 180.0 / settings.shading.spacing_mm;
        assert!(
            (length_mm / lines_mm - 1.0).abs() < 0.06,
            "{length_mm} mm, not {lines_mm} mm"
        );
    }
}
