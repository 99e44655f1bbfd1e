//! Reports of the watchdog, which never wait for a reader or a disk.

use std::io::{self, Write};
use std::path::Path;
use std::sync::mpsc::Receiver;
use std::time::Duration;

use super::note::Note;
use crate::Background;

/// Writes lines to standard error and to the note for the next start. Each has its own thread: a
/// full pipe, a stopped terminal or a hanging file system delays nothing else.
#[derive(Debug)]
pub(super) struct Reporter(Vec<Background<String>>);

impl Reporter {
    /// Starts the threads. A watchdog without them works without reports.
    pub(super) fn start(note: &Path) -> Self {
        let note = note.to_owned();
        let to_note = Background::start("note", WAITING, move |lines: Receiver<String>| {
            let mut note = Note::open(&note);
            for line in lines {
                note.write(&line);
            }
        });
        let to_stderr = Background::start("stderr", WAITING, |lines| {
            // Standard error may be gone with the station.
            for line in lines {
                let _ = writeln!(io::stderr(), "watchdog: {line}");
            }
        });
        Self([to_note, to_stderr].into_iter().flatten().collect())
    }

    /// Reports a line. It is lost if earlier lines still fill the queue.
    pub(super) fn report(&self, line: &str) {
        for thread in &self.0 {
            let _ = thread.push(line.to_owned());
        }
    }

    /// Waits until everything is written, but no longer than this for each of the two.
    pub(super) fn finish(self, within: Duration) {
        for thread in self.0 {
            thread.finish(within);
        }
    }
}

/// The maximum number of waiting lines. A watchdog reports two.
const WAITING: usize = 8;
