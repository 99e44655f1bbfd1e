//! What a stretch of bytes is, as text and as JSON.

use dobot_wire::{Command, Dialect, Packet, ParseError, Status};
use serde_json::{Value, json};

use super::stock;
use crate::output;

/// What a stretch of bytes is.
#[derive(Debug)]
pub(crate) enum Content {
    /// A status of the arm.
    Status(Status),
    /// A status with something that a client would not trust.
    OddStatus(Status, Oddity),
    /// What a packet of a client says, in each of the dialects asked for.
    Command(Vec<Reading>),
    /// So many bytes that belong to no packet.
    Skipped(u64),
    /// So many bytes that were sent, and are not there.
    Gap(u64),
}

/// What is odd about a status.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Oddity {
    /// The pose has become NaN (note N34).
    PoseLost,
    /// Its numbers have few decimals: position and angles agree no better.
    Rounded {
        /// How far the position is off the angles.
        off_mm: f64,
    },
    /// Position and angles do not agree (note N22), or a number is one that no arm tells.
    Damaged,
}

/// What a packet of a client says in a dialect.
#[derive(Debug)]
pub(crate) struct Reading {
    pub(crate) dialect: Dialect,
    pub(crate) command: Result<Command, ParseError>,
    /// Whether a stock arm carries it out though it is not allowed.
    pub(crate) stock_takes: bool,
}

/// Where in a stream or in time something is: as text, and as fields of its JSON.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) text: String,
    pub(crate) fields: Vec<(&'static str, Value)>,
}

/// What a packet says: once where all dialects agree.
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

/// Prints what something is, and where.
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
        Content::OddStatus(status, oddity) => {
            let told = output::fields(status);
            match oddity {
                Oddity::PoseLost => format!("status whose pose is lost (NaN)  {told}"),
                Oddity::Rounded { off_mm } => {
                    format!("status, rounded: {off_mm:.2} mm off its angles  {told}")
                }
                Oddity::Damaged => {
                    format!("damaged status that no client trusts (note N22)  {told}")
                }
            }
        }
        Content::Command(_) => String::new(),
        Content::Skipped(bytes) => format!("skipped {bytes} bytes that belong to no packet"),
        Content::Gap(bytes) => format!("{bytes} bytes are missing here"),
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
    let Reading {
        dialect,
        command,
        stock_takes,
    } = reading;
    let name = dialect.name();
    let dialect_text = if differs {
        format!("[{name}] ")
    } else {
        String::new()
    };
    match (command, as_json) {
        (Ok(command), true) => place.json(json!({ "dialect": name, "command": command })),
        (Ok(command), false) => place.line(&format!(
            "{dialect_text}{}  {}",
            kind(command),
            output::fields(command)
        )),
        (Err(error), true) if *stock_takes => place.json(
            json!({ "dialect": name, "error": error.to_string(), "stock_arm_takes_it": true }),
        ),
        (Err(error), true) => place.json(json!({ "dialect": name, "error": error.to_string() })),
        (Err(error), false) => {
            let taken = if *stock_takes {
                "; a stock arm takes it"
            } else {
                ""
            };
            place.line(&format!("{dialect_text}not allowed: {error}{taken}"))
        }
    }
}

impl Place {
    /// Prints a line behind the place.
    pub(crate) fn line(&self, text: &str) -> std::io::Result<()> {
        output::line(&format!("{}  {text}", self.text))
    }

    /// Prints the fields of an object behind those of the place.
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
    fn what_differs_between_the_dialects_is_read_in_both() {
        let frame = Frame::ZERO.with(1, 3.0).with(8, 1.0);
        assert_eq!(readings(&frame.into(), None).len(), 2);
    }

    #[test]
    fn what_a_stock_arm_takes_all_the_same_is_said() {
        let sliders = Frame::ZERO.with(1, 10.0).with(3, 58.0).with(4, 38.0);
        let stock_takes = |dialect| readings(&sliders.into(), dialect)[0].stock_takes;
        assert!(stock_takes(Some(Dialect::FIRMWARE_1_1)));
        assert!(stock_takes(None));
        assert!(!stock_takes(Some(Dialect::SPECIFICATION)));
    }
}
