//! What can be wrong with a text.

use thiserror::Error;

/// Why a text cannot be written.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TextError {
    /// Letters of no size, or larger than any table.
    #[error("the letter height is {found_mm} mm; allowed are 0.1 to 1000 mm")]
    Height {
        /// What was asked for.
        found_mm: f64,
    },
    /// Lines upon each other, or far apart.
    #[error("the line spacing is {found} letter heights; allowed are 0.5 to 10")]
    LineSpacing {
        /// What was asked for.
        found: f64,
    },
    /// More than the arm writes in days.
    #[error("the text has {characters} characters; allowed are {limit}; write it in parts")]
    TooLong {
        /// How many there are.
        characters: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// No such font.
    #[error("there is no font {family:?}; {}", known(nearest))]
    UnknownFont {
        /// What was asked for.
        family: String,
        /// What the fonts are called whose names are most like it.
        nearest: Vec<String>,
    },
}

fn known(nearest: &[String]) -> String {
    if nearest.is_empty() {
        let fonts = "sans, bold, script, serif, italic and gothic";
        return format!("no fonts are installed; {fonts} are built in");
    }
    format!("similar ones are {}", nearest.join(", "))
}
