//! What is wrong with a file of materials, or with a name.

use std::fmt;

use thiserror::Error;

use super::read::nearest;

/// Why a text is no file of materials.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MaterialError {
    /// It is not TOML.
    #[error("line {line}: {reason}")]
    Toml {
        /// The line, counted from 1.
        line: usize,
        /// What the TOML reader found.
        reason: String,
    },
    /// A key that nobody knows.
    #[error("line {line}: {key} is unknown; {}allowed are: {}", Meant(.key, .allowed), .allowed.join(", "))]
    UnknownKey {
        /// The line, counted from 1.
        line: usize,
        /// The key, with dots.
        key: String,
        /// The keys that are known there.
        allowed: Vec<&'static str>,
    },
    /// A value that is not allowed.
    #[error("line {line}: {key} is {found}; allowed is {allowed}")]
    Value {
        /// The line, counted from 1.
        line: usize,
        /// The key, with dots.
        key: String,
        /// What the file says.
        found: String,
        /// What it may say.
        allowed: String,
    },
    /// A key that has to be there.
    #[error("line {line}: {key} is missing; allowed is {allowed}")]
    Missing {
        /// The line of the material, counted from 1.
        line: usize,
        /// The key, with dots.
        key: String,
        /// What it may say.
        allowed: String,
    },
}

/// There is no material of that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no material '{name}'; {}there are{}", MeantName(.name, .known), Names(.known))]
pub struct UnknownMaterial {
    /// The name.
    pub name: String,
    /// The names that there are.
    pub known: Vec<String>,
}

struct Meant<'a>(&'a str, &'a [&'static str]);

impl fmt::Display for Meant<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let key = self.0.rsplit('.').next().unwrap_or(self.0);
        match nearest(key, self.1.iter().copied()) {
            Some(meant) => write!(f, "did you mean {meant}? "),
            None => Ok(()),
        }
    }
}

struct MeantName<'a>(&'a str, &'a [String]);

impl fmt::Display for MeantName<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match nearest(self.0, self.1.iter().map(String::as_str)) {
            Some(meant) => write!(f, "did you mean '{meant}'? "),
            None => Ok(()),
        }
    }
}

struct Names<'a>(&'a [String]);

impl fmt::Display for Names<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return f.write_str(" none");
        }
        write!(f, ": {}", self.0.join(", "))
    }
}
