//! The result of a dialect detection.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use crate::Dialect;

/// The dialect of an arm, with the evidence.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Finding {
    /// The dialect.
    pub dialect: Dialect,
    /// An answer for each question that was put to the arm.
    pub evidence: Vec<Evidence>,
}

/// The behavior of an arm where the dialects differ.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Evidence {
    /// The question, with its note.
    pub question: String,
    /// The observation in the statuses.
    pub saw: String,
    /// The dialect of an arm that does so.
    pub means: Dialect,
}

impl Finding {
    /// The evidence, a line for each question.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        self.evidence.iter().map(ToString::to_string).collect()
    }
}

impl fmt::Display for Evidence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {}", self.question, self.saw, self.means)
    }
}
