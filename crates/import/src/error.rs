//! What can be wrong with a source.

mod picture;
mod svg;
mod text;

use thiserror::Error;

pub use self::picture::ImageError;
pub use self::svg::SvgError;
pub use self::text::TextError;
use crate::formats::extensions;
use crate::place::{Place, excerpt, place};

/// Why a source cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SourceError {
    /// A calculated point is beyond any table, or no number.
    #[error("point {point} of line {line} is ({}, {}); allowed are numbers from -1000000 to 1000000 (mm)", found.0, found.1)]
    Point {
        /// The line, counted from 1.
        line: usize,
        /// The point in it, counted from 1.
        point: usize,
        /// Its x and y.
        found: (f64, f64),
    },
    /// Neither name nor contents tell what it is.
    #[error(
        "{name:?} is not a supported file; supported are {} files",
        extensions()
    )]
    UnknownKind {
        /// The file's name.
        name: String,
    },
    /// A packed file that cannot be unpacked.
    #[error("cannot unpack the file (gzip): {problem}; copy or download it again")]
    Packed {
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A file of more bytes than a drawing has, unpacked.
    #[error(
        "the file has more than {} MB, and its format may have {} MB; draw it in parts, or remove detail that no pen can show",
        most / 1_000_000,
        most / 1_000_000
    )]
    TooLarge {
        /// How many bytes are allowed.
        most: u64,
    },
    /// A file that other programs make a drawing of.
    #[error("found {what}, which is not supported; {way}")]
    Foreign {
        /// What it is.
        what: &'static str,
        /// What makes a drawing of it.
        way: &'static str,
    },
    /// A text file that holds something else.
    #[error("line {line}: not UTF-8 text; save the file as UTF-8")]
    NotText {
        /// From 1.
        line: usize,
    },
    /// A text in an encoding that cannot be read.
    #[error("the file declares the encoding {name:?}, {problem}; save it as UTF-8")]
    Encoding {
        /// The encoding.
        name: String,
        /// What is wrong with it.
        problem: &'static str,
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
    /// The same of straight lines, which no tolerance makes fewer.
    #[error(
        "the drawing has more than {limit} line segments, most of them straight; simplify it, or draw it in parts"
    )]
    TooManyCorners {
        /// How many are allowed.
        limit: usize,
    },
    /// Outlines that cut so often that it takes for ever.
    #[error(
        "clipping lines and areas takes too long; simplify clip paths and hatched areas, or draw it in parts"
    )]
    TooManyCuts,
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

impl SourceError {
    /// Whether it has more line segments than fit, which a larger tolerance may mend.
    #[must_use]
    pub const fn is_too_fine(&self) -> bool {
        matches!(
            self,
            Self::TooManySegments { .. } | Self::Svg(SvgError::TooManySegments { .. })
        )
    }

    /// Tells what was found at an offset of a text.
    pub(crate) fn found(
        text: &[u8],
        at: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self::Found {
            place: place(text, at),
            found: found.into(),
            expected: expected.into(),
        }
    }

    /// Tells what stands in a text from an offset on.
    pub(crate) fn unexpected(text: &[u8], at: usize, expected: &str) -> Self {
        Self::found(text, at, excerpt(text, at), expected)
    }

    pub(crate) fn nothing_to_draw(reasons: impl IntoIterator<Item = String>) -> Self {
        let reasons: Vec<String> = reasons.into_iter().collect();
        Self::NothingToDraw {
            reason: reasons.join("; "),
        }
    }
}
