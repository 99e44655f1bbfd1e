//! Entities: lists of groups.

use dobot_geometry::Point;

use super::file::Span;
use super::pairs::{Pair, pairs};
use crate::error::SourceError;

/// An entity without the groups that repeat it for newer programs.
#[derive(Debug)]
pub(super) struct Entity<'a> {
    pub(super) text: &'a [u8],
    pub(super) kind: &'a [u8],
    pub(super) at: usize,
    pub(super) pairs: Vec<Pair<'a>>,
}

impl<'a> Entity<'a> {
    pub(super) fn read(text: &'a [u8], span: Span<'a>) -> Result<Self, SourceError> {
        let within = &text[..span.end];
        Ok(Self {
            text,
            kind: span.kind,
            at: span.at,
            pairs: own_pairs(within, span.begin)?,
        })
    }

    /// Returns the entity with other groups.
    pub(super) fn with(&self, pairs: Vec<Pair<'a>>) -> Self {
        Self { pairs, ..*self }
    }

    pub(super) fn name(&self) -> String {
        String::from_utf8_lossy(self.kind).into_owned()
    }

    pub(super) fn find(&self, code: i32) -> Option<&Pair<'a>> {
        self.pairs.iter().find(|pair| pair.code == code)
    }

    /// A required number.
    pub(super) fn number(&self, code: i32) -> Result<f64, SourceError> {
        let missing = || self.refused(format!("{} without group {code}", self.name()), "a number");
        self.find(code).ok_or_else(missing)?.number()
    }

    pub(super) fn number_or(&self, code: i32, default: f64) -> Result<f64, SourceError> {
        self.find(code).map_or(Ok(default), Pair::number)
    }

    /// -1 for an entity seen from behind, else 1.
    pub(super) fn side(&self) -> Result<f64, SourceError> {
        let is_behind = self.number_or(230, 1.0)? < 0.0;
        Ok(if is_behind { -1.0 } else { 1.0 })
    }

    /// The bits of a group of flags.
    pub(super) fn flags(&self, code: i32) -> Result<u32, SourceError> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few bits; saturates"
        )]
        Ok(self.number_or(code, 0.0)? as u32)
    }

    /// A point whose x has this code; its y has a code ten higher.
    pub(super) fn point(&self, code: i32) -> Result<Point, SourceError> {
        Ok(Point::new(self.number(code)?, self.number(code + 10)?))
    }

    /// A spatial vector whose x has this code; other missing coordinates are 0.
    pub(super) fn way(&self, code: i32) -> Result<[f64; 3], SourceError> {
        let [y, z] = [10, 20].map(|more| self.number_or(code + more, 0.0));
        Ok([self.number(code)?, y?, z?])
    }

    /// All values of a group.
    pub(super) fn numbers(&self, code: i32) -> Result<Vec<f64>, SourceError> {
        let pairs = self.pairs.iter().filter(|pair| pair.code == code);
        pairs.map(Pair::number).collect()
    }

    /// All points whose x has this code.
    pub(super) fn points(&self, code: i32) -> Result<Vec<Point>, SourceError> {
        let (x, y) = (self.numbers(code)?, self.numbers(code + 10)?);
        if x.len() != y.len() {
            let found = format!("{} x and {} y coordinates", x.len(), y.len());
            return Err(self.refused(found, "points"));
        }
        Ok(x.into_iter()
            .zip(y)
            .map(|(x, y)| Point::new(x, y))
            .collect())
    }

    pub(super) fn refused(&self, found: impl Into<String>, expected: &str) -> SourceError {
        SourceError::found(self.text, self.at, found, expected)
    }
}

fn own_pairs(text: &[u8], from: usize) -> Result<Vec<Pair<'_>>, SourceError> {
    let is_own = |result: &Result<Pair<'_>, _>| {
        result
            .as_ref()
            .map_or(true, |result| result.code != EMBEDDED)
    };
    let mut own = Vec::new();
    for pair in pairs(text, from).take_while(is_own) {
        let pair = pair?;
        if own.len() == MAX_PAIRS {
            let found = format!("an entity with more than {MAX_PAIRS} groups");
            let expected = "fewer; simplify it, or draw it in parts";
            return Err(SourceError::found(text, pair.at, found, expected));
        }
        own.push(pair);
    }
    Ok(own)
}

/// The limit protects the memory: an outline of half a million corners has a million groups.
const MAX_PAIRS: usize = 1_000_000;

/// The groups after it repeat the entity for newer programs.
const EMBEDDED: i32 = 101;
