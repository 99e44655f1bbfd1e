//! The entries read from a recording, and its damage.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use serde_json::Value;

/// An entry of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The time since the start of the recorder; in files of other programs, since their first
    /// message.
    pub at: Duration,
    /// The topic, as in `/events`.
    pub topic: Arc<str>,
    /// The content.
    pub entry: Entry,
}

/// The content of an entry.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Bytes sent to the arm.
    ToArm(Vec<u8>),
    /// Bytes received from the arm.
    FromArm(Vec<u8>),
    /// A message of any other topic.
    Json(Value),
    /// A message that is not JSON; the recorder writes none.
    Other(Vec<u8>),
}

/// The position and the cause of the damage of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damage {
    /// The number of good bytes of the file.
    pub good_bytes: u64,
    /// The time of the last readable entry.
    pub last: Option<Duration>,
    /// The reason why no more could be read.
    pub reason: String,
    /// Whether all bytes of the file are good but the end is missing: it is still being written, or
    /// its program was killed.
    pub breaks_off: bool,
}

impl fmt::Display for Damage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "only {} bytes are good", self.good_bytes)?;
        if let Some(last) = self.last {
            write!(f, ", up to {:.3} s", last.as_secs_f64())?;
        }
        write!(f, ": {}", self.reason)
    }
}
