//! The least and the most of a quantity.

use std::fmt;

use dobot_arm::{Degrees, Span};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The least and the most that is allowed; both are allowed. In a file: `[min, max]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Vec<f64>", into = "[f64; 2]")]
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

    pub(crate) const fn degrees(span: Span<Degrees>) -> Self {
        Self::new(span.min.0, span.max.0)
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
        write!(f, "{} to {}", self.min, self.max)
    }
}

/// A reader that takes arrays by their length would be content with the first two of three numbers.
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
