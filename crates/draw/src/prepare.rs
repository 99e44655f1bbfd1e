//! All steps from a source to a plan.

mod layers;
mod passes;
mod read;
mod settings;
mod vectors;

use std::fmt;

use dobot_arm::Position;
use thiserror::Error;

use self::passes::passes;
use self::read::read;
pub use self::settings::Settings;
pub(crate) use self::settings::{TOLERANCE_MM, TRIES};
use self::vectors::{Trials, simplified};
use crate::arm::backlash::{compensated, most_mm};
use crate::arm::calibrated::raw_passes;
use crate::arm::resume_point::ResumePointError;
use crate::layout::marks::DrawnMarks;
use crate::layout::place::{PlaceError, Placed, check_reach};
use crate::preparation::progress::PrepareStep;
use crate::strokes::hatch::HatchError;
use dobot_geometry::{Cancelled, Point, Stroke};
use dobot_import::{Source, SourceError, Warning};
use dobot_plan::{ArmLimits, DrawingTool, Pass, Plan, PlanError};

/// A prepared drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// The wanted path in drawing order: the curves in the base frame, within a tenth of the
    /// tolerance; for a calibrated arm in raw positions, like the plan.
    pub passes: Vec<Pass>,
    /// The plan of the arm.
    pub plan: Plan,
    /// The scale relative to the source.
    pub scale: f64,
    /// Warnings about content that is not drawn as expected.
    pub warnings: Vec<Warning>,
    /// The minimum and maximum distance from the axis at which the arm reaches the paper, in mm, if
    /// determined.
    pub reach_mm: Option<[f64; 2]>,
}

impl Prepared {
    /// Returns the wanted path of all passes.
    #[must_use]
    pub fn wanted(&self) -> Vec<Stroke> {
        let strokes = self.passes.iter().flat_map(|pass| &pass.strokes);
        strokes.cloned().collect()
    }
}

/// A source and its name, such as a file name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSource {
    /// The name.
    pub name: String,
    /// The content.
    pub source: Source,
}

/// Reads a source, places it, orders its strokes, merges vectors within the tolerance and plans
/// them. `reachable` checks whether the arm reaches a position.
///
/// # Errors
///
/// [`PrepareError`] with the failed step.
pub fn prepare<E: fmt::Display>(
    source: &Source,
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    let alone = NamedSource {
        name: String::new(),
        source: source.clone(),
    };
    prepare_multi_file(&[alone], settings, reachable)
}

/// Prepares several sources on one page: each at its place on its own page, or side by side
/// ([`Settings::grid`]), with texts below everything else.
///
/// # Errors
///
/// [`PrepareError`] with the failed step.
pub fn prepare_multi_file<E: fmt::Display>(
    sources: &[NamedSource],
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    settings.check()?;
    settings.cancel.check()?;
    let reach_mm = reach_mm(settings, settings.tool.lift_mm(), &reachable);
    let mut settings = settings.clone();
    settings.placement.reach = reach_mm.map(|[near, far]| {
        let beside_mm = beside_mm(settings.tool, &settings);
        [near + beside_mm, far - beside_mm]
    });
    let marked = settings.clone();
    let (marks, in_signature) = DrawnMarks::read(&marked).map_err(|error| PrepareError::File {
        name: SIGNATURE.to_owned(),
        error,
    })?;
    settings.placement = marks.reserve(settings.placement);
    let settings = &settings;
    settings.progress.begin(PrepareStep::Reading, 0);
    let (Placed { mut layers, scale }, mut warnings) = read(sources, settings)?;
    warnings.extend(in_signature.into_iter().map(|warning| Warning {
        file: Some(SIGNATURE.to_owned()),
        ..warning
    }));
    settings.cancel.check()?;
    marks.add_to(&mut layers, settings)?;
    let (layers, left_out) = layers::chosen(layers, settings)?;
    warnings.extend(layers::pen_speeds(&layers, settings));
    warnings.extend(layers::unhatched(&layers, settings));
    let passes = passes(layers, left_out, settings, &reachable, &mut warnings)?;
    let prepared = plan_passes(passes, settings, reachable)?;
    warnings.extend(prepared.warnings);
    Ok(Prepared {
        scale,
        warnings,
        reach_mm,
        ..prepared
    })
}

/// Merges vectors within the tolerance and plans them, for passes with a complete layout.
///
/// # Errors
///
/// [`PrepareError`] with the failed step.
pub fn prepare_passes<E: fmt::Display>(
    passes: Vec<Pass>,
    settings: &Settings,
    reachable: impl Fn(Position) -> Result<(), E>,
) -> Result<Prepared, PrepareError> {
    settings.check()?;
    plan_passes(raw_passes(passes, settings)?, settings, reachable)
}

