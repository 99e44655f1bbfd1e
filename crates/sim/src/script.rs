//! Scripts of timed packets.

mod error;
mod words;

use std::str::FromStr;
use std::time::Duration;

use dobot_controller::Port;

pub use self::error::{ScriptError, ScriptProblem};
use self::words::{LineWords, bytes, packet, start, tilt, voice};

/// A script of timed packets in text form; examples are in `vectors/traces/`.
///
/// ```text
/// # a comment
/// !end MS                    stop after this time
/// !pose REAR FORE            readings of the tilt sensors at power-up, degrees (default 45 45)
/// !port usb|bt               which port is in use (default usb)
/// T f1 f2 ... f10            one packet
/// raw T HEX... f:FLOAT n*HEX bytes as they are; `f:3.5` is a little-endian float, `40*00` forty
///                            bytes 00
/// voice T TEXT               a voice packet
/// ```
///
/// T is the time in milliseconds since the first control tick at which the first byte starts on
/// the line, or `credit`: when the next status has arrived. Lines are sent strictly in order.
///
/// ```
/// use dobot_sim::{Script, Start};
///
/// let script: Script = "!end 500\ncredit 3 0 240 0 0 0 0 2 0 0".parse()?;
/// assert_eq!(script.lines[0].start, Start::Credit);
/// assert_eq!(script.lines[0].bytes.len(), 42);
/// # Ok::<(), dobot_sim::ScriptError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Script {
    /// The end of the run (`!end`). Without it the run stops as
    /// [`simulate`](crate::simulate()) describes.
    pub end: Option<Duration>,
    /// The reading of the rear arm's tilt sensor at power-up, in degrees from the vertical.
    pub rear_deg: f64,
    /// The reading of the forearm's tilt sensor at power-up, in degrees below the horizontal.
    pub fore_deg: f64,
    /// The port in use.
    pub port: Port,
    /// The lines in order.
    pub lines: Vec<ScriptLine>,
}

/// A line of a script: bytes and their start.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ScriptLine {
    /// The start of the first byte.
    pub start: Start,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// The start of the first byte of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// At this time since the first control tick, or right after the bytes still on the line.
    At(Duration),
    /// When the last byte of the next status has arrived; on the Bluetooth port of the next one
    /// with x below 500 mm.
    Credit,
}

impl Script {
    /// Parses a script.
    ///
    /// # Errors
    ///
    /// Returns a [`ScriptError`] for the first invalid line.
    pub fn parse(text: &str) -> Result<Self, ScriptError> {
        let mut draft = Draft::default();
        for (index, line) in text.lines().enumerate() {
            draft.read(line).map_err(|problem| ScriptError {
                line: index + 1,
                problem,
            })?;
        }
        Ok(draft.finish())
    }
}

impl FromStr for Script {
    type Err = ScriptError;

    fn from_str(text: &str) -> Result<Self, ScriptError> {
        Self::parse(text)
    }
}

/// The state of the parser.
#[derive(Default)]
struct Draft {
    end: Option<Duration>,
    pose: Option<(f64, f64)>,
    port: Option<Port>,
    lines: Vec<ScriptLine>,
    /// The latest time of a line.
    latest: Duration,
}

impl Draft {
    fn read(&mut self, line: &str) -> Result<(), ScriptProblem> {
        let mut words = LineWords::of(line);
        match words.next() {
            None => Ok(()),
            Some(word) if word.starts_with('#') => Ok(()),
            Some(word) if word.starts_with('!') => self.directive(word, words),
            Some("raw") => {
                let start = self.start(&mut words)?;
                self.push(start, bytes(words)?);
                Ok(())
            }
            Some("voice") => {
                let start = self.start(&mut words)?;
                self.push(start, voice(words.rest())?);
                Ok(())
            }
            Some(_) => {
                let mut words = LineWords::of(line);
                let start = self.start(&mut words)?;
                self.push(start, packet(words)?);
                Ok(())
            }
        }
    }

    fn directive(&mut self, name: &str, mut words: LineWords<'_>) -> Result<(), ScriptProblem> {
        match name {
            "!end" => once(&mut self.end, "!end", words.time()?)?,
            "!pose" => once(
                &mut self.pose,
                "!pose",
                (tilt(&mut words)?, tilt(&mut words)?),
            )?,
            "!port" => once(&mut self.port, "!port", words.port()?)?,
            _ => return Err(ScriptProblem::Directive(name.into())),
        }
        words.end()
    }

    fn start(&mut self, words: &mut LineWords<'_>) -> Result<Start, ScriptProblem> {
        let start = start(words)?;
        if let Start::At(at) = start {
            if at < self.latest {
                return Err(ScriptProblem::Backwards {
                    found_ms: at.as_secs_f64() * 1e3,
                    latest_ms: self.latest.as_secs_f64() * 1e3,
                });
            }
            self.latest = at;
        }
        Ok(start)
    }

    fn push(&mut self, start: Start, bytes: Vec<u8>) {
        self.lines.push(ScriptLine { start, bytes });
    }

    fn finish(self) -> Script {
        let (rear_deg, fore_deg) = self.pose.unwrap_or(USUAL_POSE);
        Script {
            end: self.end,
            rear_deg,
            fore_deg,
            port: self.port.unwrap_or_default(),
            lines: self.lines,
        }
    }
}

fn once<T>(place: &mut Option<T>, name: &'static str, value: T) -> Result<(), ScriptProblem> {
    match place.replace(value) {
        None => Ok(()),
        Some(_) => Err(ScriptProblem::Twice(name)),
    }
}

/// Rear arm and forearm, in degrees (note N28).
const USUAL_POSE: (f64, f64) = (45.0, 45.0);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test fails by it")]
mod tests;
