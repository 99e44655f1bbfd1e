//! What becomes of a job, and why.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::JobPhase;

/// What becomes of a job, and why.
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
    /// The state of a job that is so far, for this reason; of those without one it is dropped.
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

    /// How far the job is.
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

    /// Why it is paused, stopped or failed.
    #[must_use]
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Paused { reason } | Self::Stopped { reason } | Self::Failed { reason } => {
                Some(reason)
            }
            Self::Queued | Self::Running | Self::Done => None,
        }
    }

    /// Whether it is history: stopped, done or failed.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        self.phase().is_over()
    }

    /// Whether it has begun and is not over: running or paused.
    #[must_use]
    pub const fn is_active(&self) -> bool {
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
