//! The rotation of recordings: starts and finishes files, deletes the oldest.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::time::Duration;

use jiff::Timestamp;
use mcap::McapError;

use crate::encoder::{Encoder, Message};
use crate::file_writer::FileWriter;
use crate::{About, Health, Limits, Record, folder};

/// A rotation of recordings in a folder. It has no clock: the records carry the time.
#[derive(Debug)]
pub(crate) struct Rotation {
    folder: PathBuf,
    limits: Limits,
    start: Timestamp,
    about: About,
    encoder: Encoder,
    open: Option<OpenFile>,
    trouble: Option<Failure>,
    /// The time of the latest record.
    now: Duration,
    /// The number of records lost.
    lost: u64,
    /// The number of lost records that no file mentions yet.
    unreported: u64,
    why_unreported: String,
    /// The number of lost records that no message mentions yet.
    held: u64,
}

/// The current file.
#[derive(Debug)]
struct OpenFile {
    path: PathBuf,
    writer: FileWriter<BufWriter<File>>,
    /// The same file, for syncing.
    file: File,
    synced: Duration,
    /// The number of records that are not flushed yet.
    unsafe_records: u64,
    /// Whether flushed data is not synced yet.
    holds_records: bool,
}

/// The reason why nothing can be recorded now.
#[derive(Debug)]
struct Failure {
    reason: String,
    retry: Duration,
}

fn create_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| Failure {
        reason: format!("cannot create the folder {}: {error}", folder.display()),
        retry: Duration::ZERO,
    })
}

impl Rotation {
    /// Creates a rotation of recordings whose times count from `start`.
    pub(crate) fn new(
        folder: PathBuf,
        limits: Limits,
        start: Timestamp,
        about: About,
        mut encoder: Encoder,
    ) -> Self {
        encoder.write(Duration::ZERO, &Record::About(Box::new(about.clone())));
        let trouble = create_folder(&folder).err();
        Self {
            folder,
            limits,
            start,
            about,
            encoder,
            open: None,
            trouble,
            now: Duration::ZERO,
            lost: 0,
            unreported: 0,
            why_unreported: String::new(),
            held: 0,
        }
    }

    /// Records an entry.
    pub(crate) fn handle_record(&mut self, at: Duration, record: &Record) {
        self.now = self.now.max(at);
        if let Record::About(about) = record {
            self.write_held();
            self.about = (**about).clone();
            let done = self.write_about();
            self.note_result(done);
        }
        let Some(messages) = self.encoder.write(at, record) else {
            return self.count_lost(1, "a time is centuries in the future");
        };
        if !messages.is_empty() || self.encoder.is_holding() {
            self.held += 1;
        }
        self.write_down(at, &messages);
    }

    /// Counts records lost after the recorded ones.
    pub(crate) fn handle_lost(&mut self, count: u64, reason: &str) {
        if count > 0 {
            self.write_held();
            self.count_lost(count, reason);
        }
    }

    /// Handles a silence: flushes and syncs.
    pub(crate) fn handle_idle(&mut self) {
        self.write_held();
        let flushed = match &mut self.open {
            Some(open) if open.unsafe_records > 0 => open.flush(),
            _ => return,
        };
        self.note_result(flushed);
    }

    /// Finishes the current file.
    pub(crate) fn finish(&mut self) {
        self.write_held();
        if self.open.is_some() {
            let closed = self.close();
            self.note_result(closed);
        }
    }

    /// The health.
    pub(crate) fn health(&self) -> Health {
        Health {
            file: self.open.as_ref().map(|open| open.path.clone()),
            trouble: self.trouble.as_ref().map(|trouble| trouble.reason.clone()),
            lost: self.lost,
            ..Health::default()
        }
    }

    fn count_lost(&mut self, count: u64, reason: &str) {
        if count > 0 {
            self.lost += count;
            self.unreported += count;
            reason.clone_into(&mut self.why_unreported);
        }
    }

    /// Writes the messages for what is held back.
    fn write_held(&mut self) {
        let messages = self.encoder.write_held();
        if !messages.is_empty() {
            self.write_down(self.now, &messages);
        }
    }

