//! The repair of all truncated recordings of a folder.

use std::collections::VecDeque;
use std::path::PathBuf;

use crate::repair::{Outcome, Repair};
use crate::{Limits, RecordedFile, folder, is_being_written, recordings};

/// A repair of the truncated recordings of a folder, in small steps.
#[derive(Debug)]
pub(crate) struct Repairs {
    folder: PathBuf,
    limits: Limits,
    /// The files to examine; `None` before the first step.
    waiting: Option<VecDeque<RecordedFile>>,
    current: Option<Repair>,
    repaired: u64,
    left: u64,
}

impl Repairs {
    pub(crate) const fn new(folder: PathBuf, limits: Limits) -> Self {
        Self {
            folder,
            limits,
            waiting: None,
            current: None,
            repaired: 0,
            left: 0,
        }
    }

    /// Continues for some milliseconds; returns whether there is more to do.
    pub(crate) fn step(&mut self) -> bool {
        let Some(repair) = &mut self.current else {
            return self.next();
        };
        match repair.step() {
            None => return true,
            Some(Outcome::Repaired) => self.repaired += 1,
            Some(Outcome::Left) => self.left += 1,
        }
        self.current = None;
        true
    }

    /// The number of repaired files.
    pub(crate) const fn repaired(&self) -> u64 {
        self.repaired
    }

    /// The number of truncated files left unchanged.
    pub(crate) const fn left(&self) -> u64 {
        self.left
    }

    /// Examines the next file; returns whether there was one.
    fn next(&mut self) -> bool {
        let folder = &self.folder;
        let waiting = self.waiting.get_or_insert_with(|| {
            // Files that cannot be deleted or listed do no harm.
            let _ = folder::tidy(folder);
            recordings(folder).unwrap_or_default().into()
        });
        // The latest first: it is the most likely to be opened.
        let Some(file) = waiting.pop_back() else {
            return false;
        };
        let is_whole = folder::has_end_mark(&file.path).unwrap_or(true);
        if is_whole || is_being_written(&file.path) {
            return true;
        }
        self.current = self.begin(&file);
        self.left += u64::from(self.current.is_none());
        true
    }

    /// Starts to repair a file, with room for the new one and for the current recording.
    fn begin(&self, file: &RecordedFile) -> Option<Repair> {
        let limits = self.limits;
        let most = (2 * file.bytes + MIN_BYTES).min(limits.file_bytes.max(file.bytes));
        let room = limits.file_bytes + most;
        if room + file.bytes > limits.total_bytes {
            return None;
        }
        folder::make_room(&self.folder, room, limits.total_bytes).ok()?;
        Repair::begin(&file.path, most).ok()?
    }
}

/// The length of the schemas and the index of a nearly empty file.
const MIN_BYTES: u64 = 256 << 10;
