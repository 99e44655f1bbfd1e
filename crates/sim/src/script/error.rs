//! The errors of a script.

use dobot_wire::ParseError;
use thiserror::Error;

/// The error returned when a script is invalid.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("line {line}: {problem}")]
pub struct ScriptError {
    /// The line's number; the first is 1.
    pub line: usize,
    /// The problem.
    pub problem: ScriptProblem,
}

/// A problem with a line of a script.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ScriptProblem {
    /// No line begins with this word.
    #[error(
        "the line begins with `{0}`; allowed are a time in milliseconds, `credit`, `raw`, `voice`, `!end`, `!pose`, `!port` and `#`"
    )]
    Beginning(String),
    /// The directive is unknown.
    #[error("the directive is `{0}`; allowed are `!end MS`, `!pose REAR FORE` and `!port usb|bt`")]
    Directive(String),
    /// The directive is repeated.
    #[error("`{0}` is repeated; it is allowed once")]
    Twice(&'static str),
    /// A word is missing.
    #[error("the line ends before {0}")]
    Missing(&'static str),
    /// There are too many words; this is the first of them.
    #[error("unexpected `{0}` at the end of the line; nothing more is allowed")]
    TooMuch(String),
    /// A word is not a time.
    #[error("the time is `{0}`; allowed are 0 to {LONGEST_MS} milliseconds, or `credit`")]
    Time(String),
    /// The end of the run is not a time.
    #[error("the end is `{0}`; allowed are 0 to {LONGEST_MS} milliseconds")]
    End(String),
    /// A line has an earlier time than one above it.
    #[error(
        "the time is {found_ms} ms, but a line above starts at {latest_ms} ms; lines must be in order"
    )]
    Backwards {
        /// The time in milliseconds.
        found_ms: f64,
        /// The latest time above, in milliseconds.
        latest_ms: f64,
    },
    /// A word is not an angle of a tilt sensor.
    #[error("the tilt sensor's angle is `{0}`; allowed are -180 to 180 degrees")]
    Tilt(String),
    /// A word is not a port.
    #[error("the port is `{0}`; allowed are `usb` and `bt`")]
    Port(String),
    /// A packet does not have ten floats.
    #[error("the packet has {0} floats; allowed are 10")]
    FloatCount(usize),
    /// A word of a packet is not a number.
    #[error("float {float} is `{found}`; allowed are numbers that fit four bytes, `nan` and `inf`")]
    Float {
        /// Its number; the first is 1.
        float: usize,
        /// The word.
        found: String,
    },
    /// A word of a `raw` line is not bytes.
    #[error(
        "word {word} of the bytes is `{found}`; allowed are two hex digits per byte, `f:FLOAT` with a number that fits four bytes, and `N*HEX` with up to {MAX_BYTES} bytes per line"
    )]
    Bytes {
        /// Its number; the first after the time is 1.
        word: usize,
        /// The word.
        found: String,
    },
    /// A text does not fit a voice packet.
    #[error("{0}")]
    Voice(ParseError),
}

/// One day.
pub(super) const LONGEST_MS: u32 = 86_400_000;
/// One minute on the line; more than any buffer holds.
pub(super) const MAX_BYTES: usize = 65_536;
