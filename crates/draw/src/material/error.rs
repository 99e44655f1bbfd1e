//! Errors of materials.

use thiserror::Error;

use dobot_teach::nearest;

/// The error returned when a materials file is invalid.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("line {line}: {reason}")]
pub struct MaterialError {
    /// The line, counted from 1.
    pub line: usize,
    /// The key with the value found and the allowed ones, or the message of the TOML reader.
    pub reason: String,
}

/// The error returned when there is no material with this name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no material '{name}'; {}there are{}", meant(.name, .known), listed(.known))]
pub struct UnknownMaterial {
    /// The name.
    pub name: String,
    /// The known names.
    pub known: Vec<String>,
}

fn meant(name: &str, known: &[String]) -> String {
    let nearest = nearest(name, known.iter().map(String::as_str));
    nearest.map_or_else(String::new, |name| format!("did you mean '{name}'? "))
}

fn listed(known: &[String]) -> String {
    if known.is_empty() {
        return " none".to_owned();
    }
    format!(": {}", known.join(", "))
}
