//! Why an arm is not moved at all.

use std::fmt;
use std::time::Duration;

use crate::latency::MOST;

/// Why an arm is not moved at all, although nothing about it differs from the protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Hindrance {
    /// The status says that the pump runs.
    Pump,
    /// Where it stands there is too little room for the checks: why, in words.
    Cramped(String),
    /// The line takes so long, there and back.
    Slow(Duration),
}

impl fmt::Display for Hindrance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pump => f.write_str("the pump runs: something may hang on it"),
            Self::Cramped(why) => f.write_str(why),
            Self::Slow(took) => write!(
                f,
                "the line is too slow ({} ms); at most {} ms there and back",
                took.as_millis(),
                MOST.as_millis()
            ),
        }
    }
}
