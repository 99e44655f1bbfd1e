//! The repair of a truncated recording: its readable part is rewritten.

use std::fmt;
use std::fs::File;
use std::io::{BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use mcap::records::{MessageHeader, Record};
use mcap::write::NoSeek;
use mcap::{McapError, McapResult, Writer};
use serde_json::json;

use crate::records::{Flaw, Records};
use crate::topic::RECORDER;
use crate::{About, Damage, OpenError, Recording, file_writer, folder, is_being_written, schema};

/// The error returned when a recording cannot be repaired.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RepairError {
    /// The file cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// A program is writing or repairing the file.
    #[error("the recording is being written; its program finishes it")]
    BeingWritten,
    /// Nothing in the file can be read.
    #[error("nothing in the recording can be read")]
    Unreadable,
    /// The new file cannot be written.
    #[error("cannot write the new file; the disk may be full")]
    NotWritten,
    /// A message is not what its schema says.
    #[error("cannot convert the recording: {0}; copy it unchanged instead")]
    NotConverted(String),
}

/// Repairs a truncated or damaged recording: its readable part replaces it, with a note about the
/// rest. Returns the damage; `None` if there is none, then the file stays unchanged.
///
/// # Errors
///
/// [`RepairError`]; the file is unchanged then.
pub fn repair(path: &Path) -> Result<Option<Damage>, RepairError> {
    // Read first: the recording may be completed in the meantime.
    let is_being_written = is_being_written(path);
    let mut recording = Recording::open(path)?;
    let has_entries = recording.by_ref().count() > 0;
    let Some(damage) = recording.damage().cloned() else {
        return Ok(None);
    };
    if is_being_written {
        return Err(RepairError::BeingWritten);
    }
    let repair = Repair::begin(path, u64::MAX)?;
    let mut repair = repair.ok_or(RepairError::BeingWritten)?;
    repair.run().check(has_entries)?;
    Ok(Some(damage))
}

/// Copies the readable part of a recording, also of one that is being written, to a new file that
/// is complete. Returns the damage of the recording; the copy has a note about what is missing.
///
/// # Errors
///
/// [`RepairError`]; then there is no copy.
pub fn copy(path: &Path, copy: &Path) -> Result<Option<Damage>, RepairError> {
    copy_changed(path, copy, None)
}

/// Copies the readable part of a recording, with each record changed.
pub(crate) fn copy_changed(
    path: &Path,
    copy: &Path,
    change: Option<Box<Change>>,
) -> Result<Option<Damage>, RepairError> {
    let mut recording = Recording::open(path)?;
    let has_entries = recording.by_ref().count() > 0;
    let file = File::create_new(copy).map_err(OpenError::from)?;
    let new = NewFile {
        path: copy.to_owned(),
        file,
        is_kept: false,
    };
    let mut repair = Repair::into_file(path, new, u64::MAX)?;
    repair.change = change;
    let outcome = repair.run();
    if let Some(reason) = repair.refused.take() {
        return Err(RepairError::NotConverted(reason));
    }
    outcome.check(has_entries)?;
    Ok(recording.damage().cloned())
}

/// Changes a record on its way to a copy; an error is the reason why it cannot.
pub(crate) type Change = dyn for<'r> FnMut(Record<'r>) -> Result<Record<'r>, String> + Send;

/// A repair of a truncated recording into a new file beside it. The old file stays unchanged until
/// the new one is complete and synced.
pub(crate) struct Repair {
    /// The old file; `None` for a copy of it.
    old: Option<PathBuf>,
    old_bytes: u64,
    new: NewFile,
    /// The largest length of the new file, in bytes.
    most: u64,
    records: Records,
    /// Changes the records of a copy.
    change: Option<Box<Change>>,
    /// Why a record cannot be changed.
    refused: Option<String>,
    /// The metadata of the old file.
    writer: Option<Writer<NoSeek<BufWriter<File>>>>,
    /// The first reason why not all of the old file can be read.
    flaw: Option<Flaw>,
    /// Whether anything worth a file was read.
    holds_something: bool,
    start_ns: Option<u64>,
    last_ns: u64,
    /// The channel of the recorder's own messages.
    recorder: Option<u16>,
}

/// The result of a repair or of a copy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The file is complete now.
    Repaired,
    /// The file is unchanged.
    Left,
}

/// The new file; deleted unless it is kept.
struct NewFile {
    path: PathBuf,
    file: File,
    is_kept: bool,
}

impl Outcome {
    const fn check(self, has_entries: bool) -> Result<(), RepairError> {
        match self {
            Self::Repaired => Ok(()),
            Self::Left if has_entries => Err(RepairError::NotWritten),
            Self::Left => Err(RepairError::Unreadable),
        }
    }
}

impl Repair {
    /// Starts to repair a file; `None` while another process does, or if nothing is readable.
    pub(crate) fn begin(path: &Path, most: u64) -> Result<Option<Self>, OpenError> {
        let Some((new, file)) = folder::beside(path)? else {
            return Ok(None);
        };
        let new = NewFile {
            path: new,
            file,
            is_kept: false,
        };
        Ok(Some(Self {
            old: Some(path.to_owned()),
            ..Self::into_file(path, new, most)?
        }))
    }

    /// Starts to copy the readable part of a file.
    fn into_file(path: &Path, new: NewFile, most: u64) -> Result<Self, OpenError> {
        let old = File::open(path)?;
        let old_bytes = old.metadata()?.len();
        Ok(Self {
            old: None,
            old_bytes,
            new,
            most,
            records: Records::over(old)?,
            change: None,
            refused: None,
            writer: None,
            flaw: None,
            holds_something: false,
            start_ns: None,
            last_ns: 0,
            recorder: None,
        })
    }

