//! The whole way from a source to a plan.

mod layers;
mod settings;
mod vectors;

use std::fmt;
use std::sync::Arc;

use dobot_arm::Position;
use thiserror::Error;

pub use self::settings::Settings;
pub(crate) use self::settings::TRIES;
use self::vectors::simplified;
use crate::backlash::taken_up;
use crate::calibrated::{told_passes, told_strokes};
use crate::clip::{Clipped, clip_to_reach};
use crate::cutting::inner_first;
use crate::doubles::without_doubles;
use crate::hatch::{HatchError, hatch};
use crate::merge::merge;
use crate::order::order;
use crate::place::{PlaceError, Placed, check_reach};
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
    /// How near and how far from its axis the arm reaches the paper, in mm, where it was asked.
    pub reach_mm: Option<[f64; 2]>,
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
    settings.give_up.check()?;
    let mut settings = settings.clone();
    settings.placement.reach = reach_mm(&settings, &reachable);
    let settings = &settings;
    let (Placed { layers, scale }, mut warnings) = read(source, settings)?;
    settings.give_up.check()?;
    let layers = layers::chosen(layers, settings)?;
    let passes = passes(layers, settings, &reachable, &mut warnings)?;
    let prepared = plan_passes(passes, settings, reachable)?;
    Ok(Prepared {
        scale,
        warnings,
        reach_mm: settings.placement.reach,
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
    let simple = match &settings.calibration {
        Some(known) => taken_up(simple?, &settings.paper, &known.arm()),
        None => simple?,
    };
    let plan = Plan::new(&simple, &settings.paper, &settings.machine)?;
    check_reach(&plan, &settings.paper, reachable)?;
    Ok(Prepared {
        passes,
        plan,
        scale: 1.0,
        warnings: Vec::new(),
        reach_mm: None,
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
    #[error("the tolerance is {0:?} mm; it must be a number from 0.02 to 10 mm")]
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
        crops: settings.crops,
        fonts: Arc::clone(&settings.fonts),
        ..ReadOptions::default()
    };
    if let Some(page) = source.picture_page()? {
        return read_picture(source, settings, options, page);
    }
    let (artwork, warnings) = read_coarsely(source, &mut options)?;
    let placed = settings.placement.place(artwork)?;
    // What counts is the size on the paper, which is known only now.
    let tolerance_mm = (settings.flatten_mm() / placed.scale).max(1e-6);
    if (options.tolerance_mm..options.tolerance_mm * MUCH).contains(&tolerance_mm) {
        return Ok((placed, warnings));
    }
    options.scale = placed.scale;
    options.tolerance_mm = tolerance_mm;
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// Reads a source as finely as its own size allows: a town in metres has too many corners for that, but
/// not as a drawing on the paper.
fn read_coarsely(
    source: &Source,
    options: &mut ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    loop {
        match source.read(options) {
            Err(error) if error.is_too_fine() && options.tolerance_mm < COARSEST_MM => {
                options.tolerance_mm *= COARSER;
            }
            read => return read,
        }
    }
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
        width_mm: page.x,
        height_mm: page.y,
        layers: vec![corners],
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
        let mut strokes = told_strokes(on_sheet(&mut layer, settings, warnings)?, tool, settings)?;
        if settings.clips {
            let clipped = within_reach(&strokes, tool, settings, reachable);
            warnings.extend(cut_off(&clipped, "layer out of reach"));
            strokes = clipped.strokes;
        }
        // Areas that are not hatched leave no ink.
        if strokes.is_empty() {
            continue;
        }
        settings.give_up.check()?;
        let strokes = finished(strokes, here, tool, settings, warnings);
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

/// The lines of a layer, cut at the edge of the sheet where that is wanted.
fn on_sheet(
    layer: &mut Layer,
    settings: &Settings,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Stroke>, PrepareError> {
    let lines = lines(layer, settings)?;
    let Some(sheet) = settings.placement.sheet else {
        return Ok(lines);
    };
    if settings.clips {
        let clipped = clip_to_reach(&lines, |p| sheet.beyond_mm(p) <= ON_SHEET_MM);
        warnings.extend(cut_off(&clipped, "layer beyond the sheet"));
        return Ok(clipped.strokes);
    }
    let points = lines.iter().flat_map(|it| &it.points);
    let beyond = points.map(|&p| (sheet.beyond_mm(p), p));
    match beyond.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((by_mm, p)) if by_mm > ON_SHEET_MM => Err(PlaceError::BeyondSheet {
            by_mm,
            x_mm: p.x,
            y_mm: p.y,
        }
        .into()),
        _ => Ok(lines),
    }
}

/// How near and how far from its axis the arm reaches the paper, with its tool down and lifted: whole
/// millimetres without a gap around the middle of the area.
fn reach_mm<E>(
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
) -> Option<[f64; 2]> {
    let reaches = |x: f64| {
        let z_mm = settings.paper.z_at(Point::new(x, 0.0));
        let heights_mm = [z_mm, z_mm + settings.tool.lift_mm()];
        heights_mm
            .into_iter()
            .all(|z| reachable(Position::new(x, 0.0, z)).is_ok())
    };
    let middle = settings.placement.area.center().x.round();
    let last = |step: f64| {
        let places = (0..MOST_REACH_MM).map(|i| middle + step * f64::from(i));
        places.take_while(|&x| x > 0.0 && reaches(x)).last()
    };
    // The first of both is inside, and no vector ends on the very edge.
    Some([last(-1.0)? + 1.0, last(1.0)? - 1.0])
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

fn cut_off(clipped: &Clipped, what: &str) -> Option<Warning> {
    let Clipped {
        cut_mm, cut_dots, ..
    } = clipped;
    (!clipped.is_whole()).then(|| Warning {
        place: None,
        what: what.to_owned(),
        instead: format!("{cut_mm:.0} mm of its lines and {cut_dots} of its dots are cut off"),
        count: 1,
    })
}

/// The strokes as they are drawn, for a tool that comes from `here`: those that meet joined, in a good
/// order, of a laser as it cuts them, of a pen as often as it goes over them.
fn finished(
    strokes: Vec<Stroke>,
    here: Point,
    tool: DrawingTool,
    settings: &Settings,
    warnings: &mut Vec<Warning>,
) -> Vec<Stroke> {
    let (strokes, doubles) = if settings.drops_doubles {
        without_doubles(strokes, settings.tolerance_mm)
    } else {
        (strokes, 0)
    };
    warnings.extend(counted(doubles, "double line", "drawn once"));
    let strokes = merge(strokes, settings.join_mm.unwrap_or(settings.tolerance_mm));
    let DrawingTool::Laser(laser) = tool else {
        let strokes = ordered(strokes, here, tool, settings);
        return strokes
            .into_iter()
            .map(|it| gone_over(it, settings.pen_passes))
            .collect();
    };
    let (strokes, gone) = settings.cutting.offset(strokes, settings.flatten_mm());
    let groups = if laser.cuts && settings.tries.is_some() {
        inner_first(strokes)
    } else {
        vec![strokes]
    };
    let (mut all, mut here) = (Vec::new(), here);
    for group in groups {
        all.append(&mut ordered(group, here, tool, settings));
        here = all.last().and_then(Stroke::last).unwrap_or(here);
    }
    let (all, small) = settings.cutting.finished(all);
    warnings.extend(counted(gone, "hole narrower than the beam", "left out"));
    warnings.extend(counted(
        small,
        "shape without room for its tabs",
        "cut all around",
    ));
    all
}

fn counted(count: usize, what: &str, instead: &str) -> Option<Warning> {
    (count > 0).then(|| Warning {
        place: None,
        what: what.to_owned(),
        instead: instead.to_owned(),
        count,
    })
}

/// A stroke drawn several times without lifting the pen: a closed one goes on around, an open one back
/// and forth.
fn gone_over(mut stroke: Stroke, times: u32) -> Stroke {
    let once = stroke.points.clone();
    let is_loop = once.len() > 2 && once.first() == once.last();
    for time in 1..times {
        let mut again = once.clone();
        if !is_loop && time % 2 == 1 {
            again.reverse();
        }
        stroke.points.extend(again.into_iter().skip(1));
    }
    stroke
}

/// The strokes in a good order, for a tool that comes from `here`.
fn ordered(
    strokes: Vec<Stroke>,
    here: Point,
    tool: DrawingTool,
    settings: &Settings,
) -> Vec<Stroke> {
    match settings.search(tool) {
        Some(search) => order(strokes, here, &search),
        None => strokes,
    }
}

/// Where a file has too many corners even like this, it would on the paper.
const COARSEST_MM: f64 = 100.0;
const COARSER: f64 = 30.0;
/// So much beyond the edge of a sheet is on it.
const ON_SHEET_MM: f64 = 0.5;
/// No arm reaches farther.
const MOST_REACH_MM: u32 = 400;
/// What is read so many times finer than it need be is read once more.
const MUCH: f64 = 4.0;
/// How much larger than its page says the ink of a picture may become for its lines to stay.
const SAME_SCALE: f64 = 0.05;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::place::Size;
    use dobot_geometry::deviation;
    use dobot_plan::{Laser, MoveKind};

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
    fn a_plan_in_metres_is_read_as_finely_as_its_place_on_the_paper_needs() {
        // Arcs of 100 m whose corners at 5 micrometres would be 70,000, sixty times over.
        let arcs = (0..60).map(|i| format!("0 ARC 8 0 10 {i} 20 0 40 100 50 0 51 359 "));
        let arcs: Vec<String> = arcs.collect();
        let arcs = arcs.concat().replace(' ', "\n");
        let dxf = format!(
            "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n\
             0\nSECTION\n2\nENTITIES\n{arcs}0\nENDSEC\n0\nEOF\n"
        );
        let mut settings = Settings::default();
        settings.placement.size = Size::Within;
        settings.tries = None;
        let prepared = prepare(&Source::Dxf(dxf.into_bytes()), &settings, in_reach).unwrap();
        let planned = prepared.plan.paths(MoveKind::Draw);
        let worst = deviation(&prepared.wanted(), &planned);
        assert!(worst.largest_mm() <= 0.0451, "{worst:?}");
        let corners: usize = prepared.wanted().iter().map(|it| it.points.len()).sum();
        // Of a circle of some 75 mm radius, 5 micrometres from it: 272 each.
        assert!((60 * 200..60 * 350).contains(&corners), "{corners}");
    }

    #[test]
    fn a_material_that_is_cut_through_is_cut_inside_first() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
            <g fill="none" stroke="red"><rect x="10" y="10" width="100" height="60"/><circle cx="30" cy="30" r="8"/>
            <circle cx="80" cy="40" r="12"/><rect x="45" y="20" width="15" height="15"/></g></svg>"#;
        let laser = |cuts| {
            DrawingTool::Laser(Laser {
                cuts,
                ..Laser::default()
            })
        };
        let lengths = |cuts| {
            let settings = Settings {
                tool: laser(cuts),
                ..Settings::default()
            };
            let wanted = prepare(&svg.into(), &settings, anywhere).unwrap().wanted();
            wanted
                .iter()
                .map(|it| it.length_mm().round())
                .collect::<Vec<f64>>()
        };
        assert_eq!(lengths(true).last(), Some(&320.0));
        // An engraving may go the shortest way.
        assert_ne!(lengths(false).last(), Some(&320.0));
    }

    #[test]
    fn a_pen_goes_over_each_line_as_often_as_asked_for() {
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
            <g fill="none" stroke="red"><path d="M5 5H25"/><rect x="5" y="20" width="10" height="10"/></g></svg>"#;
        let settings = Settings {
            pen_passes: 3,
            ..Settings::default()
        };
        let summary = prepare(&svg.into(), &settings, anywhere)
            .unwrap()
            .plan
            .summary();
        assert_eq!(summary.strokes, 2);
        assert!(
            (summary.drawn_mm - 180.0).abs() < 0.01,
            "{}",
            summary.drawn_mm
        );
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
            "the tolerance is 0.01 mm; it must be a number from 0.02 to 10 mm"
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
