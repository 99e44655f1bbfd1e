//! The reasons not to move the arm.

use std::fmt;
use std::time::Duration;

use crate::latency::MAX_LATENCY;

/// The reason not to move an arm that conforms to the protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Blocker {
    /// The pump is reported on.
    Pump,
    /// There is too little room for the checks at its position, with the reason.
    Cramped(String),
    /// The line is too slow, with its round-trip time.
    Slow(Duration),
}

impl fmt::Display for Blocker {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pump => f.write_str("the pump is on: it may hold an object"),
            Self::Cramped(why) => f.write_str(why),
            Self::Slow(took) => write!(
                f,
                "the round-trip time of the line is {} ms; at most {} ms is allowed",
                took.as_millis(),
                MAX_LATENCY.as_millis()
            ),
        }
    }
}
