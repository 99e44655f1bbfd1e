//! Errors of planning strokes.

use thiserror::Error;

use crate::PaperError;
use dobot_geometry::Cancelled;

/// The error returned when strokes cannot be planned.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// Planning was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// There are no strokes.
    #[error("there is no stroke to plan")]
    NoStrokes,
    /// A setting is not a number or below its minimum.
    #[error("{name} is {found}{}; it must be a number {allowed}", spaced(.unit))]
    Setting {
        /// The setting.
        name: &'static str,
        /// Its unit; empty for a count.
        unit: &'static str,
        /// The value.
        found: f64,
        /// The allowed values.
        allowed: &'static str,
    },
    /// A speed is too low for a stock arm: less than half the change per tick.
    #[error(
        "{name} is {found} mm/s; a stock arm keeps no less than {least} mm/s at an acceleration of {acceleration} mm/s2 (note N48)"
    )]
    TooSlow {
        /// The speed's name.
        name: &'static str,
        /// The value.
        found: f64,
        /// The minimum.
        least: f64,
        /// The acceleration in mm/s2.
        acceleration: f64,
    },
    /// The pen would not leave the paper: its lift, in mm.
    #[error("the pen lift is {0} mm; it must be at least 0.1 mm")]
    Lift(f64),
    /// The paper is invalid.
    #[error(transparent)]
    Paper(#[from] PaperError),
    /// A stock arm keeps its height in laser mode. Passes count from 1.
    #[error(
        "pass {0} uses the laser, but the paper slopes; a stock arm keeps its height in laser mode (note N48); lay the material level"
    )]
    SlopingLaser(usize),
    /// Pen and laser need different heights. Passes count from 1.
    #[error(
        "pass {0} has a different kind of tool than those before; draw pen and laser passes separately, each at its own height"
    )]
    MixedTools(usize),
}

fn spaced(unit: &str) -> String {
    if unit.is_empty() {
        return String::new();
    }
    format!(" {unit}")
}

pub(super) fn positive(
    name: &'static str,
    found: f64,
    unit: &'static str,
) -> Result<(), PlanError> {
    check(found > 0.0, name, found, unit, "above 0")
}

pub(super) fn not_negative(
    name: &'static str,
    found: f64,
    unit: &'static str,
) -> Result<(), PlanError> {
    check(found >= 0.0, name, found, unit, "from 0 up")
}

fn check(
    is_allowed: bool,
    name: &'static str,
    found: f64,
    unit: &'static str,
    allowed: &'static str,
) -> Result<(), PlanError> {
    if is_allowed && found.is_finite() {
        return Ok(());
    }
    Err(PlanError::Setting {
        name,
        unit,
        found,
        allowed,
    })
}
