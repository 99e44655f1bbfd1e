//! Errors of motion planning.

/// The error returned when a motion cannot be planned.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A start or target coordinate is NaN or infinite.
    #[error("{name} is {found}; a motion needs a finite number")]
    NotFinite {
        /// The name of the number.
        name: &'static str,
        /// The value.
        found: f64,
    },
    /// A distance or a speed that may be zero is negative, not finite or too large.
    #[error("{name} is {found}; a motion allows 0 to 3.4e38")]
    Negative {
        /// The name of the number.
        name: &'static str,
        /// The value.
        found: f64,
    },
    /// A limit is zero, negative, not finite or too large.
    #[error("{name} is {found}; a motion needs more than 0 and at most 3.4e38")]
    NotPositive {
        /// The name of the number.
        name: &'static str,
        /// The value.
        found: f64,
    },
    /// A start or end speed is greater than the maximum speed of the same motion.
    #[error("{name} is {found}; the maximum speed of the same motion allows 0 to {max}")]
    AboveMaximum {
        /// The name of the number.
        name: &'static str,
        /// The value.
        found: f64,
        /// The maximum speed.
        max: f64,
    },
    /// The limits are so small that the motion would never end.
    #[error("the motion takes {found} s; a motion allows a finite time")]
    Endless {
        /// The duration: infinite.
        found: f64,
    },
}

pub(crate) fn finite(name: &'static str, found: f64) -> Result<(), PlanError> {
    if found.is_finite() {
        Ok(())
    } else {
        Err(PlanError::NotFinite { name, found })
    }
}

pub(crate) fn not_negative(name: &'static str, found: f64) -> Result<(), PlanError> {
    if (0.0..=LARGEST).contains(&found) {
        Ok(())
    } else {
        Err(PlanError::Negative { name, found })
    }
}

pub(crate) fn positive(name: &'static str, found: f64) -> Result<(), PlanError> {
    if found > 0.0 && found <= LARGEST {
        Ok(())
    } else {
        Err(PlanError::NotPositive { name, found })
    }
}

/// The largest number on the wire; its square is still a finite `f64`.
const LARGEST: f64 = f32::MAX as f64;
