//! The errors of a script.

use dobot_wire::ParseError;
use thiserror::Error;

/// Which line of a script is wrong, and what is wrong with it.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("line {line}: {problem}")]
pub struct ScriptError {
    /// The line's number; the first is 1.
    pub line: usize,
    /// What is wrong with it.
    pub problem: ScriptProblem,
}

/// What is wrong with a line of a script.
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
    /// This directive stands for the second time.
    #[error("`{0}` stands here for the second time; allowed is once")]
    Twice(&'static str),
    /// This has to be there and is missing.
    #[error("the line ends where {0} is due")]
    Missing(&'static str),
    /// There are too many words; this is the first of them.
    #[error("behind the line's end stands `{0}`; allowed is nothing more")]
    TooMuch(String),
    /// A word is not a time.
    #[error("the time is `{0}`; allowed are 0 to {LONGEST_MS} milliseconds, or `credit`")]
    Time(String),
    /// The end of the run is not a time.
    #[error("the end is `{0}`; allowed are 0 to {LONGEST_MS} milliseconds")]
    End(String),
    /// A line is to be sent before one that stands above it.
    #[error(
        "the time is {found_ms} ms; lines are sent in order, and after one at {latest_ms} ms that time or a later one is allowed"
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
    /// A packet has so many floats instead of ten.
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
    /// A word of a `raw` line does not stand for bytes.
    #[error(
        "word {word} of the bytes is `{found}`; allowed are two hex digits a byte, `f:FLOAT` with a number that fits four bytes, and `N*HEX` with up to {MOST_BYTES} bytes a line"
    )]
    Bytes {
        /// Its number; the first behind the time is 1.
        word: usize,
        /// The word.
        found: String,
    },
    /// A text fits no voice packet.
    #[error("{0}")]
    Voice(ParseError),
}

/// A day.
pub(super) const LONGEST_MS: u32 = 86_400_000;
/// A minute of the line's time, and more than any buffer holds.
pub(super) const MOST_BYTES: usize = 65_536;
