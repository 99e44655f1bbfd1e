//! Numbers of a program file: finite and within a range.

use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// Deserializes a number.
pub(crate) fn finite<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    let found = f64::deserialize(from)?;
    if found.abs() <= MAX_VALUE {
        return Ok(found);
    }
    Err(D::Error::custom(format!(
        "a number is {found}; allowed are -{MAX_VALUE} to {MAX_VALUE}"
    )))
}

/// Deserializes an optional number.
pub(crate) fn perhaps<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    finite(from).map(Some)
}

/// Returns the value if it lies within the bounds.
pub(crate) fn within(
    name: &str,
    unit: &str,
    found: f64,
    least: f64,
    most: f64,
) -> Result<f64, String> {
    if (least..=most).contains(&found) {
        return Ok(found);
    }
    Err(format!(
        "{name} is {found}{unit}; allowed are {least} to {most}{unit}"
    ))
}

/// The largest number; lengths, angles, times and speeds of an arm are smaller.
const MAX_VALUE: f64 = 1e6;
