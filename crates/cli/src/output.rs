//! Output: lines for people or JSON objects for programs, and files.

use std::fmt::Display;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;
use std::time::Duration;

use dobot_supervisor::plain;
use dobot_wire::Status;
use serde::Serialize;
use serde_json::Value;

use crate::failure::Failure;

/// Prints a line.
pub(crate) fn line(text: &str) -> io::Result<()> {
    writeln!(io::stdout(), "{text}")
}

/// Prints a line with text from other programs, without control characters.
pub(crate) fn plain_line(text: &str) -> io::Result<()> {
    line(&plain(text, usize::MAX))
}

/// Prints a whole document.
pub(crate) fn bytes(document: &[u8]) -> io::Result<()> {
    io::stdout().write_all(document)
}

/// Writes a whole document to a file; overwrites an existing one only with `force`.
pub(crate) fn file(file: &Path, document: &[u8], force: bool) -> Result<(), Failure> {
    Ok(new_file(file, force)?.write_all(document)?)
}

/// Creates a file; overwrites an existing one only with `force`.
pub(crate) fn new_file(file: &Path, force: bool) -> Result<File, Failure> {
    let mut options = OpenOptions::new();
    options
        .write(true)
        .create(force)
        .truncate(force)
        .create_new(!force);
    options.open(file).map_err(|error| {
        let exists = error.kind() == io::ErrorKind::AlreadyExists;
        let error = anyhow::Error::from(error).context(format!("cannot write {}", file.display()));
        if exists {
            Failure::new(error, "overwrite it with `--force`")
        } else {
            error.into()
        }
    })
}

/// Returns a number with a noun that forms its plural with `s`: `1 file`, `2 files`.
pub(crate) fn count(number: impl Display, noun: &str) -> String {
    many(number, noun, &format!("{noun}s"))
}

/// Returns a number with a noun in singular or plural.
pub(crate) fn many(number: impl Display, singular: &str, plural: &str) -> String {
    let number = number.to_string();
    let noun = if number == "1" { singular } else { plural };
    format!("{number} {noun}")
}

/// Returns numbers with nouns in singular or plural, without those that are 0.
pub(crate) fn counts(all: &[(usize, &str, &str)]) -> String {
    let some = all.iter().filter(|(number, ..)| *number > 0);
    let some = some.map(|(number, singular, plural)| many(number, singular, plural));
    some.collect::<Vec<_>>().join(", ")
}

/// Wraps a text at spaces into lines of at most `width` columns, if its words allow it.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.last_mut().expect("there is at least one line");
        if !last.is_empty() && last.chars().count() + word.chars().count() >= width {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}

/// Prints a value as one line of JSON.
pub(crate) fn json(value: &impl Serialize) -> io::Result<()> {
    let text = serde_json::to_string(value).map_err(io::Error::other)?;
    line(&text)
}

/// Prints a status, as text or as JSON.
pub(crate) fn status(status: &Status, as_json: bool) -> io::Result<()> {
    if as_json {
        json(status)
    } else {
        line(&status_text(status))
    }
}

/// Formats a status as one line.
pub(crate) fn status_text(status: &Status) -> String {
    format!(
        "x {:8.3}  y {:8.3}  z {:8.3} mm   turn {:7.2}°   base {:7.2}°  rear {:6.2}°  fore {:6.2}°  servo {:6.2}°   suction {}  gripper {:.1}°",
        status.x_mm,
        status.y_mm,
        status.z_mm,
        status.rotation_deg,
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
        if status.suction { "on " } else { "off" },
        status.gripper_deg,
    )
}

/// Formats a duration as minutes and seconds, or as seconds with one decimal.
pub(crate) fn clock(seconds: f64) -> String {
    if seconds < 59.95 {
        return format!("{:.1} s", seconds.max(0.0));
    }
    let whole = Duration::try_from_secs_f64(seconds.round()).unwrap_or(Duration::MAX);
    let whole = whole.as_secs();
    let (hours, minutes, seconds) = (whole / 3600, whole / 60 % 60, whole % 60);
    if hours > 0 {
        format!("{hours}:{minutes:02}:{seconds:02} h")
    } else {
        format!("{minutes}:{seconds:02} min")
    }
}

