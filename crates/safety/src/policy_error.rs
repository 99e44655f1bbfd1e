//! Why a text is no policy.

use std::fmt;
use std::ops::Range;

use thiserror::Error;

/// Why a text is no policy: the line, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{}{reason}", At(*.line))]
pub struct PolicyError {
    /// The line of the file, counted from 1; `None` where there is no file or no line.
    pub line: Option<usize>,
    /// What is wrong, and what is allowed.
    pub reason: String,
}

/// A value that is not allowed.
pub(crate) struct InvalidValue {
    /// Its key, with dots.
    pub(crate) key: String,
    /// The value.
    pub(crate) found: String,
    /// What is allowed.
    pub(crate) allowed: String,
}

impl PolicyError {
    /// What the TOML reader found.
    pub(crate) fn toml(text: &str, error: &toml::de::Error) -> Self {
        Self::reader(text, error.span(), error.message())
    }

    /// What a reader found, and where.
    pub(crate) fn reader(text: &str, span: Option<Range<usize>>, message: &str) -> Self {
        Self {
            line: span.map(|span| line_at(text, span.start)),
            reason: message.trim().replace('\n', ", "),
        }
    }

    /// A value that is not allowed.
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

/// The line of a place in a text, counted from 1.
pub(crate) fn line_at(text: &str, offset: usize) -> usize {
    text.get(..offset)
        .map_or(1, |before| before.split('\n').count())
}

struct At(Option<usize>);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |line| write!(f, "line {line}: "))
    }
}
