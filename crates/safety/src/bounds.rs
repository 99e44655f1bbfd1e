//! The least and the most of a quantity.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The least and the most that is allowed; both are allowed. In a file: `[min, max]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[f64; 2]", into = "[f64; 2]")]
#[schemars(with = "[f64; 2]")]
pub struct Bounds {
    /// The least.
    pub min: f64,
    /// The most.
    pub max: f64,
}

impl Bounds {
    /// From `min` to `max`.
    #[must_use]
    pub const fn new(min: f64, max: f64) -> Self {
        Self { min, max }
    }

    /// Whether a value is allowed; NaN never is.
    #[must_use]
    pub const fn contains(self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }

    /// The allowed value that is nearest to this one.
    #[must_use]
    pub const fn nearest(self, value: f64) -> f64 {
        value.max(self.min).min(self.max)
    }

    /// The same, made wider so that it contains `value` too.
    pub(crate) const fn with(self, value: f64) -> Self {
        Self {
            min: self.min.min(value),
            max: self.max.max(value),
        }
    }

    /// The same with so much more on either side.
    pub(crate) const fn grown(self, by: f64) -> Self {
        Self {
            min: self.min - by,
            max: self.max + by,
        }
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.min.is_finite(), self.max.is_finite()) {
            (true, true) => write!(f, "{} to {}", self.min, self.max),
            (true, false) => write!(f, "{} and more", self.min),
            (false, _) => write!(f, "{} and less", self.max),
        }
    }
}

impl From<[f64; 2]> for Bounds {
    fn from([min, max]: [f64; 2]) -> Self {
        Self { min, max }
    }
}

impl From<Bounds> for [f64; 2] {
    fn from(bounds: Bounds) -> Self {
        [bounds.min, bounds.max]
    }
}
