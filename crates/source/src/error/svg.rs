//! What can be wrong with a drawing, and what is left out of one.

use thiserror::Error;

use crate::error::{Place, Warning};

impl From<usvg::roxmltree::TextPos> for Place {
    fn from(at: usvg::roxmltree::TextPos) -> Self {
        Self {
            line: at.row,
            column: at.col,
        }
    }
}

/// Why an SVG file cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SvgError {
    /// No text at all.
    #[error("the file is empty; an SVG file begins with <svg")]
    EmptyFile,
    /// Not well-formed XML.
    #[error("{place}: not well-formed XML: {problem}")]
    Malformed {
        /// Where reading stopped.
        place: Place,
        /// What the XML parser found.
        problem: String,
    },
    /// XML, but something else.
    #[error("{place}: the outermost element is <{found}>, not <svg>")]
    NotSvg {
        /// Where the element begins.
        place: Place,
        /// Its name.
        found: String,
    },
    /// An attribute that does not read as what it must be. Browsers stop drawing the shape here.
    #[error("{place}: {attribute} of <{element}> holds {found:?}; expected {expected}")]
    BadValue {
        /// Where the value goes wrong.
        place: Place,
        /// The attribute's name.
        attribute: String,
        /// The element's name.
        element: String,
        /// The text from there on, shortened.
        found: String,
        /// What is allowed there.
        expected: &'static str,
    },
    /// Entities are fine as abbreviations; these could fill the memory.
    #[error("{place}: entities that expand to {problem}; save the file without a DOCTYPE")]
    Entities {
        /// Where the first is declared.
        place: Place,
        /// What they would expand to.
        problem: &'static str,
    },
    /// An element that is drawn inside itself.
    #[error("{place}: <{element}> refers back to an element that holds it")]
    Recursive {
        /// Where the element stands.
        place: Place,
        /// Its name.
        element: String,
    },
    /// Elements inside elements inside elements.
    #[error(
        "{place}: elements are nested more than {limit} deep, counting references; ungroup them"
    )]
    TooDeep {
        /// The first element that is too deep.
        place: Place,
        /// How deep is allowed.
        limit: u32,
    },
    /// More elements than a plotter draws in a lifetime, counting each reference as a copy.
    #[error("the drawing has more than {limit} elements, counting copies; simplify it")]
    TooManyElements {
        /// How many are allowed.
        limit: u64,
    },
    /// More line segments than a plotter draws in a lifetime.
    #[error(
        "the drawing has more than {limit} line segments; simplify its paths or allow a larger tolerance"
    )]
    TooManySegments {
        /// How many are allowed.
        limit: u64,
    },
    /// The page has no area, or no size at all.
    #[error("width, height or viewBox of <svg> leave the page without an area")]
    NoPage,
    /// A point beyond any table.
    #[error(
        "a path leads to ({x_mm:.0}, {y_mm:.0}) mm; at most {limit_mm:.0} mm from the page's corner are allowed"
    )]
    TooFar {
        /// To the right of the page's left edge.
        x_mm: f64,
        /// Down from the page's top edge.
        y_mm: f64,
        /// How far is allowed.
        limit_mm: f64,
    },
    /// Text, no font to draw it with, and nothing else.
    #[error(
        "nothing to draw: the file holds only text and no font was found; install a font or convert the text to paths"
    )]
    NoFont,
    /// No visible line on the page.
    #[error("nothing to draw: {reason}")]
    NothingToDraw {
        /// What there is instead.
        reason: String,
    },
    /// The tolerance must be a positive number of millimetres.
    #[error("the tolerance is {found_mm} mm; it must be from {least_mm} mm up")]
    Tolerance {
        /// What was asked for.
        found_mm: f64,
        /// The smallest allowed.
        least_mm: f64,
    },
}

/// What a pen does not show as a browser does, counted by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unshown {
    /// What it is.
    pub(crate) kind: WarningKind,
    /// How many of it.
    pub(crate) count: usize,
}

impl From<Unshown> for Warning {
    fn from(Unshown { kind, count }: Unshown) -> Self {
        let (what, instead) = kind.words();
        Self {
            place: None,
            what: what.to_owned(),
            instead: instead.to_owned(),
            count,
        }
    }
}

/// What a pen cannot draw, or not yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum WarningKind {
    /// A bitmap or another file.
    Image,
    /// A mask.
    Mask,
    /// A filter, such as a blur.
    Filter,
    /// A gradient as paint.
    Gradient,
    /// A pattern as paint.
    Pattern,
    /// A shape filled with white and without a line.
    Paper,
    /// A fill that crosses itself too often to be clipped.
    Entangled,
    /// A piece of text and no font at all.
    TextWithoutFont,
    /// A character that no font has.
    MissingGlyph,
}

impl WarningKind {
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Image => ("image", "left out; trace it to paths to draw it"),
            Self::Mask => ("mask", "ignored, what it hides is drawn"),
            Self::Filter => ("filter", "ignored, the shape is drawn as it is"),
            Self::Gradient => ("gradient", "drawn as one colour, that of its first stop"),
            Self::Pattern => ("pattern", "left out, its area is drawn as one"),
            Self::Paper => ("white shape", "left out, white is the paper"),
            Self::Entangled => (
                "filled shape",
                "not hatched, it crosses itself too often to be clipped",
            ),
            Self::TextWithoutFont => (
                "text",
                "left out, no font was found; install a font or convert it to paths",
            ),
            Self::MissingGlyph => (
                "character",
                "in no font that was found, drawn as the font's box for missing ones",
            ),
        }
    }
}
