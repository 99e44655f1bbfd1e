//! What is wrong with a file of materials, or with a name.

use thiserror::Error;

use super::read::nearest;

/// Why a file of materials cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("line {line}: {reason}")]
pub struct MaterialError {
    /// The line, counted from 1.
    pub line: usize,
    /// The key with what was found and what is allowed, or what the TOML reader says.
    pub reason: String,
}

/// There is no material of that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no material '{name}'; {}there are{}", meant(.name, .known), listed(.known))]
pub struct UnknownMaterial {
    /// The name.
    pub name: String,
    /// The names that there are.
    pub known: Vec<String>,
}

fn meant(name: &str, known: &[String]) -> String {
    let nearest = nearest(name, known.iter().map(String::as_str));
    nearest.map_or_else(String::new, |it| format!("did you mean '{it}'? "))
}

fn listed(known: &[String]) -> String {
    if known.is_empty() {
        return " none".to_owned();
    }
    format!(": {}", known.join(", "))
}
