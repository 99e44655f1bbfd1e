//! The document of a coordinated program: which arm runs which program.

use std::collections::BTreeSet;

use dobot_api::is_fleet_name;
use serde::Deserialize;

/// A coordinated program, as parsed from its document.
///
/// ```
/// use dobot_fleet::together::Together;
///
/// let it = Together::from_toml(r#"
///     title = "hand over a cube"
///     [[parts]]
///     arm = "desk-1"
///     program = "giver.toml"
///     [[parts]]
///     arm = "desk-2"
///     program = "taker.toml"
/// "#)?;
/// assert_eq!(it.parts[1].arm, "desk-2");
/// # Ok::<(), dobot_fleet::together::DocumentError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Together {
    /// The title.
    pub title: String,
    /// The parts, 2 to 64.
    pub parts: Vec<PartOf>,
}

/// The part of one arm.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartOf {
    /// The arm, by the name of its station in the fleet.
    pub arm: String,
    /// The file of its taught program, beside the document.
    pub program: String,
}

/// The error returned when a document is invalid.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DocumentError {
    /// Invalid TOML or an unknown key.
    #[error("{}{reason}", line.map(|line| format!("line {line}: ")).unwrap_or_default())]
    Toml {
        /// The line, counted from 1.
        line: Option<usize>,
        /// The problem.
        reason: String,
    },
    /// Too few or too many parts.
    #[error(
        "there are {0} parts; allowed are {MIN_PARTS} to {MAX_PARTS}, each as [[parts]] with arm and program"
    )]
    Parts(usize),
    /// An invalid station name.
    #[error(
        "the arm of part {part} is {arm:?}; allowed are 1 to 40 lowercase letters a to z, digits and hyphens, beginning with a letter, as in desk-3"
    )]
    Arm {
        /// The part, counted from 1.
        part: usize,
        /// The invalid name.
        arm: String,
    },
    /// Two parts are for the same arm.
    #[error("two parts are for the arm {0:?}; an arm can have one part: merge the programs")]
    Twice(String),
}

impl Together {
    /// Parses a document.
    ///
    /// # Errors
    ///
    /// [`DocumentError`].
    pub fn from_toml(text: &str) -> Result<Self, DocumentError> {
        let document: Self = toml::from_str(text).map_err(|error| DocumentError::Toml {
            line: error.span().map(|span| line_of(text, span.start)),
            reason: error.message().trim().replace('\n', ", "),
        })?;
        if !(MIN_PARTS..=MAX_PARTS).contains(&document.parts.len()) {
            return Err(DocumentError::Parts(document.parts.len()));
        }
        let mut arms = BTreeSet::new();
        for (index, part) in document.parts.iter().enumerate() {
            let arm = part.arm.clone();
            if !is_fleet_name(&arm) {
                let part = index + 1;
                return Err(DocumentError::Arm { part, arm });
            }
            if !arms.insert(&part.arm) {
                return Err(DocumentError::Twice(arm));
            }
        }
        Ok(document)
    }
}

fn line_of(text: &str, at: usize) -> usize {
    text.bytes().take(at).filter(|byte| *byte == b'\n').count() + 1
}

const MIN_PARTS: usize = 2;
const MAX_PARTS: usize = 64;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn text(arms: &[&str]) -> String {
        let part = |arm: &&str| format!("[[parts]]\narm = {arm:?}\nprogram = \"a.toml\"\n");
        let parts: String = arms.iter().map(part).collect();
        format!("title = \"two\"\n{parts}")
    }

    fn refused(text: &str) -> String {
        Together::from_toml(text).unwrap_err().to_string()
    }

    #[test]
    fn each_arm_has_one_part_and_a_valid_station_name() {
        assert!(Together::from_toml(&text(&["desk-1", "desk-2"])).is_ok());
        assert!(refused(&text(&["desk-1"])).contains("1 parts; allowed are 2 to 64"));
        assert!(
            refused(&text(&["desk-1", "desk-1"])).contains("two parts are for the arm \"desk-1\"")
        );
        assert!(refused(&text(&["desk-1", "Desk 2"])).contains("the arm of part 2 is \"Desk 2\""));
    }

    #[test]
    fn an_error_is_reported_with_its_line() {
        let unknown = format!("{}speed = 9000\n", text(&["desk-1", "desk-2"]));
        let refused = refused(&unknown);
        assert!(
            refused.starts_with("line 8: ") && refused.contains("speed"),
            "{refused}"
        );
    }
}
