//! What can be wrong with an SVG file.

use thiserror::Error;

use crate::place::Place;

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
    /// XML of which the end is missing, as after a broken download.
    #[error(
        "{place}: not well-formed XML: the file ends too soon: {part} starts here and is not closed"
    )]
    EndsTooSoon {
        /// Where the innermost part begins that is not closed.
        place: Place,
        /// What it is: an element, as far as its name is there, or a comment.
        part: String,
    },
    /// XML, but something else.
    #[error("{place}: the outermost element is <{found}>; it must be <svg>")]
    NotSvg {
        /// Where the element begins.
        place: Place,
        /// Its name.
        found: String,
    },
    /// An attribute that does not read as what it must be. Browsers stop drawing the shape here.
    #[error("{place}: {attribute} of <{element}> {found}; expected {expected}")]
    BadValue {
        /// Where the value goes wrong.
        place: Place,
        /// The attribute's name.
        attribute: String,
        /// The element's name.
        element: String,
        /// The text that it holds from there on, shortened, or behind which it ends.
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
    #[error("{place}: <{element}> refers to an element that contains it")]
    Recursive {
        /// Where the element stands.
        place: Place,
        /// Its name.
        element: String,
    },
    /// Elements inside elements inside elements.
    #[error(
        "{place}: elements are nested more than {limit} deep, including references; ungroup them"
    )]
    TooDeep {
        /// The first element that is too deep.
        place: Place,
        /// How deep is allowed.
        limit: u32,
    },
    /// More elements than a plotter draws in a lifetime, counting each reference as a copy.
    #[error(
        "the drawing has more than {limit} elements, including copies; combine its paths, or draw it in parts"
    )]
    TooManyElements {
        /// How many are allowed.
        limit: u64,
    },
    /// More elements, and groups that they become, than there is room for.
    #[error(
        "the drawing has more than {limit} elements, including copies and counting those twice that have a transform, an opacity, a clip path, a mask or a filter; combine its paths, or draw it in parts"
    )]
    TooManyGroups {
        /// How many are allowed.
        limit: u64,
    },
    /// Styles that take for ever to read.
    #[error(
        "the styles (CSS) of the elements take too long to read, including copies; save the file as plain SVG, without long style attributes"
    )]
    LongStyles,
    /// More line segments than a plotter draws in a lifetime.
    #[error(
        "the drawing has more than {limit} line segments; simplify its paths or allow a larger tolerance"
    )]
    TooManySegments {
        /// How many are allowed.
        limit: u64,
    },
    /// The same where no tolerance makes them fewer.
    #[error(
        "the drawing has more than {limit} line segments; simplify its paths, or draw it in parts"
    )]
    TooManyCorners {
        /// How many are allowed.
        limit: u64,
    },
    /// Clip paths that cut so often that it takes for ever.
    #[error(
        "clipping lines and areas takes too long; simplify the clip paths, or draw it in parts"
    )]
    TooManyCuts,
    /// The page has no area, or no size at all.
    #[error("the page has no area; set width, height or viewBox of <svg> above 0")]
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
    /// The tolerance must be a positive number of millimetres.
    #[error("the tolerance is {found_mm} mm; allowed are {least_mm} mm or more")]
    Tolerance {
        /// What was asked for.
        found_mm: f64,
        /// The smallest allowed.
        least_mm: f64,
    },
}
