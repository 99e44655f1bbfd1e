//! Errors of texts.

use thiserror::Error;

/// The error returned when a text cannot be written.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TextError {
    /// The letter height is out of range.
    #[error("the letter height is {found_mm} mm; allowed are 0.1 to 1000 mm")]
    Height {
        /// The requested height.
        found_mm: f64,
    },
    /// The line spacing is out of range.
    #[error("the line spacing is {found} letter heights; allowed are 0.5 to 10")]
    LineSpacing {
        /// The requested spacing.
        found: f64,
    },
    /// The width at which lines are wrapped is out of range.
    #[error("lines are wrapped at {found_mm} mm; allowed are 1 to 10000 mm")]
    Width {
        /// The requested width.
        found_mm: f64,
    },
    /// An SVG font cannot be read.
    #[error("what.font is an SVG font that cannot be used: {what}")]
    FontFile {
        /// What is wrong with it.
        what: String,
    },
    /// The text is too long.
    #[error("the text has {characters} characters; allowed are {limit}; write it in parts")]
    TooLong {
        /// The number of characters.
        characters: usize,
        /// The largest number allowed.
        limit: usize,
    },
    /// There is no such font.
    #[error("there is no font {family:?}; {}", known(nearest))]
    UnknownFont {
        /// The requested font.
        family: String,
        /// The most similar font names.
        nearest: Vec<String>,
    },
}

fn known(nearest: &[String]) -> String {
    if nearest.is_empty() {
        let fonts = "sans, bold, script, serif, italic, gothic and hand";
        return format!("no fonts are installed; {fonts} are built in");
    }
    format!("similar ones are {}", nearest.join(", "))
}
