//! What becomes of a job.

use std::fmt;

use serde::{Deserialize, Serialize};

/// What becomes of a job.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum JobState {
    /// It waits for its turn.
    Queued,
    /// The arm is at it, or was when the program ended.
    Running,
    /// It goes on when somebody says so.
    Paused {
        /// Why.
        reason: String,
    },
    /// Somebody ended it.
    Stopped {
        /// Why.
        reason: String,
    },
    /// Its last command is done.
    Done,
    /// The arm, the link or the program ended it.
    Failed {
        /// Why.
        reason: String,
    },
}

impl JobState {
    /// Whether it is history: stopped, done or failed.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(
            self,
            Self::Stopped { .. } | Self::Done | Self::Failed { .. }
        )
    }

    /// Whether it has begun and is not over: running or paused.
    #[must_use]
    pub const fn is_under_way(&self) -> bool {
        matches!(self, Self::Running | Self::Paused { .. })
    }
}

/// One word, and the reason in brackets.
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
