//! The content of a range of bytes, as text and as JSON.

use dobot_wire::{Command, Dialect, Packet, ParseError, Status};
use serde_json::{Value, json};

use super::stock;
use crate::output;

/// The content of a range of bytes.
#[derive(Debug)]
pub(crate) enum Content {
    /// A status of the arm.
    Status(Status),
    /// A status that a client would not accept.
    OddStatus(Status, Oddity),
    /// A packet of a client, read in each requested dialect.
    Command(Vec<Reading>),
    /// A number of bytes outside packets.
    Skipped(u64),
    /// A number of bytes that were sent but are missing.
    Gap(u64),
}

/// The oddity of a status.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Oddity {
    /// The pose has become NaN (note N34).
    PoseLost,
    /// Rounded values: position and angles match only approximately.
    Rounded {
        /// The distance between the position and that of the angles.
        off_mm: f64,
    },
    /// Position and angles do not match (note N22), or a value is one that no arm reports.
    Damaged,
}

/// A packet of a client in a dialect.
#[derive(Debug)]
pub(crate) struct Reading {
    pub(crate) dialect: Dialect,
    pub(crate) command: Result<Command, ParseError>,
    /// Whether an arm as sold executes it although it is not allowed.
    pub(crate) stock_takes: bool,
}

/// A position in a stream or in time, as text and as JSON fields.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) text: String,
    pub(crate) fields: Vec<(&'static str, Value)>,
}

/// Reads a packet in each dialect; returns one reading if all agree.
pub(crate) fn readings(packet: &Packet, dialect: Option<Dialect>) -> Vec<Reading> {
    let read = |dialect: Dialect| {
        let command = Command::parse(packet, &dialect);
        let is_stock = dialect == Dialect::FIRMWARE_1_1;
        let stock_takes = is_stock && command.is_err() && stock::takes(packet);
        Reading {
            dialect,
            command,
            stock_takes,
        }
    };
    if let Some(dialect) = dialect {
        return vec![read(dialect)];
    }
    let [mut specification, firmware] = Dialect::ALL.map(read);
    let refused = specification.command.is_err() && firmware.command.is_err();
    if refused || specification.command == firmware.command {
        specification.stock_takes = firmware.stock_takes;
        vec![specification]
    } else {
        vec![specification, firmware]
    }
}

/// Prints a content and its place.
pub(crate) fn show(place: &Place, content: &Content, as_json: bool) -> std::io::Result<()> {
    match content {
        Content::Command(readings) => readings
            .iter()
            .try_for_each(|reading| show_reading(place, reading, readings.len() > 1, as_json)),
        _ if as_json => place.json(fields(content)),
        _ => place.line(&text(content)),
    }
}

fn text(content: &Content) -> String {
    match content {
        Content::Status(status) => format!("status  {}", output::fields(status)),
        Content::OddStatus(status, oddity) => odd_status(&output::fields(status), *oddity),
        Content::Command(_) => String::new(),
        Content::Skipped(bytes) => {
            format!("skipped {} outside packets", output::count(bytes, "byte"))
        }
        Content::Gap(bytes) => {
            format!(
                "{} missing here",
                output::many(bytes, "byte is", "bytes are")
            )
        }
    }
}

fn odd_status(fields: &str, oddity: Oddity) -> String {
    match oddity {
        Oddity::PoseLost => format!("status with a lost pose (NaN)  {fields}"),
        Oddity::Rounded { off_mm } => {
            format!("status, rounded: {off_mm:.2} mm off its angles  {fields}")
        }
        Oddity::Damaged => {
            format!("damaged status, rejected by clients (note N22)  {fields}")
        }
    }
}

fn fields(content: &Content) -> Value {
    match content {
        Content::Status(status) => json!({ "status": status }),
        Content::OddStatus(status, Oddity::PoseLost) => {
            json!({ "status": status, "pose_lost": true })
        }
        Content::OddStatus(status, Oddity::Rounded { off_mm }) => {
            json!({ "status": status, "rounded_off_mm": off_mm })
        }
        Content::OddStatus(status, Oddity::Damaged) => json!({ "damaged_status": status }),
        Content::Command(_) => Value::Null,
        Content::Skipped(bytes) => json!({ "skipped_bytes": bytes }),
        Content::Gap(bytes) => json!({ "missing_bytes": bytes }),
    }
}

fn show_reading(
    place: &Place,
    reading: &Reading,
    differs: bool,
    as_json: bool,
) -> std::io::Result<()> {
    if as_json {
        return place.json(reading_fields(reading));
    }
    let dialect = if differs {
        format!("[{}] ", reading.dialect.name())
    } else {
        String::new()
    };
    place.line(&format!("{dialect}{}", reading_text(reading)))
}

fn reading_fields(reading: &Reading) -> Value {
    let name = reading.dialect.name();
    match &reading.command {
        Ok(command) => json!({ "dialect": name, "command": command }),
        Err(error) if reading.stock_takes => {
            json!({ "dialect": name, "error": error.to_string(), "stock_arm_takes_it": true })
        }
        Err(error) => json!({ "dialect": name, "error": error.to_string() }),
    }
}

fn reading_text(reading: &Reading) -> String {
    match &reading.command {
        Ok(command) => format!("{}  {}", kind(command), output::fields(command)),
        Err(error) if reading.stock_takes => {
            format!("not allowed: {error}; an arm as sold executes it")
        }
        Err(error) => format!("not allowed: {error}"),
    }
}

impl Place {
    /// Prints the place and a line.
    pub(crate) fn line(&self, text: &str) -> std::io::Result<()> {
        output::line(&format!("{}  {text}", self.text))
    }

    /// Prints the fields of the place and of an object.
    pub(crate) fn json(&self, mut content: Value) -> std::io::Result<()> {
        let named = |(name, value): &(&str, Value)| ((*name).to_owned(), value.clone());
        let mut fields: serde_json::Map<_, _> = self.fields.iter().map(named).collect();
        if let Some(content) = content.as_object_mut() {
            fields.append(content);
        }
        output::json(&fields)
    }
}

/// The kind of a command, as its JSON names it.
pub(crate) fn kind(command: &Command) -> String {
    serde_json::to_value(command)
        .ok()
        .and_then(|value| value.get("type").and_then(Value::as_str).map(str::to_owned))
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use dobot_wire::Frame;

    use super::*;

    #[test]
    fn a_packet_that_the_dialects_read_differently_is_shown_in_both() {
        let frame = Frame::ZERO.with(1, 3.0).with(8, 1.0);
        assert_eq!(readings(&frame.into(), None).len(), 2);
    }

    #[test]
    fn the_leniency_of_a_stock_arm_is_reported() {
        let sliders = Frame::ZERO.with(1, 10.0).with(3, 58.0).with(4, 38.0);
        let stock_takes = |dialect| readings(&sliders.into(), dialect)[0].stock_takes;
        assert!(stock_takes(Some(Dialect::FIRMWARE_1_1)));
        assert!(stock_takes(None));
        assert!(!stock_takes(Some(Dialect::SPECIFICATION)));
    }
}
