//! Why a conversation with an arm failed.

use std::io;
use std::time::Duration;

use crate::{NotReached, ResetEvidence, SendError};

/// Why a conversation with an arm failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LinkError {
    /// No status came any more.
    #[error(
        "the arm has sent no valid status for {:.1} s{}",
        silent_for.as_secs_f64(),
        if *noise > 0 { format!(", only {noise} bytes that belong to none") } else { String::new() }
    )]
    Silent {
        /// How long.
        silent_for: Duration,
        /// Bytes that came all the same.
        noise: u64,
    },
    /// The other end closed the link.
    #[error("the other end closed the link")]
    Closed,
    /// The link broke, which is something else than being closed.
    #[error("the link broke: {0}")]
    Broken(io::Error),
    /// The arm rests elsewhere than a command leads.
    #[error("the arm rests at {found}, not at {expected}, where the command leads: {reason}")]
    NotReached {
        /// Why, as far as it shows.
        reason: NotReached,
        /// Where the command leads.
        expected: String,
        /// Where the arm is.
        found: String,
    },
    /// The arm was reset: it has forgotten what it was told, and its pose is not to be trusted.
    #[error("the arm was reset: {0}")]
    Reset(ResetEvidence),
    /// A command is not allowed.
    #[error(transparent)]
    Send(#[from] SendError),
}
