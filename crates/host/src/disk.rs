//! Writes of the station's small files, off the arm thread.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;
use std::time::Duration;

use tokio::sync::mpsc;

use crate::Background;
use crate::handle::Message;
use crate::known_arms::NewText;
use crate::watchdog::take_note;

/// Reads and writes small files in a background thread: a disk may be slow or hang.
#[derive(Debug)]
pub(crate) struct Disk(Background<Work>);

#[derive(Debug)]
enum Work {
    Write { new: NewText, problem: &'static str },
    TakeNote(PathBuf),
}

impl Disk {
    /// Starts the thread, which reports failures to the driver.
    ///
    /// # Errors
    ///
    /// The operating system's error if no thread can be started.
    pub(crate) fn start(driver: mpsc::Sender<Message>) -> io::Result<Self> {
        Background::start("disk", WAITING, move |all: Receiver<Work>| {
            for work in all {
                for text in work.done() {
                    // The driver may have ended.
                    let _ = driver.blocking_send(Message::Trouble(text));
                }
            }
        })
        .map(Self)
    }

    /// Writes a file. `problem` states briefly what is lost if that fails.
    ///
    /// # Errors
    ///
    /// The text to report: the disk hangs.
    pub(crate) fn write(&self, new: NewText, problem: &'static str) -> Result<(), String> {
        let pushed = self.0.push(Work::Write { new, problem });
        pushed.map_err(|_| format!("{problem}: the disk does not respond"))
    }

    /// Reports the notes left by watchdogs.
    pub(crate) fn take_note(&self, note: &Path) {
        // A note that is not read now is read at the next start.
        let _ = self.0.push(Work::TakeNote(note.to_owned()));
    }

    /// Waits until all is written, but not for a disk that hangs.
    pub(crate) fn finish(self) {
        self.0.finish(PATIENCE);
    }
}

impl Work {
    /// Does the work; returns lines to report.
    fn done(self) -> Vec<String> {
        match self {
            Self::Write { new, problem } => {
                let failed = new.write().err();
                failed
                    .map(|error| format!("{problem}: {error}"))
                    .into_iter()
                    .collect()
            }
            Self::TakeNote(note) => take_note(&note),
        }
    }
}

/// The maximum number of waiting files: people change them one at a time.
const WAITING: usize = 64;
const PATIENCE: Duration = Duration::from_secs(1);
