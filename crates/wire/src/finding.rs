//! What a detection found out.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use crate::Dialect;

/// Which dialect an arm speaks, and what shows it.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Finding {
    /// The dialect.
    pub dialect: Dialect,
    /// An answer for each question that was put to the arm.
    pub evidence: Vec<Evidence>,
}

/// What an arm did where the dialects disagree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Evidence {
    /// What was asked, with the note that says why.
    pub question: String,
    /// What the statuses told.
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
