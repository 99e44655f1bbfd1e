//! Errors of sources.

mod picture;
mod svg;
mod text;

use dobot_geometry::Cancelled;
use thiserror::Error;

pub use self::picture::ImageError;
pub use self::svg::SvgError;
pub use self::text::TextError;
use crate::formats::extensions;
use crate::place::{Place, excerpt, place};

/// The error returned when a source cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SourceError {
    /// A calculated point is out of range or not a number.
    #[error("point {point} of line {line} is ({}, {}); allowed are numbers from -1000000 to 1000000 (mm)", found.0, found.1)]
    Point {
        /// The line, counted from 1.
        line: usize,
        /// The point in it, counted from 1.
        point: usize,
        /// Its x and y.
        found: (f64, f64),
    },
    /// Neither the name nor the content identifies the format.
    #[error(
        "{name:?} is not a supported file; supported are {} files",
        extensions()
    )]
    UnknownKind {
        /// The file name.
        name: String,
    },
    /// A gzip file cannot be unpacked.
    #[error("cannot unpack the file (gzip): {problem}; copy or download it again")]
    Packed {
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A file has too many bytes, after unpacking.
    #[error(
        "the file has more than {} MB, and its format may have {} MB; draw it in parts, or remove detail that no pen can show",
        most / 1_000_000,
        most / 1_000_000
    )]
    TooLarge {
        /// The largest number of bytes allowed.
        most: u64,
    },
    /// A file needs conversion by another program.
    #[error("found {what}, which is not supported; {way}")]
    Foreign {
        /// The kind of file.
        what: &'static str,
        /// How to convert it.
        way: &'static str,
    },
    /// A text file is not text.
    #[error("line {line}: not UTF-8 text; save the file as UTF-8")]
    NotText {
        /// The line, counted from 1.
        line: usize,
    },
    /// A text is in an encoding that cannot be read.
    #[error("the file declares the encoding {name:?}, {problem}; save it as UTF-8")]
    Encoding {
        /// The encoding.
        name: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// An SVG file cannot be drawn.
    #[error(transparent)]
    Svg(#[from] SvgError),
    /// A picture cannot be drawn.
    #[error(transparent)]
    Picture(#[from] ImageError),
    /// A text cannot be written.
    #[error(transparent)]
    Text(#[from] TextError),
    /// A text file contains a mistake.
    #[error("{place}: found {found}; expected {expected}")]
    Found {
        /// The place.
        place: Place,
        /// The text at the place, shortened.
        found: String,
        /// What is allowed there.
        expected: String,
    },
    /// A source exceeds a limit that protects memory and time.
    #[error("{place}: found {found}; expected {expected}")]
    Limit {
        /// The place.
        place: Place,
        /// What exceeds it.
        found: String,
        /// What is allowed.
        expected: String,
    },
    /// A source contains a mistake, and only sources without any are allowed
    /// ([`ReadOptions::strict`](crate::ReadOptions::strict)).
    #[error("{place}: {what}")]
    Mistake {
        /// The place of the first one.
        place: Place,
        /// What was found and what is allowed.
        what: String,
    },
    /// The source leaves no ink.
    #[error("nothing to draw: {reason}")]
    NothingToDraw {
        /// The reason.
        reason: String,
    },
    /// The drawing has too many layers.
    #[error("the drawing has more than {limit} layers (pens, or speeds and powers of a laser)")]
    TooManyLayers {
        /// The largest number allowed.
        limit: usize,
    },
    /// The drawing has too many line segments.
    #[error(
        "the drawing has more than {limit} line segments; simplify it or allow a larger tolerance"
    )]
    TooManySegments {
        /// The largest number allowed.
        limit: usize,
    },
    /// The drawing has too many straight line segments, which no tolerance reduces.
    #[error(
        "the drawing has more than {limit} line segments, most of them straight; simplify it, or draw it in parts"
    )]
    TooManyCorners {
        /// The largest number allowed.
        limit: usize,
    },
    /// Clipping outlines takes too long.
    #[error(
        "clipping lines and areas takes too long; simplify clip paths and hatched areas, or draw it in parts"
    )]
    TooManyCuts,
    /// Reading was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A point is too far from the origin.
    #[error(
        "{place}: leads to ({x_mm:.0}, {y_mm:.0}) mm; at most {limit_mm:.0} mm from the origin are allowed"
    )]
    TooFar {
        /// The place.
        place: Place,
        /// The x coordinate, to the right.
        x_mm: f64,
        /// The y coordinate, down.
        y_mm: f64,
        /// The largest distance allowed.
        limit_mm: f64,
    },
}

impl SourceError {
    /// Whether it has too many line segments, which a larger tolerance may reduce.
    #[must_use]
    pub const fn is_too_fine(&self) -> bool {
        matches!(
            self,
            Self::TooManySegments { .. } | Self::Svg(SvgError::TooManySegments { .. })
        )
    }

    /// The place and the text of a mistake in a source, which spoils only a part of it.
    pub(crate) fn mistake(&self) -> Option<(Place, String)> {
        let message = self.to_string();
        match self {
            Self::Found { place, .. }
            | Self::TooFar { place, .. }
            | Self::Svg(SvgError::Malformed { place, .. } | SvgError::EndsTooSoon { place, .. }) => {
                let text = message.strip_prefix(&format!("{place}: "));
                Some((*place, text.unwrap_or(&message).to_owned()))
            }
            _ => None,
        }
    }

    /// Whether reading was cancelled.
    #[must_use]
    pub const fn is_cancelled(&self) -> bool {
        matches!(self, Self::Cancelled(_) | Self::Svg(SvgError::Cancelled(_)))
    }

    /// An error about the text at an offset.
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

    /// An error about a limit exceeded at an offset.
    pub(crate) fn limit(
        text: &[u8],
        at: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self::Limit {
            place: place(text, at),
            found: found.into(),
            expected: expected.into(),
        }
    }

    /// An error about unexpected text at an offset.
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
