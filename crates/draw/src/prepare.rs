//! The whole way from a source to a plan.

mod layers;
mod read;
mod settings;
mod vectors;

use std::fmt;

use dobot_arm::Position;
use thiserror::Error;

use self::read::read;
pub use self::settings::Settings;
pub(crate) use self::settings::TRIES;
use self::vectors::{Trials, simplified};
use crate::backlash::{most_mm, taken_up};
use crate::calibrated::{told_passes, told_strokes};
use crate::clip::{Clipped, clip_to_reach};
use crate::cutting::inner_first;
use crate::doubles::without_doubles;
use crate::hatch::{HatchError, hatch};
use crate::merge::merge;
use crate::order::order;
use crate::place::{PlaceError, Placed, check_reach};
use crate::progress::PrepareStep;
use crate::start::StartError;
use dobot_geometry::{Point, Rect, Stroke};
use dobot_plan::{DrawingTool, Machine, Pass, Plan, PlanError};
use dobot_source::{Layer, Source, SourceError, Warning};

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

/// A source with what a person calls it, such as the name of its file.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSource {
    /// What a person calls it.
    pub name: String,
    /// What it holds.
    pub source: Source,
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
    let alone = NamedSource {
        name: String::new(),
        source: source.clone(),
    };
    prepare_together(&[alone], settings, reachable)
}

