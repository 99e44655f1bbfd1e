//! Warnings about differences between a source and its drawing.

use std::collections::HashMap;
use std::fmt;

use crate::error::SourceError;
use crate::place::{Place, place};

/// A difference between a source and its drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The kind.
    pub kind: WarningKind,
    /// The file, if several are drawn.
    pub file: Option<String>,
    /// The first place, if known.
    pub place: Option<Place>,
    /// The content, in the singular.
    pub what: String,
    /// What is drawn instead.
    pub instead: String,
    /// The number of occurrences.
    pub count: usize,
}

/// The kind of a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WarningKind {
    /// A statement about how an unambiguous source is read.
    Note,
    /// Something that is drawn differently or left out.
    Difference,
    /// A mistake in the source; what it spoils is left out.
    Mistake,
}

impl Warning {
    /// Creates a warning about a difference, without a place.
    #[must_use]
    pub fn new(what: &str, instead: &str, count: usize) -> Self {
        Self {
            kind: WarningKind::Difference,
            file: None,
            place: None,
            what: what.to_owned(),
            instead: instead.to_owned(),
            count,
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{file}:")?;
            f.write_str(if self.place.is_some() { "" } else { " " })?;
        }
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        let Self {
            what,
            instead,
            count,
            ..
        } = self;
        match (self.kind, *count) {
            (WarningKind::Note, _) | (WarningKind::Mistake, 1) => write!(f, "{what}: {instead}"),
            (WarningKind::Mistake, count) => write!(f, "{what} (first of {count}): {instead}"),
            (WarningKind::Difference, 1) => write!(f, "1 {what}: {instead}"),
            (WarningKind::Difference, count) => write!(f, "{count} {what}s: {instead}"),
        }
    }
}

/// The warnings of a file, each kind once.
#[derive(Debug)]
pub(crate) struct Warnings<'a> {
    text: &'a [u8],
    list: Vec<Warning>,
    numbers: HashMap<String, usize>,
    first_mistake: Option<SourceError>,
    mistakes: usize,
}

impl<'a> Warnings<'a> {
    pub(crate) fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            list: Vec::new(),
            numbers: HashMap::new(),
            first_mistake: None,
            mistakes: 0,
        }
    }

    /// Counts one more of `what`, which is in the singular.
    pub(crate) fn add(&mut self, at: impl Into<Option<usize>>, what: &str, instead: &str) {
        if let Some(&number) = self.numbers.get(what) {
            self.list[number].count += 1;
            return;
        }
        self.push(Warning {
            place: at.into().map(|at| place(self.text, at)),
            ..Warning::new(what, instead, 1)
        });
    }

    /// Adds a statement about how the source is read.
    pub(crate) fn note(&mut self, what: &str, instead: &str) {
        self.push(Warning {
            kind: WarningKind::Note,
            ..Warning::new(what, instead, 1)
        });
    }

    /// Reports a mistake in the source, for which the drawing lacks what `instead` states. Returns
    /// other errors, and a mistake after too many of them.
    pub(crate) fn add_mistake(
        &mut self,
        error: SourceError,
        instead: &str,
    ) -> Result<(), SourceError> {
        let Some((place, mut what)) = error.mistake().filter(|_| self.mistakes < MAX_MISTAKES)
        else {
            return Err(error);
        };
        self.mistakes += 1;
        self.first_mistake.get_or_insert(error);
        if !self.numbers.contains_key(&what) && self.mistakes > MAX_SHOWN_MISTAKES {
            FURTHER.clone_into(&mut what);
        }
        if let Some(&number) = self.numbers.get(&what) {
            self.list[number].count += 1;
            return Ok(());
        }
        self.push(Warning {
            kind: WarningKind::Mistake,
            place: Some(place),
            ..Warning::new(&what, instead, 1)
        });
        Ok(())
    }

    fn push(&mut self, warning: Warning) {
        self.numbers.insert(warning.what.clone(), self.list.len());
        self.list.push(warning);
    }

    /// The first mistake, as an error.
    pub(crate) const fn take_mistake(&mut self) -> Option<SourceError> {
        self.first_mistake.take()
    }

    pub(crate) fn into_list(self) -> Vec<Warning> {
        self.list
    }
}

/// A source with more mistakes is refused.
pub(crate) const MAX_MISTAKES: usize = 1000;
/// After this many, new ones are only counted.
const MAX_SHOWN_MISTAKES: usize = 20;
const FURTHER: &str = "further mistakes";
