//! The error of programs.

use std::collections::BTreeSet;
use std::fmt;

use thiserror::Error;

/// The error returned when a text is not a program or a program cannot be compiled: where, what was
/// found, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}{reason}{}", Location(self), Others(&self.others))]
pub struct ProgramError {
    /// The called program that contains the mistake; `None` for the program itself.
    pub file: Option<String>,
    /// The line, counted from 1, if the mistake has one.
    pub line: Option<usize>,
    /// What is wrong, and what is allowed.
    pub reason: String,
    /// Further mistakes of the same text, in the order of its lines.
    pub others: Vec<Self>,
}

impl ProgramError {
    /// Creates an error without a line.
    #[must_use]
    pub fn new(reason: impl Into<String>) -> Self {
        Self::at(None, reason)
    }

    /// Creates an error on a line of the program itself.
    pub(crate) fn at(line: impl Into<Option<usize>>, reason: impl Into<String>) -> Self {
        Self {
            file: None,
            line: line.into(),
            reason: reason.into(),
            others: Vec::new(),
        }
    }

    /// Merges the mistakes of one text, sorted by line and without repetitions; `None` if there are
    /// none.
    pub(crate) fn merge(mut mistakes: Vec<Self>) -> Option<Self> {
        mistakes.sort_by_key(|mistake| mistake.line);
        let mut known = BTreeSet::new();
        mistakes.retain(|mistake| known.insert((mistake.line, mistake.reason.clone())));
        let mut mistakes = mistakes.into_iter();
        let first = mistakes.next()?;
        Some(Self {
            others: mistakes.collect(),
            ..first
        })
    }

    /// Adds the name of the called program to the error and to its further mistakes.
    pub(crate) fn in_file(self, path: &str) -> Self {
        let others = self.others.into_iter().map(|other| other.in_file(path));
        Self {
            file: Some(path.to_owned()),
            others: others.collect(),
            ..self
        }
    }
}

struct Location<'a>(&'a ProgramError);

impl fmt::Display for Location<'_> {
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

/// The further mistakes, on the same line of output.
struct Others<'a>(&'a [ProgramError]);

impl fmt::Display for Others<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for other in self.0.iter().take(MAX_OTHERS) {
            write!(f, " | {other}")?;
        }
        match self.0.len().saturating_sub(MAX_OTHERS) {
            0 => Ok(()),
            more => write!(f, " | and {more} more"),
        }
    }
}

/// The number of further mistakes that a message lists.
const MAX_OTHERS: usize = 19;
