//! The minimum and maximum of a quantity.

use std::fmt;

use dobot_arm::{Degrees, Span};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The minimum and maximum allowed, inclusive. In a file: `[min, max]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Vec<f64>", into = "[f64; 2]")]
#[schemars(with = "[f64; 2]")]
pub struct Bounds {
    /// The minimum.
    pub min: f64,
    /// The maximum.
    pub max: f64,
}

impl Bounds {
    /// Creates bounds from `min` to `max`.
    #[must_use]
    pub const fn new(min: f64, max: f64) -> Self {
        Self { min, max }
    }

    pub(crate) const fn degrees(span: Span<Degrees>) -> Self {
        Self::new(span.min.0, span.max.0)
    }

    /// Returns whether a value is allowed; NaN never is.
    #[must_use]
    pub const fn contains(self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }

    /// Returns the allowed value nearest to this one.
    #[must_use]
    pub const fn nearest(self, value: f64) -> f64 {
        value.max(self.min).min(self.max)
    }

    /// Extends the bounds on both sides.
    pub(crate) const fn grown(self, by: f64) -> Self {
        Self {
            min: self.min - by,
            max: self.max + by,
        }
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {}", self.min, self.max)
    }
}

/// A derived reader would accept an array of three numbers and ignore the third.
impl TryFrom<Vec<f64>> for Bounds {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, Self::Error> {
        match numbers[..] {
            [min, max] => Ok(Self { min, max }),
            _ => Err(format!(
                "found {} numbers in brackets, expected two, [min, max]",
                numbers.len()
            )),
        }
    }
}

impl From<Bounds> for [f64; 2] {
    fn from(bounds: Bounds) -> Self {
        [bounds.min, bounds.max]
    }
}
