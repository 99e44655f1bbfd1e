//! Warnings about differences between a source and its drawing.

use std::collections::HashMap;
use std::fmt;

use crate::place::{Place, place};

/// A difference between a source and its drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
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

impl Warning {
    /// Creates a warning without a place.
    pub(crate) fn new(what: &str, instead: &str, count: usize) -> Self {
        Self {
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
        let plural = if self.count == 1 { "" } else { "s" };
        let Self {
            what,
            instead,
            count,
            ..
        } = self;
        write!(f, "{count} {what}{plural}: {instead}")
    }
}

/// The warnings of a file, each kind once.
#[derive(Debug)]
pub(crate) struct Warnings<'a> {
    text: &'a [u8],
    list: Vec<Warning>,
    numbers: HashMap<String, usize>,
}

impl<'a> Warnings<'a> {
    pub(crate) fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            list: Vec::new(),
            numbers: HashMap::new(),
        }
    }

    /// Counts one more of `what`, which is in the singular.
    pub(crate) fn add(&mut self, at: impl Into<Option<usize>>, what: &str, instead: &str) {
        if let Some(&number) = self.numbers.get(what) {
            self.list[number].count += 1;
            return;
        }
        self.numbers.insert(what.to_owned(), self.list.len());
        self.list.push(Warning {
            place: at.into().map(|at| place(self.text, at)),
            ..Warning::new(what, instead, 1)
        });
    }

    pub(crate) fn into_list(self) -> Vec<Warning> {
        self.list
    }
}
