//! The words of a script's line.

use std::time::Duration;

use data_encoding::HEXLOWER_PERMISSIVE;
use dobot_controller::Port;
use dobot_wire::{Frame, Voice};

use super::Start;
use super::error::{LONGEST_MS, MAX_BYTES, ScriptProblem};

/// The words of a line in order.
pub(super) struct LineWords<'a> {
    rest: &'a str,
}

impl<'a> LineWords<'a> {
    pub(super) fn of(line: &'a str) -> Self {
        Self {
            rest: line.trim_ascii(),
        }
    }

    pub(super) fn next(&mut self) -> Option<&'a str> {
        let end = self.rest.bytes().position(|it| it.is_ascii_whitespace());
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.trim_ascii_start();
        (!word.is_empty()).then_some(word)
    }

    /// The rest of the line.
    pub(super) const fn rest(&self) -> &'a str {
        self.rest
    }

    pub(super) fn end(&mut self) -> Result<(), ScriptProblem> {
        match self.next() {
            None => Ok(()),
            Some(word) => Err(ScriptProblem::TooMuch(word.into())),
        }
    }

    pub(super) fn time(&mut self) -> Result<Duration, ScriptProblem> {
        let word = self.word("a time in milliseconds")?;
        time(word).ok_or_else(|| ScriptProblem::End(word.into()))
    }

    pub(super) fn port(&mut self) -> Result<Port, ScriptProblem> {
        match self.word("`usb` or `bt`")? {
            "usb" => Ok(Port::Usb),
            "bt" => Ok(Port::Bluetooth),
            word => Err(ScriptProblem::Port(word.into())),
        }
    }

    fn word(&mut self, wanted: &'static str) -> Result<&'a str, ScriptProblem> {
        self.next().ok_or(ScriptProblem::Missing(wanted))
    }
}

pub(super) fn start(words: &mut LineWords<'_>) -> Result<Start, ScriptProblem> {
    match words.word("a time in milliseconds or `credit`")? {
        "credit" => Ok(Start::Credit),
        word => match time(word) {
            Some(at) => Ok(Start::At(at)),
            None if word.starts_with(|it: char| it.is_ascii_alphabetic() || it == '!') => {
                Err(ScriptProblem::Beginning(word.into()))
            }
            None => Err(ScriptProblem::Time(word.into())),
        },
    }
}

pub(super) fn tilt(words: &mut LineWords<'_>) -> Result<f64, ScriptProblem> {
    let word = words.word("a tilt sensor's angle")?;
    word.parse()
        .ok()
        .filter(|it: &f64| it.abs() <= 180.0)
        .ok_or_else(|| ScriptProblem::Tilt(word.into()))
}

/// Ten floats as a packet.
pub(super) fn packet(mut words: LineWords<'_>) -> Result<Vec<u8>, ScriptProblem> {
    let mut frame = Frame::ZERO;
    for n in 1..=10 {
        let word = words.next().ok_or(ScriptProblem::FloatCount(n - 1))?;
        let value = float(word).ok_or_else(|| ScriptProblem::Float {
            float: n,
            found: word.into(),
        })?;
        frame = frame.with(n, value);
    }
    if words.rest().is_empty() {
        return Ok(frame.to_bytes().to_vec());
    }
    let more = std::iter::from_fn(|| words.next()).count();
    Err(ScriptProblem::FloatCount(10 + more))
}

/// The bytes of a `raw` line.
pub(super) fn bytes(mut words: LineWords<'_>) -> Result<Vec<u8>, ScriptProblem> {
    let mut bytes = Vec::new();
    let mut word = words.word("a byte")?;
    for number in 1.. {
        let problem = || ScriptProblem::Bytes {
            word: number,
            found: word.into(),
        };
        append(word, &mut bytes).ok_or_else(problem)?;
        match words.next() {
            Some(next) => word = next,
            None => break,
        }
    }
    Ok(bytes)
}

pub(super) fn voice(text: &str) -> Result<Vec<u8>, ScriptProblem> {
    if text.is_empty() {
        return Err(ScriptProblem::Missing("a text"));
    }
    let voice = Voice::new(text).map_err(ScriptProblem::Voice)?;
    Ok(voice.to_bytes().to_vec())
}

/// Appends the bytes of a word of a `raw` line; `None` if it is invalid.
fn append(word: &str, bytes: &mut Vec<u8>) -> Option<()> {
    if let Some(number) = word.strip_prefix("f:") {
        bytes.extend(float(number)?.to_le_bytes());
    } else if let Some((count, digits)) = word.split_once('*') {
        let count = whole(count)?;
        let digits = hex(digits)?;
        if count * digits.len() > MAX_BYTES {
            return None;
        }
        bytes.extend(digits.repeat(count));
    } else {
        bytes.extend(hex(word)?);
    }
    (bytes.len() <= MAX_BYTES).then_some(())
}

fn whole(word: &str) -> Option<usize> {
    let digits = word.bytes().all(|it| it.is_ascii_digit());
    let count = word.parse().ok().filter(|_| digits)?;
    (1..=MAX_BYTES).contains(&count).then_some(count)
}

fn hex(word: &str) -> Option<Vec<u8>> {
    let bytes = HEXLOWER_PERMISSIVE.decode(word.as_bytes()).ok();
    bytes.filter(|it| !it.is_empty())
}

/// A number that fits four bytes, `nan` or `inf`; larger ones are refused.
fn float(word: &str) -> Option<f32> {
    let float: f32 = word.parse().ok()?;
    let says_so = || word.contains(['i', 'I']);
    (float.is_finite() || float.is_nan() || says_so()).then_some(float)
}

fn time(word: &str) -> Option<Duration> {
    if word.len() <= 8 && word.bytes().all(|it| it.is_ascii_digit()) {
        let ms: u32 = word.parse().ok().filter(|&ms| ms <= LONGEST_MS)?;
        return Some(Duration::from_millis(u64::from(ms)));
    }
    let ms: f64 = word.parse().ok()?;
    let allowed = (0.0..=f64::from(LONGEST_MS)).contains(&ms);
    allowed.then(|| Duration::from_secs_f64(ms / 1e3))
}
