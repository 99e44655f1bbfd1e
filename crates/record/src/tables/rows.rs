//! From a recording to the rows of its tables.

use std::io::Write;
use std::ops::RangeInclusive;
use std::time::Duration;

use crate::{Entry, Moment, Recording, meaning};
use dobot_wire::{Commands, Decoder, Packet, Status, Statuses};

use super::cell::Cell;
use super::columns::{of_command, of_status};
use super::error::ExportError;
use super::table::Table;

/// How many rows were written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// Into the table of statuses.
    pub statuses: u64,
    /// Into the table of commands.
    pub commands: u64,
}

/// Writes the statuses and the commands of a stretch of a recording, whose times count from the start of its recorder.
///
/// Bytes that belong to no packet are left out. What of the file could not be read tells [`Recording::damage`].
///
/// # Errors
///
/// [`ExportError`] where a file cannot be written.
pub fn export_tables<S: Write + Send, C: Write + Send>(
    recording: &mut Recording,
    stretch: &RangeInclusive<Duration>,
    mut statuses: Table<S>,
    mut commands: Table<C>,
) -> Result<Written, ExportError> {
    let mut written = Written::default();
    each_row(recording, stretch, |row| match row {
        Row::Status(cells) => {
            written.statuses += 1;
            statuses.push(cells)
        }
        Row::Command(cells) => {
            written.commands += 1;
            commands.push(cells)
        }
    })?;
    statuses.finish()?;
    commands.finish()?;
    Ok(written)
}

/// A row of one of both tables.
pub(crate) enum Row {
    Status(Vec<Cell>),
    Command(Vec<Cell>),
}

/// Goes through the rows of both tables, in the order of their times.
pub(crate) fn each_row(
    recording: &mut Recording,
    stretch: &RangeInclusive<Duration>,
    mut take: impl FnMut(Row) -> Result<(), ExportError>,
) -> Result<(), ExportError> {
    let mut packets = Packets::new();
    while let Some(moment) = recording.next() {
        if moment.at > *stretch.end() {
            break;
        }
        let (told, sent) = packets.of(&moment);
        if moment.at < *stretch.start() {
            continue;
        }
        let start = recording.start().unwrap_or_default();
        let dialect = recording.about().and_then(|it| it.dialect);
        for status in told {
            take(Row::Status(of_status(start, moment.at, &status)))?;
        }
        for packet in sent {
            let meaning = meaning(&packet, dialect);
            take(Row::Command(of_command(start, moment.at, &packet, meaning)))?;
        }
    }
    Ok(())
}

/// Whether a stretch of a recording holds a status or a command: else there is nothing to export.
#[must_use]
pub fn holds_packets(recording: &mut Recording, stretch: &RangeInclusive<Duration>) -> bool {
    let mut packets = Packets::new();
    recording
        .take_while(|it| it.at <= *stretch.end())
        .any(|moment| {
            let (told, sent) = packets.of(&moment);
            moment.at >= *stretch.start() && !(told.is_empty() && sent.is_empty())
        })
}

/// The packets that the bytes of a recording make.
pub(crate) struct Packets {
    to_arm: Decoder<Commands>,
    from_arm: Decoder<Statuses>,
}

impl Packets {
    pub(crate) fn new() -> Self {
        Self {
            to_arm: Decoder::commands(),
            from_arm: Decoder::statuses(dobot_session::plausible),
        }
    }

    /// The statuses and the commands that something recorded completes.
    pub(crate) fn of(&mut self, moment: &Moment) -> (Vec<Status>, Vec<Packet>) {
        match &moment.entry {
            Entry::FromArm(bytes) => {
                let frames = self.from_arm.feed(bytes);
                let statuses = frames.filter_map(|it| Status::parse(&it).ok());
                (statuses.collect(), Vec::new())
            }
            Entry::ToArm(bytes) => (Vec::new(), self.to_arm.feed(bytes).collect()),
            Entry::Json(_) | Entry::Other(_) => (Vec::new(), Vec::new()),
        }
    }
}
