//! Why a text is no program, or a program cannot be made into commands.

use std::fmt;

use thiserror::Error;

/// Why a text is no program, or a program cannot be made into commands: where, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}{reason}", At(self))]
pub struct ProgramError {
    /// The called program in which it is; `None` in the program itself.
    pub file: Option<String>,
    /// The line, counted from 1, where there is one.
    pub line: Option<usize>,
    /// What is wrong, and what is allowed.
    pub reason: String,
}

impl ProgramError {
    /// Something that is wrong with the program itself, on no line of its own.
    #[must_use]
    pub fn new(reason: impl Into<String>) -> Self {
        Self {
            file: None,
            line: None,
            reason: reason.into(),
        }
    }
}

struct At<'a>(&'a ProgramError);

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.0.file {
            write!(f, "{file}: ")?;
        }
        match self.0.line {
            Some(line) => write!(f, "line {line}: "),
            None => Ok(()),
        }
    }
}
