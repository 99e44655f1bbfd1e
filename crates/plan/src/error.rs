//! Why strokes cannot be planned.

use thiserror::Error;

use crate::PaperError;

/// Why strokes cannot be planned.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PlanError {
    /// There is no stroke.
    #[error("there is no stroke to plan")]
    NoStrokes,
    /// A setting that must be positive is not.
    #[error("{name} is {found}{}; it must be a number above 0", spaced(.unit))]
    NotPositive {
        /// Which setting.
        name: &'static str,
        /// Its unit; empty for a number of things.
        unit: &'static str,
        /// What it is.
        found: f64,
    },
    /// A setting that may be zero is less.
    #[error("{name} is {found}{}; it must be a number from 0 up", spaced(.unit))]
    Negative {
        /// Which setting.
        name: &'static str,
        /// Its unit; empty for a number of things.
        unit: &'static str,
        /// What it is.
        found: f64,
    },
    /// A stock arm cannot be as slow: a tick changes its speed by twice that.
    #[error(
        "{name} is {found} mm/s; a stock arm keeps no less than {least} mm/s at an acceleration of {acceleration} mm/s2 (note N48)"
    )]
    TooSlow {
        /// Which speed.
        name: &'static str,
        /// What it is.
        found: f64,
        /// The least that is allowed.
        least: f64,
        /// The acceleration in mm/s2.
        acceleration: f64,
    },
    /// The pen would not leave the paper.
    #[error("the pen is lifted by {lift_mm} mm; it must be at least 0.1 mm")]
    Lift {
        /// How far it would be lifted.
        lift_mm: f64,
    },
    /// There is no such paper.
    #[error(transparent)]
    Paper(#[from] PaperError),
    /// In laser mode a stock arm holds its height.
    #[error(
        "pass {pass} burns with the laser, and the paper slopes; a stock arm holds its height in laser mode (note N48): lay the material level"
    )]
    SlopingLaser {
        /// Which pass, from 1.
        pass: usize,
    },
    /// A pen and a laser do not stand at the same height.
    #[error(
        "pass {pass} has another kind of tool than those before; a pen and a laser are drawn one after the other, each with its own height"
    )]
    MixedTools {
        /// Which pass, from 1.
        pass: usize,
    },
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
    if found > 0.0 && found.is_finite() {
        return Ok(());
    }
    Err(PlanError::NotPositive { name, unit, found })
}

pub(super) fn not_negative(
    name: &'static str,
    found: f64,
    unit: &'static str,
) -> Result<(), PlanError> {
    if found >= 0.0 && found.is_finite() {
        return Ok(());
    }
    Err(PlanError::Negative { name, unit, found })
}
