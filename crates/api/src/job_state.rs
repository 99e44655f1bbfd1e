//! The state of a job and its reason.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::JobPhase;

/// The state of a job and its reason.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum JobState {
    /// Waiting for its turn.
    Queued,
    /// Running on the arm, or it was when the program ended.
    Running,
    /// Paused until it is resumed.
    Paused {
        /// The reason.
        reason: String,
    },
    /// Ended by a person.
    Stopped {
        /// The reason.
        reason: String,
    },
    /// All commands are done.
    Done,
    /// Ended by the arm, the link or the program.
    Failed {
        /// The reason.
        reason: String,
    },
}

impl JobState {
    /// Returns the state for a phase and a reason; the reason is dropped for phases without one.
    #[must_use]
    pub fn new(phase: JobPhase, reason: Option<String>) -> Self {
        let reason = reason.unwrap_or_default();
        match phase {
            JobPhase::Queued => Self::Queued,
            JobPhase::Running => Self::Running,
            JobPhase::Paused => Self::Paused { reason },
            JobPhase::Stopped => Self::Stopped { reason },
            JobPhase::Done => Self::Done,
            JobPhase::Failed => Self::Failed { reason },
        }
    }

    /// Returns the phase.
    #[must_use]
    pub const fn phase(&self) -> JobPhase {
        match self {
            Self::Queued => JobPhase::Queued,
            Self::Running => JobPhase::Running,
            Self::Paused { .. } => JobPhase::Paused,
            Self::Stopped { .. } => JobPhase::Stopped,
            Self::Done => JobPhase::Done,
            Self::Failed { .. } => JobPhase::Failed,
        }
    }

    /// Returns the reason why the job is paused, stopped or failed.
    #[must_use]
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Paused { reason } | Self::Stopped { reason } | Self::Failed { reason } => {
                Some(reason)
            }
            Self::Queued | Self::Running | Self::Done => None,
        }
    }

    /// Returns whether the job is over: stopped, done or failed.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        self.phase().is_over()
    }

    /// Returns whether the job has started and is not over: running or paused.
    #[must_use]
    pub const fn is_active(&self) -> bool {
        matches!(self, Self::Running | Self::Paused { .. })
    }
}

/// Formats as one word, with the reason in brackets.
impl fmt::Display for JobState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Queued => f.write_str("queued"),
            Self::Running => f.write_str("running"),
            Self::Paused { reason } => write!(f, "paused ({reason})"),
            Self::Stopped { reason } => write!(f, "stopped ({reason})"),
            Self::Done => f.write_str("done"),
            Self::Failed { reason } => write!(f, "failed ({reason})"),
        }
    }
}
