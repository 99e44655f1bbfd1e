//! Numbers of a program file: finite, and within what a robot arm has to do with.

use serde::de::Error;
use serde::{Deserialize, Deserializer};

/// Reads a number.
pub(crate) fn finite<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    let found = f64::deserialize(from)?;
    if found.abs() <= LARGEST {
        return Ok(found);
    }
    Err(D::Error::custom(format!(
        "a number is {found}; allowed are -{LARGEST} to {LARGEST}"
    )))
}

/// Reads a number that may be left out.
pub(crate) fn perhaps<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    finite(from).map(Some)
}

/// The value, if it lies within these bounds.
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

/// More than any length, angle, time or speed of an arm.
const LARGEST: f64 = 1e6;
