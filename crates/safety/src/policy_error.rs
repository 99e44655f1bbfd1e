//! The error for an invalid policy.

use std::fmt;
use std::ops::Range;

use thiserror::Error;

use crate::text_lines::line_at;

/// The error returned for an invalid policy: the line, what was found and what is allowed.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}{reason}", At(*.line))]
pub struct PolicyError {
    /// The line of the file, counted from 1; `None` without a file or line.
    pub line: Option<usize>,
    /// What is wrong, and what is allowed.
    pub reason: String,
}

/// A value that is not allowed.
pub(crate) struct InvalidValue {
    /// The dotted key.
    pub(crate) key: String,
    /// The value found.
    pub(crate) found: String,
    /// The values allowed.
    pub(crate) allowed: String,
}

impl PolicyError {
    /// Converts an error of the TOML reader.
    pub(crate) fn toml(text: &str, error: &toml::de::Error) -> Self {
        Self::reader(text, error.span(), error.message())
    }

    /// Converts an error of a reader with its position.
    pub(crate) fn reader(text: &str, span: Option<Range<usize>>, message: &str) -> Self {
        Self {
            line: span.map(|span| line_at(text, span.start)),
            reason: message.trim().replace('\n', ", "),
        }
    }

    /// Builds the error for a value that is not allowed.
    pub(crate) fn value(line: Option<usize>, problem: InvalidValue) -> Self {
        let InvalidValue {
            key,
            found,
            allowed,
        } = problem;
        Self {
            line,
            reason: format!("{key} is {found}; a policy allows {allowed}"),
        }
    }
}

struct At(Option<usize>);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |line| write!(f, "line {line}: "))
    }
}
