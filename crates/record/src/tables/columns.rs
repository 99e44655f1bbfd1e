//! The columns of both tables of a recording.

use std::time::Duration;

use dobot_wire::{Command, Packet, Status};
use jiff::Timestamp;

use super::cell::{Cell, Column, Kind, column};

/// The columns of the statuses.
pub(crate) fn of_statuses() -> Vec<Column> {
    let mut columns = vec![column("time", Kind::Time), column("at_s", Kind::Double)];
    columns.extend(STATUS_FLOATS.map(|name| column(name, Kind::Float)));
    columns.push(column("suction", Kind::Truth));
    columns.push(column("gripper_deg", Kind::Float));
    columns
}

/// The cells of a status at a time since the start of the recorder.
pub(crate) fn of_status(start: Timestamp, at: Duration, status: &Status) -> Vec<Cell> {
    let mut cells = times(start, at);
    let numbers = [
        status.x_mm,
        status.y_mm,
        status.z_mm,
        status.rotation_deg,
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
    ];
    cells.extend(numbers.map(Cell::Float));
    cells.push(Cell::Truth(status.suction));
    cells.push(Cell::Float(status.gripper_deg));
    cells
}

/// The columns of the commands.
pub(crate) fn of_commands() -> Vec<Column> {
    let mut columns = vec![column("time", Kind::Time), column("at_s", Kind::Double)];
    columns.extend(["command", "fields", "error"].map(|name| column(name, Kind::Text)));
    columns.extend((1..=10).map(|n| column(format!("float_{n}"), Kind::Float)));
    columns
}

/// The cells of a command at a time since the start of the recorder; `None` if its meaning depends
/// on an unknown dialect.
pub(crate) fn of_command(
    start: Timestamp,
    at: Duration,
    packet: &Packet,
    meaning: Option<Result<Command, String>>,
) -> Vec<Cell> {
    let mut cells = times(start, at);
    cells.extend(described(meaning).map(Cell::Text));
    let bytes = packet.to_bytes();
    let floats = bytes[1..41].chunks_exact(4);
    cells
        .extend(floats.map(|float| {
            Cell::Float(f32::from_le_bytes([float[0], float[1], float[2], float[3]]))
        }));
    cells
}

/// Describes a command by its name, its fields as JSON, and the error in it.
fn described(meaning: Option<Result<Command, String>>) -> [Option<String>; 3] {
    let (command, error) = match meaning {
        Some(Ok(command)) => (serde_json::to_value(command).ok(), None),
        Some(Err(error)) => (None, Some(error)),
        None => (None, None),
    };
    let (mut name, mut fields) = (None, None);
    if let Some(serde_json::Value::Object(mut object)) = command {
        name = object
            .remove("type")
            .and_then(|removed| removed.as_str().map(str::to_owned));
        fields = Some(serde_json::Value::Object(object).to_string());
    }
    [name, fields, error]
}

fn times(start: Timestamp, at: Duration) -> Vec<Cell> {
    let at_ns = i128::try_from(at.as_nanos()).unwrap_or(i128::MAX);
    let since_1970 = start.as_nanosecond().saturating_add(at_ns);
    vec![
        Cell::Time(i64::try_from(since_1970).unwrap_or(i64::MAX)),
        Cell::Double(at.as_secs_f64()),
    ]
}

/// The columns of the first eight floats of a status, in order: positions in mm, angles in degrees.
pub const STATUS_FLOATS: [&str; 8] = [
    "x_mm",
    "y_mm",
    "z_mm",
    "rotation_deg",
    "base_deg",
    "rear_deg",
    "fore_deg",
    "servo_deg",
];
