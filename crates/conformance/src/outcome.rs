//! The outcome of a check.

use std::fmt;

/// The outcome of a check, with a description of the finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// As the protocol requires, in every dialect.
    Holds(String),
    /// As in the published specification but not in stock arms: a vote for that dialect.
    Specification(String),
    /// As in stock arms but not in the published specification: a vote for that dialect.
    Firmware11(String),
    /// Neither.
    Differs(String),
    /// The repetitions differ or a packet was lost: a property of the line rather than the controller.
    Unsteady(String),
    /// Not tried, with the reason.
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

    /// The finding, or the reason why it was not tried.
    #[must_use]
    pub fn found(&self) -> &str {
        match self {
            Self::Holds(found)
            | Self::Specification(found)
            | Self::Firmware11(found)
            | Self::Differs(found)
            | Self::Unsteady(found)
            | Self::NotTried(found) => found,
        }
    }

    /// Whether the controller differs from the protocol in every dialect.
    #[must_use]
    pub const fn differs(&self) -> bool {
        matches!(self, Self::Differs(_))
    }

    /// Whether it was tried and fits a dialect.
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
