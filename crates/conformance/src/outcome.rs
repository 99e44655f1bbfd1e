//! The outcome of a check.

use std::fmt;

/// What came of a check, with what was found, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It is as the protocol says, in every dialect.
    Holds(String),
    /// It is as the published document says, and stock arms do not do it: a vote for that dialect.
    Specification(String),
    /// It is as stock arms do, and the published document says otherwise: a vote for that dialect.
    Firmware11(String),
    /// It is like neither.
    Differs(String),
    /// It was not the same each time that it was tried, or something got lost on the way: more is
    /// said of the line by it than of the controller.
    Unsteady(String),
    /// It was not tried, and why.
    NotTried(String),
}

impl Outcome {
    /// One or two words for a table.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Holds(_) => "holds",
            Self::Specification(_) => "specification",
            Self::Firmware11(_) => "firmware-1.1",
            Self::Differs(_) => "DIFFERS",
            Self::Unsteady(_) => "unsteady",
            Self::NotTried(_) => "not tried",
        }
    }

    /// What was found, or why nothing was tried.
    #[must_use]
    pub fn found(&self) -> &str {
        match self {
            Self::Holds(it)
            | Self::Specification(it)
            | Self::Firmware11(it)
            | Self::Differs(it)
            | Self::Unsteady(it)
            | Self::NotTried(it) => it,
        }
    }

    /// Whether the controller does otherwise than the protocol, in any dialect.
    #[must_use]
    pub const fn differs(&self) -> bool {
        matches!(self, Self::Differs(_))
    }

    /// Whether it was tried and is as some dialect says.
    pub(crate) const fn passed(&self) -> bool {
        !matches!(self, Self::Differs(_) | Self::NotTried(_))
    }

    /// Holds or differs.
    pub(crate) fn of(holds: bool, found: impl Into<String>) -> Self {
        if holds {
            Self::Holds(found.into())
        } else {
            Self::Differs(found.into())
        }
    }

    /// As one of the dialects, or like neither.
    pub(crate) fn vote(specification: bool, firmware_1_1: bool, found: impl Into<String>) -> Self {
        match (specification, firmware_1_1) {
            (true, true) => Self::Holds(found.into()),
            (true, false) => Self::Specification(found.into()),
            (false, true) => Self::Firmware11(found.into()),
            (false, false) => Self::Differs(found.into()),
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.word(), self.found())
    }
}
