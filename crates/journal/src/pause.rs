//! Where a job waits for a person.

use serde::{Deserialize, Serialize};

/// Where a job waits for a person: to change the pen, say.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pause {
    /// The command before which it waits, counted from 0.
    pub before: usize,
    /// What the person is told.
    pub message: String,
}
