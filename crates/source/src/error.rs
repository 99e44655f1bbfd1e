//! What can be wrong with a source, and what is drawn otherwise than it says.

use std::fmt;

use thiserror::Error;

use crate::picture::ImageError;
use crate::svg::SvgError;
use crate::text::TextError;

/// A place in a text file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// From 1.
    pub line: u32,
    /// In characters, from 1.
    pub column: u32,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// Why a source cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SourceError {
    /// Neither name nor contents tell what it is.
    #[error(
        "{name:?} is of no kind that can be drawn; known are .svg, .png, .jpg, .gcode, .plt, .dxf, .csv and .json files"
    )]
    UnknownKind {
        /// The file's name.
        name: String,
    },
    /// A text file that holds something else.
    #[error("line {line}: not UTF-8 text; save the file as UTF-8")]
    NotText {
        /// From 1.
        line: usize,
    },
    /// An SVG file that cannot be drawn.
    #[error(transparent)]
    Svg(#[from] SvgError),
    /// A picture that cannot be drawn.
    #[error(transparent)]
    Picture(#[from] ImageError),
    /// A text that cannot be written.
    #[error(transparent)]
    Text(#[from] TextError),
    /// A text file that goes wrong somewhere.
    #[error("{place}: found {found}; expected {expected}")]
    Found {
        /// Where.
        place: Place,
        /// What stands there, shortened.
        found: String,
        /// What is allowed there.
        expected: String,
    },
    /// Nothing that leaves ink.
    #[error("nothing to draw: {reason}")]
    NothingToDraw {
        /// What there is instead.
        reason: String,
    },
    /// More layers than anybody changes pens.
    #[error("the drawing has more than {limit} layers (pens, or speeds and powers of a laser)")]
    TooManyLayers {
        /// How many are allowed.
        limit: usize,
    },
    /// More line segments than a plotter draws in a lifetime.
    #[error(
        "the drawing has more than {limit} line segments; simplify it or allow a larger tolerance"
    )]
    TooManySegments {
        /// How many are allowed.
        limit: usize,
    },
    /// A point beyond any table.
    #[error(
        "{place}: leads to ({x_mm:.0}, {y_mm:.0}) mm; at most {limit_mm:.0} mm from the origin are allowed"
    )]
    TooFar {
        /// Where it is said.
        place: Place,
        /// To the right.
        x_mm: f64,
        /// Down.
        y_mm: f64,
        /// How far is allowed.
        limit_mm: f64,
    },
}

/// Something in a source that is drawn otherwise than it says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Where it is found first, where that is known.
    pub place: Option<Place>,
    /// What it is, in the singular.
    pub what: String,
    /// What is drawn instead.
    pub instead: String,
    /// How many of it.
    pub count: usize,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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

/// A text from a file as it may stand in a message: on one line, and without what would steer a
/// terminal.
pub(crate) fn printable(text: &str) -> String {
    let mut printable = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_control() {
            printable.extend(character.escape_debug());
        } else {
            printable.push(character);
        }
    }
    printable
}

/// No drawing is larger than that many line segments: the arm takes two days for it.
pub(crate) const MAX_SEGMENTS: usize = 2_000_000;
/// No drawing leads farther than that, in mm.
pub(crate) const LIMIT_MM: f64 = 1_000_000.0;