    /// Writes the messages for what is held back, or, if there are none, flushes earlier data when
    /// due.
    fn write_down(&mut self, at: Duration, messages: &[Message<'_>]) {
        if messages.is_empty() {
            if let Err(error) = self.flush_if_due(at) {
                self.note_result(Err(error));
            }
            return;
        }
        let count = std::mem::take(&mut self.held);
        if let Some(trouble) = self
            .trouble
            .as_ref()
            .filter(|trouble| self.now < trouble.retry)
        {
            let reason = trouble.reason.clone();
            return self.count_lost(count, &reason);
        }
        let written = self.write(at, messages, count);
        let failed = written.is_err();
        self.note_result(written);
        if failed {
            let reason = self.health().trouble.unwrap_or_default();
            self.count_lost(count, &reason);
        }
    }

    /// Writes the messages for this number of records.
    fn write(
        &mut self,
        at: Duration,
        messages: &[Message<'_>],
        count: u64,
    ) -> Result<(), McapError> {
        for message in messages {
            self.ensure_room(at, message)?;
            let Some(open) = &mut self.open else { break };
            if self.unreported > 0
                && let Some(lost) =
                    self.encoder
                        .write_lost(at, self.unreported, &self.why_unreported)
            {
                open.writer.write(&lost)?;
                self.unreported = 0;
            }
            open.writer.write(message)?;
        }
        let flushed = self.flush_if_due(at)?;
        if let Some(open) = &mut self.open {
            open.holds_records |= flushed;
            open.unsafe_records += if flushed { 0 } else { count };
        }
        Ok(())
    }

    /// Flushes the file if due; returns whether it did.
    fn flush_if_due(&mut self, at: Duration) -> Result<bool, McapError> {
        let Some((open, now_ns)) = self.open.as_mut().zip(self.encoder.at_ns(at)) else {
            return Ok(false);
        };
        if !open.writer.wants_flush(now_ns) {
            return Ok(false);
        }
        open.flush()?;
        if at.saturating_sub(open.synced) >= SYNC_PERIOD {
            open.synced = at;
            open.file.sync_data()?;
        }
        Ok(true)
    }

    /// Opens a file that has room for a message, if none is open.
    fn ensure_room(&mut self, at: Duration, message: &Message<'_>) -> Result<(), McapError> {
        // Lost records may have to be mentioned first.
        let limit = self.limits.file_bytes.saturating_sub(LOST_LEN);
        let has_room = |open: &OpenFile| {
            !open.writer.is_full_for(message, limit) && open.writer.has_room_for(message.topic)
        };
        if self.open.as_ref().is_some_and(has_room) {
            return Ok(());
        }
        self.close()?;
        let limits = self.limits;
        folder::make_room(&self.folder, limits.file_bytes, limits.total_bytes)?;
        self.open = Some(self.begin(at, message.since_ns)?);
        Ok(())
    }

    fn close(&mut self) -> Result<(), McapError> {
        let Some(open) = self.open.take() else {
            return Ok(());
        };
        let count = open.unsafe_records;
        open.finish().inspect_err(|error| {
            let reason = self.text(error);
            self.count_lost(count, &reason);
        })
    }

    fn begin(&self, at: Duration, since_ns: u64) -> Result<OpenFile, McapError> {
        let begin = Timestamp::from_nanosecond(since_ns.into()).unwrap_or(self.start);
        let (path, file) = folder::create(&self.folder, begin)?;
        let buffered = BufWriter::with_capacity(BUFFER_LEN, file.try_clone()?);
        let writer = FileWriter::begin(buffered, &self.about, self.start);
        Ok(OpenFile {
            writer: writer.inspect_err(|_| discard(&path))?,
            path,
            file,
            synced: at,
            unsafe_records: 0,
            holds_records: false,
        })
    }

    /// Writes new metadata to the open file.
    fn write_about(&mut self) -> Result<(), McapError> {
        let Some(open) = &mut self.open else {
            return Ok(());
        };
        open.flush()?;
        open.writer.write_about(&self.about, self.start)
    }

    /// After a failure the file is abandoned with its unflushed data, and another one is tried
    /// later.
    fn note_result(&mut self, done: Result<(), McapError>) {
        self.trouble = done.err().map(|error| Failure {
            reason: self.text(&error),
            retry: self.now + RETRY,
        });
        if let Some(reason) = self.health().trouble
            && let Some(open) = self.open.take()
        {
            self.count_lost(open.unsafe_records, &reason);
            if !open.holds_records {
                discard(&open.path);
            }
        }
    }

    fn text(&self, error: &McapError) -> String {
        let folder = self.folder.display();
        match error {
            McapError::Io(error) => format!("cannot record in {folder}: {error}"),
            error => format!("cannot record in {folder}: {error}"),
        }
    }
}

impl OpenFile {
    /// Flushes all records to the file.
    fn flush(&mut self) -> Result<(), McapError> {
        self.writer.flush()?;
        self.holds_records |= self.unsafe_records > 0;
        self.unsafe_records = 0;
        Ok(())
    }

    fn finish(self) -> Result<(), McapError> {
        self.writer.finish()?;
        self.file.sync_all()?;
        Ok(())
    }
}

/// Deletes an empty file: on a full disk there would be more and more of them.
fn discard(path: &Path) {
    // If it cannot be deleted, it stays empty.
    let _ = std::fs::remove_file(path);
}

/// The delay between a failure and the next file.
const RETRY: Duration = Duration::from_secs(10);

/// The sync interval: a power failure loses this much and the unflushed data.
const SYNC_PERIOD: Duration = Duration::from_secs(5);

/// The usual length of a chunk.
const BUFFER_LEN: usize = 64 << 10;

/// Room for the message about lost records.
const LOST_LEN: u64 = 8 << 10;

#[cfg(test)]
mod tests;
