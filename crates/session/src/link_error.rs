//! The error type of a connection.

use std::io;
use std::time::Duration;

use crate::{NoStatus, NotReached, ResetEvidence, SendError};

/// The error returned when communication with an arm fails.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LinkError {
    /// No status arrived for too long.
    #[error("the arm has sent no valid status for {:.1} s: {received}", silent_for.as_secs_f64())]
    Silent {
        /// The time since the last status.
        silent_for: Duration,
        /// What arrived in that time.
        received: NoStatus,
    },
    /// The other end closed the link.
    #[error("the other end closed the link")]
    Closed,
    /// The link failed with an I/O error.
    #[error("the link broke: {0}")]
    Broken(io::Error),
    /// The arm stopped elsewhere than at the target of a command.
    #[error("the arm stopped at {found}, not at the target {expected}: {reason}")]
    NotReached {
        /// The probable reason.
        reason: NotReached,
        /// The target of the command.
        expected: String,
        /// The reported position.
        found: String,
    },
    /// The arm was reset: it has lost its commands, and its reported pose is not trustworthy.
    #[error("the arm was reset: {0}")]
    Reset(ResetEvidence),
    /// A command is not allowed.
    #[error(transparent)]
    Send(#[from] SendError),
}

impl LinkError {
    /// A hint for the user, if the link itself failed.
    #[must_use]
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::Silent { received, .. } => Some(received.hint()),
            Self::Closed | Self::Broken(_) => Some(
                "check that the arm is plugged in and switched on; over TCP it serves one client at a time",
            ),
            Self::NotReached { .. } | Self::Reset(_) | Self::Send(_) => None,
        }
    }
}
