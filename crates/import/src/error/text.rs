//! What can be wrong with a text.

use thiserror::Error;

/// Why a text cannot be written.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TextError {
    /// Letters of no size, or larger than any table.
    #[error("the letters are {found_mm} mm tall; allowed are 0.1 to 1000 mm")]
    Height {
        /// What was asked for.
        found_mm: f64,
    },
    /// Lines upon each other, or far apart.
    #[error("the lines are {found} heights apart; allowed are 0.5 to 10")]
    LineSpacing {
        /// What was asked for.
        found: f64,
    },
    /// More than the arm writes in days.
    #[error("the text has {characters} characters; at most {limit} are allowed, write it in parts")]
    TooLong {
        /// How many there are.
        characters: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// No such font.
    #[error("no font is called {family:?}; {}", known(nearest))]
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
        return format!("no font was found at all; {fonts} are built in");
    }
    format!("the most similar ones are {}", nearest.join(", "))
}
