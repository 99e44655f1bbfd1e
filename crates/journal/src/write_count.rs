//! The number of writes of a journal, kept beside it.

use std::fs::File;
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use crate::store::private;

/// A file beside a journal that contains the number of its last write, twice.
///
/// If its newest write is damaged, the database falls back to the previous one without noticing;
/// this file reveals it. It is written after each write without waiting for the disk, so it is
/// never ahead of an intact journal. If it cannot be read or written, nothing is reported and
/// nothing fails: jobs do not depend on it.
#[derive(Debug)]
pub(crate) struct WriteCount {
    path: PathBuf,
    file: Option<File>,
}

impl WriteCount {
    /// Returns the file beside a journal.
    pub(crate) fn beside(journal: &Path) -> Self {
        let mut path = journal.as_os_str().to_owned();
        path.push(".writes");
        Self {
            path: path.into(),
            file: None,
        }
    }

    /// Reads the number of the last write; 0 if unknown.
    pub(crate) fn read(&self) -> u64 {
        let mut text = String::new();
        let read = File::open(&self.path).and_then(|mut file| file.read_to_string(&mut text));
        let numbers: Vec<&str> = text.split_whitespace().collect();
        match numbers[..] {
            [one, other] if read.is_ok() && one == other => one.parse().unwrap_or(0),
            _ => 0,
        }
    }

    /// Stores the number of a write that is on the disk.
    pub(crate) fn note(&mut self, count: u64) {
        if self.file.is_none() {
            self.file = private().open(&self.path).ok();
        }
        let line = format!("{count:020} {count:020}\n");
        let written = self.file.as_mut().map(|file| {
            file.rewind()?;
            file.write_all(line.as_bytes())
        });
        if written.is_some_and(|written| written.is_err()) {
            self.file = None;
        }
    }
}
