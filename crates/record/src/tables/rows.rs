//! The conversion of a recording to the rows of its tables.

use std::io::Write;
use std::ops::RangeInclusive;
use std::time::Duration;

use crate::{Entry, Moment, Recording, meaning};
use dobot_wire::{Commands, Decoder, Packet, Status, Statuses};

use super::cell::Cell;
use super::columns::{of_command, of_status};
use super::error::ExportError;
use super::table::Table;

/// The number of rows written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Written {
    /// In the table of statuses.
    pub statuses: u64,
    /// In the table of commands.
    pub commands: u64,
}

/// Writes the statuses and the commands of a period of a recording, in time since the start of its
/// recorder.
///
/// Bytes that belong to no packet are left out. [`Recording::damage`] describes an unreadable part.
///
/// # Errors
///
/// [`ExportError`] if a file cannot be written.
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

/// A row of one of the tables.
pub(crate) enum Row {
    Status(Vec<Cell>),
    Command(Vec<Cell>),
}

/// Visits the rows of both tables in order of time.
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
        let (statuses, sent) = packets.of(&moment);
        if moment.at < *stretch.start() {
            continue;
        }
        let start = recording.start().unwrap_or_default();
        let dialect = recording.about().and_then(|about| about.dialect);
        for status in statuses {
            take(Row::Status(of_status(start, moment.at, &status)))?;
        }
        for packet in sent {
            let meaning = meaning(&packet, dialect);
            take(Row::Command(of_command(start, moment.at, &packet, meaning)))?;
        }
    }
    Ok(())
}

/// Whether a period of a recording contains a status or a command to export.
#[must_use]
pub fn holds_packets(recording: &mut Recording, stretch: &RangeInclusive<Duration>) -> bool {
    let mut packets = Packets::new();
    recording
        .take_while(|recording| recording.at <= *stretch.end())
        .any(|moment| {
            let (statuses, sent) = packets.of(&moment);
            moment.at >= *stretch.start() && !(statuses.is_empty() && sent.is_empty())
        })
}

/// The packets in the bytes of a recording.
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

    /// The statuses and commands that an entry completes.
    pub(crate) fn of(&mut self, moment: &Moment) -> (Vec<Status>, Vec<Packet>) {
        match &moment.entry {
            Entry::FromArm(bytes) => {
                let frames = self.from_arm.feed(bytes);
                let statuses = frames.filter_map(|frame| Status::parse(&frame).ok());
                (statuses.collect(), Vec::new())
            }
            Entry::ToArm(bytes) => (Vec::new(), self.to_arm.feed(bytes).collect()),
            Entry::Json(_) | Entry::Other(_) => (Vec::new(), Vec::new()),
        }
    }
}
