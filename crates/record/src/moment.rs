//! What is read from a recording, and where it breaks off.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use serde_json::Value;

/// Something that was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// When it happened, since the recorder was started; in files of other programs, since their
    /// first message.
    pub at: Duration,
    /// What it is called, as in `/events`.
    pub topic: Arc<str>,
    /// What it is.
    pub entry: Entry,
}

/// What was recorded.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Bytes that were sent to the arm.
    ToArm(Vec<u8>),
    /// Bytes that came from the arm.
    FromArm(Vec<u8>),
    /// A message of any other topic.
    Json(Value),
    /// A message that is not JSON; the recorder writes none.
    Other(Vec<u8>),
}

/// Where a recording breaks off, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damage {
    /// How many bytes of the file are good.
    pub good_bytes: u64,
    /// When the last thing happened that could be read.
    pub last: Option<Duration>,
    /// Why no more could be read.
    pub reason: String,
    /// All bytes of the file are good, but it ends too early: it is still being written, or its program
    /// was killed.
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