/// The same for several sources on one page: each where it is on its own page, or side by side
/// ([`Settings::grid`]), and texts below all else.
///
/// # Errors
///
/// [`PrepareError`] with the step that failed.
pub fn prepare_together<E: fmt::Display>(
    sources: &[NamedSource],
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    settings.check()?;
    settings.give_up.check()?;
    let reach_mm = reach_mm(settings, settings.tool.lift_mm(), &reachable);
    let mut settings = settings.clone();
    settings.placement.reach = reach_mm.map(|[near, far]| {
        let beside_mm = beside_mm(settings.tool, &settings);
        [near + beside_mm, far - beside_mm]
    });
    let settings = &settings;
    settings.progress.begin(PrepareStep::Reading, 0);
    let (Placed { layers, scale }, mut warnings) = read(sources, settings)?;
    settings.give_up.check()?;
    let layers = layers::chosen(layers, settings)?;
    warnings.extend(layers::pen_speeds(&layers, settings));
    warnings.extend(layers::unhatched(&layers, settings));
    let passes = passes(layers, settings, &reachable, &mut warnings)?;
    let prepared = plan_passes(passes, settings, reachable)?;
    Ok(Prepared {
        scale,
        warnings,
        reach_mm,
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
    let progress = &settings.progress;
    let strokes = passes.iter().flat_map(|it| &it.strokes);
    progress.expect(&passes, &settings.machine);
    progress.begin(
        PrepareStep::Vectors,
        strokes.map(|it| it.points.len()).sum(),
    );
    let mut trials = Trials::new(&passes);
    let simple = passes
        .iter()
        .map(|it| simplified(it, settings, &mut trials));
    let simple: Result<Vec<Pass>, PrepareError> = simple.collect();
    let simple = match &settings.calibration {
        Some(known) => taken_up(simple?, &settings.paper, &known.arm()),
        None => simple?,
    };
    let lifts_mm = simple.iter().map(|it| it.tool.lift_mm());
    let reach_mm = reach_mm(settings, lifts_mm.fold(0.0, f64::max), &reachable);
    let machine = Machine {
        nearest_mm: reach_mm.map_or(0.0, |it| it[0]),
        ..settings.machine
    };
    progress.begin(PrepareStep::Planning, 0);
    let plan = Plan::new(&simple, &settings.paper, &machine)?;
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
    /// One of several sources cannot be drawn.
    #[error("{name}: {error}")]
    File {
        /// What a person calls it.
        name: String,
        /// What is wrong with it.
        error: SourceError,
    },
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
    /// Nothing of it is on the sheet and within reach.
    #[error(
        "nothing is left of the drawing: all of it is beyond the sheet or out of the arm's reach; place it elsewhere, or make it smaller with --fit"
    )]
    AllCutOff,
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

/// The layers as passes, each in a good order.
fn passes<E>(
    layers: Vec<Layer>,
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Pass>, PrepareError> {
    let mut passes = Vec::<Pass>::new();
    let count = if layers.len() > 1 { layers.len() } else { 0 };
    settings.progress.begin(PrepareStep::Ordering, count);
    let Rect { x1, y1, .. } = settings.placement.area;
    let mut here = Point::new(x1, y1);
    let mut has_lines = false;
    let mut laid: Vec<(Layer, DrawingTool, Vec<Stroke>)> = Vec::new();
    for mut layer in layers {
        let tool = layers::tool(&layer, settings);
        let lines = lines(&mut layer, settings)?;
        has_lines |= !lines.is_empty();
        let mut strokes = told_strokes(on_sheet(lines, settings, warnings)?, tool, settings)?;
        if settings.clips {
            let clipped = within_reach(&strokes, tool, settings, reachable);
            warnings.extend(cut_off(&clipped, "layer out of reach"));
            strokes = clipped.strokes;
        }
        // Areas that are not hatched leave no ink.
        if !strokes.is_empty() {
            laid.push((layer, tool, strokes));
        }
    }
    let several = laid.len() > 1;
    let cut: Vec<Vec<Stroke>> = laid
        .iter()
        .filter(|_| several)
        .map(|(_, tool, strokes)| cut_shapes(strokes, *tool, settings))
        .collect();
    for (number, (layer, tool, strokes)) in laid.into_iter().enumerate() {
        settings.give_up.check()?;
        let others = cut.iter().enumerate().filter(|it| it.0 != number);
        let others: Vec<Stroke> = others.flat_map(|it| it.1).cloned().collect();
        let strokes = finished(strokes, &others, here, tool, settings, warnings);
        settings.progress.advance(1);
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
    if has_lines && passes.is_empty() {
        return Err(PrepareError::AllCutOff);
    }
    Ok(passes)
}

/// The closed shapes that are cut out of a layer, where anything is done to such.
fn cut_shapes(strokes: &[Stroke], tool: DrawingTool, settings: &Settings) -> Vec<Stroke> {
    if !settings.cutting_of(tool).is_asked_for() {
        return Vec::new();
    }
    let mut shapes = merge(strokes.to_vec(), settings.join_mm());
    shapes.retain(|it| it.closed);
    shapes
}

/// Lines, cut at the edge of the sheet where that is wanted.
fn on_sheet(
    lines: Vec<Stroke>,
    settings: &Settings,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Stroke>, PlaceError> {
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
        }),
        _ => Ok(lines),
    }
}

/// How near and how far from its axis the arm reaches the paper, with its tool down and lifted so high: whole
/// millimetres without a gap around the middle of the area.
fn reach_mm<E>(
    settings: &Settings,
    lift_mm: f64,
    reachable: &impl Fn(Position) -> Result<(), E>,
) -> Option<[f64; 2]> {
    let reaches = |x: f64| {
        let z_mm = settings.paper.z_at(Point::new(x, 0.0));
        let heights_mm = [z_mm, z_mm + lift_mm];
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

/// What of the strokes the arm reaches, the tool on the paper and lifted, wherever it is sent for them.
fn within_reach<E>(
    strokes: &[Stroke],
    tool: DrawingTool,
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
) -> Clipped {
    let reaches = |p: Point| {
        let z_mm = settings.paper.z_at(p);
        let reaches = |z_mm| reachable(Position::new(p.x, p.y, z_mm)).is_ok();
        reaches(z_mm) && reaches(z_mm + tool.lift_mm())
    };
    let beside_mm = beside_mm(tool, settings);
    clip_to_reach(strokes, |p| around(p, beside_mm).into_iter().all(&reaches))
}

/// How far beside its strokes the arm is sent: within the tolerance, as a line that follows the border of the reach has
/// corners beyond it, where a laser runs up and begins its cuts, and where slack joints are taken up.
fn beside_mm(tool: DrawingTool, settings: &Settings) -> f64 {
    let slack_mm = settings.calibration.as_ref().map(|it| most_mm(&it.arm()));
    let cutting_mm = settings.cutting.lead_in_mm + 0.5 * settings.cutting.kerf_mm.abs();
    let run_mm = tool.run_mm(&settings.machine);
    settings.tolerance_mm + run_mm + cutting_mm + slack_mm.unwrap_or_default()
}

/// The places beside one, towards the axis of the arm, away from it, and to both sides: the borders of the reach are arcs
/// around the axis and lines towards it.
fn around(p: Point, by_mm: f64) -> [Point; 4] {
    let from_axis = p.to_vec2();
    let out = from_axis * (by_mm / from_axis.hypot().max(by_mm));
    let aside = out.turn_90();
    [p + out, p - out, p + aside, p - aside]
}

fn cut_off(clipped: &Clipped, what: &str) -> Option<Warning> {
    let Clipped {
        cut_mm, cut_dots, ..
    } = clipped;
    (!clipped.is_whole()).then(|| Warning {
        file: None,
        place: None,
        what: what.to_owned(),
        instead: format!("{cut_mm:.0} mm of its lines and {cut_dots} of its dots are cut off"),
        count: 1,
    })
}

/// The strokes as they are drawn, for a tool that comes from `here`: those that meet joined, in a good
/// order, of a laser as it cuts them beside what is cut in other layers, of a pen as often as it goes over them.
fn finished(
    strokes: Vec<Stroke>,
    others: &[Stroke],
    here: Point,
    tool: DrawingTool,
    settings: &Settings,
    warnings: &mut Vec<Warning>,
) -> Vec<Stroke> {
    let strokes = if settings.drops_doubles {
        let single = without_doubles(strokes, settings.cutting_of(tool).is_asked_for());
        warnings.extend(counted(single.doubles, "double line", "drawn once"));
        warnings.extend(counted(
            single.unknown,
            "line",
            "not compared with the others: there are too many in one place",
        ));
        single.strokes
    } else {
        strokes
    };
    let strokes = merge(strokes, settings.join_mm());
    let DrawingTool::Laser(laser) = tool else {
        let strokes = ordered(strokes, here, tool, settings);
        let strokes = if settings.joins_dots() {
            one_line(strokes)
        } else {
            strokes
        };
        return strokes
            .into_iter()
            .map(|it| gone_over(it, settings.pen_passes))
            .collect();
    };
    let cutting = settings.cutting_of(tool);
    let (strokes, gone) = cutting.offset(strokes, others, settings.flatten_mm());
    let groups = if laser.cuts && settings.tries.is_some() {
        inner_first(strokes)
    } else {
        vec![strokes]
    };
    let (mut all, mut here) = (Vec::new(), here);
    for group in groups {
        let group = ordered(group, here, tool, settings);
        all.append(&mut if settings.joins_dots() {
            one_line(group)
        } else {
            group
        });
        here = all.last().and_then(Stroke::last).unwrap_or(here);
    }
    let cut = cutting.finished(all, others);
    warnings.extend(counted(gone, "narrow hole", "left out, the beam is wider"));
    warnings.extend(counted(
        cut.too_small,
        "shape",
        "too small for tabs: cut all around",
    ));
    warnings.extend(counted(
        cut.short_of_room,
        "shorter lead-in",
        "the waste beside the cut has no room for more",
    ));
    cut.strokes
}

fn counted(count: usize, what: &str, instead: &str) -> Option<Warning> {
    (count > 0).then(|| Warning {
        file: None,
        place: None,
        what: what.to_owned(),
        instead: instead.to_owned(),
        count,
    })
}

/// A stroke drawn several times without lifting the pen: a closed one goes on around, an open one back
/// and forth.
fn gone_over(mut stroke: Stroke, times: u32) -> Stroke {
    if times < 2 {
        return stroke;
    }
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

/// All strokes as one, in their order.
fn one_line(strokes: Vec<Stroke>) -> Vec<Stroke> {
    let points: Vec<Point> = strokes.into_iter().flat_map(|it| it.points).collect();
    vec![Stroke::open(points)]
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

/// So much beyond the edge of a sheet is on it.
const ON_SHEET_MM: f64 = 0.5;
/// No arm reaches farther.
const MOST_REACH_MM: u32 = 400;

#[cfg(test)]
mod tests;