    /// Copies all records.
    fn run(&mut self) -> Outcome {
        loop {
            if let Some(outcome) = self.step() {
                return outcome;
            }
        }
    }

    /// Copies some records; returns the result after the last one.
    pub(crate) fn step(&mut self) -> Option<Outcome> {
        for _ in 0..RECORDS {
            match self.records.next() {
                Some(Ok((kind, body))) => {
                    let record =
                        match mcap::parse_record(kind, &body).map(|record| self.changed(record)) {
                            Ok(Ok(record)) => record,
                            Ok(Err(reason)) => {
                                self.refused = Some(reason);
                                return Some(Outcome::Left);
                            }
                            Err(error) => {
                                self.note(Flaw::within(error.to_string()));
                                continue;
                            }
                        };
                    match self.copy(record) {
                        Ok(()) => {}
                        // The disk is full, or worse.
                        Err(McapError::Io(_)) => return Some(Outcome::Left),
                        Err(error) => self.note(Flaw::within(error.to_string())),
                    }
                }
                Some(Err(flaw)) => self.note(flaw),
                None => return Some(self.end()),
            }
        }
        None
    }

    fn changed<'r>(&mut self, record: Record<'r>) -> Result<Record<'r>, String> {
        match &mut self.change {
            Some(change) => change(record),
            None => Ok(record),
        }
    }

    fn note(&mut self, flaw: Flaw) {
        self.flaw.get_or_insert(flaw);
    }

    fn copy(&mut self, record: Record<'_>) -> McapResult<()> {
        if let Record::Header(header) = &record
            && self.writer.is_none()
        {
            let options = file_writer::options()
                .profile(&header.profile)
                .library(&header.library);
            let file = self.new.file.try_clone()?;
            self.writer = Some(options.create(NoSeek::new(BufWriter::new(file)))?);
        }
        // A file with another start is not from a recorder.
        let Some(writer) = &mut self.writer else {
            return Ok(());
        };
        match record {
            Record::Schema { header, data } => writer
                .add_schema_with_id(header.id, &header.name, &header.encoding, &data)
                .map(drop),
            Record::Channel(channel) => {
                if channel.topic == RECORDER {
                    self.recorder = Some(channel.id);
                }
                let (topic, encoding) = (&channel.topic, &channel.message_encoding);
                writer
                    .add_channel_with_id(
                        channel.id,
                        channel.schema_id,
                        topic,
                        encoding,
                        &channel.metadata,
                    )
                    .map(drop)
            }
            Record::Message { header, data } => {
                writer.write_to_known_channel(&header, &data)?;
                self.last_ns = header.log_time;
                self.start_ns.get_or_insert(header.log_time);
                self.holds_something = true;
                Ok(())
            }
            Record::Metadata(metadata) => {
                writer.write_metadata(&metadata)?;
                if let Some((_, start)) = About::of_metadata(&metadata) {
                    self.start_ns = u64::try_from(start.as_nanosecond()).ok();
                    self.holds_something = true;
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Finishes the new file and replaces the old one.
    fn end(&mut self) -> Outcome {
        match self.finish() {
            Ok(true) => Outcome::Repaired,
            Ok(false) | Err(_) => Outcome::Left,
        }
    }

    fn finish(&mut self) -> McapResult<bool> {
        let Some(mut writer) = self.writer.take().filter(|_| self.holds_something) else {
            return Ok(false);
        };
        if self.old.is_some() || self.flaw.is_some() {
            self.write_loss(&mut writer)?;
        }
        writer.finish()?;
        writer.into_inner().into_inner().flush()?;
        self.new.file.sync_all()?;
        let Some(old) = &self.old else {
            self.new.is_kept = true;
            return Ok(true);
        };
        // The old one may have been deleted meanwhile to make room.
        let is_wanted = old.exists() && self.new.file.metadata()?.len() <= self.most;
        if is_wanted {
            folder::replace(&self.new.path, old)?;
        }
        Ok(is_wanted)
    }

    /// The number of bytes of the old file that cannot be read.
    const fn lost_bytes(&self) -> u64 {
        self.old_bytes.saturating_sub(self.records.good_bytes())
    }

    /// Writes a note about the missing part as the last message.
    fn write_loss(&self, writer: &mut Writer<impl Write + Seek>) -> McapResult<()> {
        let topic = schema::own(RECORDER).expect("it is one of the recorder's own topics");
        let channel_id = if let Some(id) = self.recorder {
            id
        } else {
            topic.add_to(writer)?
        };
        let start_ns = self.start_ns.unwrap_or_default();
        let at_ns = self.last_ns.max(start_ns);
        let reason = self.flaw.as_ref().map_or("", |flaw| &flaw.reason);
        let value = json!({
            "at_s": Duration::from_nanos(at_ns - start_ns).as_secs_f64(),
            "unreadable_bytes": self.lost_bytes(),
            "reason": format!("the recording was truncated and has been repaired: {reason}"),
        });
        let header = MessageHeader {
            channel_id,
            sequence: 0,
            log_time: at_ns,
            publish_time: at_ns,
        };
        writer.write_to_known_channel(&header, value.to_string().as_bytes())
    }
}

impl fmt::Debug for Repair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Repair")
            .field("old", &self.old)
            .finish_non_exhaustive()
    }
}

impl Drop for NewFile {
    fn drop(&mut self) {
        // After replacing the old file it no longer exists; a remaining file is deleted at the next
        // start.
        if !self.is_kept {
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

/// The number of records copied per step.
const RECORDS: usize = 1000;