/// Formats the remaining time; empty if it is unknown.
pub(crate) fn time_left(seconds: Option<f64>) -> String {
    seconds.map_or_else(String::new, |seconds| format!("{} left", clock(seconds)))
}

/// Formats the fields of a message for a person: `x 200 mm, y -50 mm, suction off`.
pub(crate) fn fields(message: &impl Serialize) -> String {
    let Ok(Value::Object(fields)) = serde_json::to_value(message) else {
        return String::new();
    };
    fields
        .iter()
        .filter(|(name, _)| *name != "type")
        .map(|(name, value)| field(name, value))
        .collect::<Vec<_>>()
        .join(", ")
}

fn field(name: &str, value: &Value) -> String {
    let (name, unit) = UNITS
        .iter()
        .find_map(|(suffix, unit)| Some((name.strip_suffix(suffix)?, *unit)))
        .unwrap_or((name, ""));
    let value = match value {
        Value::Bool(true) => "on".to_owned(),
        Value::Bool(false) => "off".to_owned(),
        // The shortest decimal of the f32: 0.1, not 0.10000000149.
        Value::Number(number) => number
            .as_f64()
            .map_or_else(|| number.to_string(), |wide| narrow(wide).to_string()),
        Value::String(text) => text.clone(),
        // JSON has no NaN.
        Value::Null => "NaN".to_owned(),
        other => other.to_string(),
    };
    format!("{} {value}{unit}", name.replace('_', " "))
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "every number of a message is an f32"
)]
const fn narrow(wide: f64) -> f32 {
    wide as f32
}

/// Longer suffixes first.
const UNITS: [(&str, &str); 8] = [
    ("_deg_s2", "°/s²"),
    ("_deg_s", "°/s"),
    ("_mm_s2", " mm/s²"),
    ("_mm_s", " mm/s"),
    ("_deg", "°"),
    ("_mm", " mm"),
    ("_percent", " %"),
    ("_s", " s"),
];

#[cfg(test)]
mod tests {
    use dobot_wire::MoveTo;

    use super::*;

    #[test]
    fn texts_of_others_cannot_control_the_terminal() {
        let text = "desk-2  \u{1b}]0;pwn\u{7}\u{1b}[31mEVIL\r\n\u{9b}2J\u{202e}é";
        assert_eq!(plain(text, usize::MAX), "desk-2  ]0;pwn[31mEVIL2Jé");
    }

    #[test]
    fn times_read_like_a_clock() {
        assert_eq!(clock(0.04), "0.0 s");
        assert_eq!(clock(12.34), "12.3 s");
        assert_eq!(clock(59.96), "1:00 min");
        assert_eq!(clock(61.4), "1:01 min");
        assert_eq!(clock(3725.0), "1:02:05 h");
    }

    #[test]
    fn nouns_are_in_singular_or_plural_and_zeros_are_omitted() {
        assert_eq!(count(1, "file"), "1 file");
        assert_eq!(count(0, "file"), "0 files");
        assert_eq!(many(2, "status", "statuses"), "2 statuses");
        let all = [
            (1, "step", "steps"),
            (0, "pause", "pauses"),
            (2, "command", "commands"),
        ];
        assert_eq!(counts(&all), "1 step, 2 commands");
    }

    #[test]
    fn fields_carry_their_units() {
        let target = MoveTo {
            rotation_deg: 15.5,
            suction: true,
            pause_s: 0.5,
            ..MoveTo::to(200.1, -50.0, 0.0)
        };
        let text = fields(&target);
        for part in [
            "x 200.1 mm",
            "y -50 mm",
            "rotation 15.5°",
            "suction on",
            "mode jump",
            "pause 0.5 s",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