/// Prepares passes in raw positions.
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
    let strokes = passes.iter().flat_map(|pass| &pass.strokes);
    progress.expect(&passes, &settings.arm_limits);
    progress.begin(
        PrepareStep::Vectors,
        strokes.map(|stroke| stroke.points.len()).sum(),
    );
    let mut trials = Trials::new(&passes);
    let simple = passes
        .iter()
        .map(|pass| simplified(pass, settings, &mut trials));
    let simple: Result<Vec<Pass>, PrepareError> = simple.collect();
    let simple = match &settings.calibration {
        Some(known) => compensated(simple?, &settings.paper, &known.arm()),
        None => simple?,
    };
    let lifts_mm = simple.iter().map(|pass| pass.tool.lift_mm());
    let reach_mm = reach_mm(settings, lifts_mm.fold(0.0, f64::max), &reachable);
    let arm_limits = ArmLimits {
        nearest_mm: reach_mm.map_or(0.0, |reach_mm| reach_mm[0]),
        ..settings.arm_limits
    };
    progress.begin(PrepareStep::Planning, 0);
    let plan = Plan::new_until(&simple, &settings.paper, &arm_limits, &settings.cancel)?;
    check_reach(&plan, &settings.paper, reachable)?;
    Ok(Prepared {
        passes,
        warnings: layers::slow_burning(&plan),
        plan,
        scale: 1.0,
        reach_mm: None,
    })
}

/// The error returned when a drawing cannot be prepared.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// The preparation was cancelled.
    #[error("the preparation was cancelled")]
    Cancelled,
    /// The tolerance is out of range.
    #[error("the tolerance is {0:?} mm; it must be a number from 0.02 to 10 mm")]
    Tolerance(f64),
    /// The source cannot be drawn.
    #[error(transparent)]
    Source(SourceError),
    /// One of several sources cannot be drawn.
    #[error("{name}: {error}")]
    File {
        /// The name of the source.
        name: String,
        /// The error in it.
        error: SourceError,
    },
    /// There is no layer with this name.
    #[error("there is no layer {name:?}; {}", if layers.is_empty() { "the layers have no names".to_owned() } else { format!("the layers are {layers}") })]
    NoSuchLayer {
        /// The requested name.
        name: String,
        /// The existing names, separated by commas.
        layers: String,
    },
    /// The drawing does not fit on the paper.
    #[error(transparent)]
    Place(#[from] PlaceError),
    /// No part of the drawing is on the sheet and within reach.
    #[error(
        "no part of the drawing is on the sheet and within the arm's reach; place it elsewhere, or make it smaller with place.fit"
    )]
    AllCutOff,
    /// The areas cannot be hatched with these settings.
    #[error(transparent)]
    Hatch(HatchError),
    /// The resume point does not exist.
    #[error(transparent)]
    ResumePoint(#[from] ResumePointError),
    /// The drawing cannot be planned.
    #[error(transparent)]
    Plan(PlanError),
}

impl From<Cancelled> for PrepareError {
    fn from(Cancelled: Cancelled) -> Self {
        Self::Cancelled
    }
}

impl From<HatchError> for PrepareError {
    fn from(error: HatchError) -> Self {
        match error {
            HatchError::Cancelled(cancelled) => cancelled.into(),
            error => Self::Hatch(error),
        }
    }
}

impl From<PlanError> for PrepareError {
    fn from(error: PlanError) -> Self {
        match error {
            PlanError::Cancelled(cancelled) => cancelled.into(),
            error => Self::Plan(error),
        }
    }
}

/// Returns the minimum and maximum distance from the axis at which the arm reaches the paper, with
/// its tool down and lifted: a contiguous range of whole millimetres around the middle of the area.
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
        let places = (0..MAX_REACH_MM).map(|i| middle + step * f64::from(i));
        places.take_while(|&x| x > 0.0 && reaches(x)).last()
    };
    // The first of both is inside, and no vector ends exactly on the edge.
    Some([last(-1.0)? + 1.0, last(1.0)? - 1.0])
}

/// Returns the maximum distance of the arm from its strokes: the tolerance, because a line along
/// the border of the reach has corners beyond it; run-ups, lead-ins and the kerf of a laser; and
/// the compensation of backlash.
fn beside_mm(tool: DrawingTool, settings: &Settings) -> f64 {
    let slack_mm = settings
        .calibration
        .as_ref()
        .map(|file| most_mm(&file.arm()));
    let cutting_mm = settings.cutting.lead_in_mm + 0.5 * settings.cutting.kerf_mm.abs();
    let run_mm = tool.run_mm(&settings.arm_limits);
    settings.tolerance_mm + run_mm + cutting_mm + slack_mm.unwrap_or_default()
}

/// The name of the signature in errors and warnings.
const SIGNATURE: &str = "place.sign";
/// Larger than the reach of any arm.
const MAX_REACH_MM: u32 = 400;

#[cfg(test)]
mod tests;
