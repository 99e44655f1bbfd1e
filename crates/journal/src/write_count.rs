//! How many writes a journal has had, noted beside it.

use std::fs::File;
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use crate::store::private;

/// The file beside a journal in which the number of its last write stands twice.
///
/// The database falls back to the write before where its newest one is damaged, and cannot tell; this file can. It is
/// written behind each write and does not wait for the disk, so it is never ahead of a journal that is whole. Where it
/// cannot be read or written, nothing is told and nothing fails: jobs do not depend on it.
#[derive(Debug)]
pub(crate) struct WriteCount {
    path: PathBuf,
    file: Option<File>,
}

impl WriteCount {
    /// The one of a journal.
    pub(crate) fn beside(journal: &Path) -> Self {
        let mut path = journal.as_os_str().to_owned();
        path.push(".writes");
        Self {
            path: path.into(),
            file: None,
        }
    }

    /// The number of the last write; 0 where it is not known.
    pub(crate) fn read(&self) -> u64 {
        let mut text = String::new();
        let read = File::open(&self.path).and_then(|mut it| it.read_to_string(&mut text));
        let numbers: Vec<&str> = text.split_whitespace().collect();
        match numbers[..] {
            [one, other] if read.is_ok() && one == other => one.parse().unwrap_or(0),
            _ => 0,
        }
    }

    /// Notes the number of a write that is on the disk.
    pub(crate) fn note(&mut self, count: u64) {
        if self.file.is_none() {
            self.file = private().open(&self.path).ok();
        }
        let line = format!("{count:020} {count:020}\n");
        let written = self.file.as_mut().map(|it| {
            it.rewind()?;
            it.write_all(line.as_bytes())
        });
        if written.is_some_and(|it| it.is_err()) {
            self.file = None;
        }
    }
}
