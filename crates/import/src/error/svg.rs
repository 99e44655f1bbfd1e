//! Errors of SVG files.

use dobot_geometry::Cancelled;
use thiserror::Error;

use crate::place::Place;

/// The error returned when an SVG file cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SvgError {
    /// The file is empty.
    #[error("the file is empty; an SVG file begins with <svg")]
    EmptyFile,
    /// The file is not well-formed XML.
    #[error("{place}: not well-formed XML: {problem}")]
    Malformed {
        /// The place at which reading stopped.
        place: Place,
        /// The message of the XML parser.
        problem: String,
    },
    /// The XML is truncated, as after an interrupted download.
    #[error(
        "{place}: not well-formed XML: the file ends too soon: {part} starts here and is not closed"
    )]
    EndsTooSoon {
        /// The start of the innermost unclosed part.
        place: Place,
        /// The part: an element, as far as its name is complete, or a comment.
        part: String,
    },
    /// The file is XML, but not SVG.
    #[error("{place}: the outermost element is <{found}>; it must be <svg>")]
    NotSvg {
        /// The start of the outermost element.
        place: Place,
        /// Its name.
        found: String,
    },
    /// Entities expand to too much text.
    #[error("{place}: entities that expand to {problem}; save the file without a DOCTYPE")]
    Entities {
        /// The first declaration.
        place: Place,
        /// What they expand to.
        problem: &'static str,
    },
    /// An element is drawn inside itself.
    #[error("{place}: <{element}> refers to an element that contains it")]
    Recursive {
        /// The place of the element.
        place: Place,
        /// Its name.
        element: String,
    },
    /// Elements are nested too deep.
    #[error(
        "{place}: elements are nested more than {limit} deep, including references; ungroup them"
    )]
    TooDeep {
        /// The first element that is too deep.
        place: Place,
        /// The largest depth allowed.
        limit: u32,
    },
    /// The drawing has too many elements, counting each reference as a copy.
    #[error(
        "the drawing has more than {limit} elements, including copies; combine its paths, or draw it in parts"
    )]
    TooManyElements {
        /// The largest number allowed.
        limit: u64,
    },
    /// The drawing has too many elements and groups.
    #[error(
        "the drawing has more than {limit} elements, including copies and counting those twice that have a transform, an opacity, a clip path, a mask or a filter; combine its paths, or draw it in parts"
    )]
    TooManyGroups {
        /// The largest number allowed.
        limit: u64,
    },
    /// The styles take too long to read.
    #[error(
        "the styles (CSS) take too long to read; use fewer rules, or save the file as plain SVG"
    )]
    LongStyles,
    /// The drawing has too many line segments.
    #[error(
        "the drawing has more than {limit} line segments; simplify its paths or allow a larger tolerance"
    )]
    TooManySegments {
        /// The largest number allowed.
        limit: u64,
    },
    /// The drawing has too many line segments, which no tolerance reduces.
    #[error(
        "the drawing has more than {limit} line segments; simplify its paths, or draw it in parts"
    )]
    TooManyCorners {
        /// The largest number allowed.
        limit: u64,
    },
    /// Clip paths take too long.
    #[error(
        "clipping lines and areas takes too long; simplify the clip paths, or draw it in parts"
    )]
    TooManyCuts,
    /// Reading was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The page has no area or no size.
    #[error("the page has no area; set width, height or viewBox of <svg> above 0")]
    NoPage,
    /// A point is too far from the page.
    #[error(
        "a path leads to ({x_mm:.0}, {y_mm:.0}) mm; at most {limit_mm:.0} mm from the page's corner are allowed"
    )]
    TooFar {
        /// The distance to the right of the page's left edge.
        x_mm: f64,
        /// The distance down from the page's top edge.
        y_mm: f64,
        /// The largest distance allowed.
        limit_mm: f64,
    },
    /// The file contains only text, and no font is installed.
    #[error(
        "nothing to draw: the file holds only text and no font was found; install a font or convert the text to paths"
    )]
    NoFont,
    /// The tolerance is not a positive number of millimetres, or too small.
    #[error("the tolerance is {found_mm} mm; allowed are {least_mm} mm or more")]
    Tolerance {
        /// The requested tolerance.
        found_mm: f64,
        /// The smallest allowed.
        least_mm: f64,
    },
}
