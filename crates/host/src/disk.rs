//! The station's small files, away from the thread that drives the arm.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Receiver;
use std::time::Duration;

use tokio::sync::mpsc;

use crate::Background;
use crate::handle::Message;
use crate::known_arms::NewText;
use crate::watchdog::take_note;

/// Reads and writes small files in a thread of its own: a disk may take its time, or hang.
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
    /// The operating system's, if it has no thread left.
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

    /// Writes a file. `problem` says in a few words what is lost if that fails.
    ///
    /// # Errors
    ///
    /// What people should know: the disk hangs.
    pub(crate) fn write(&self, new: NewText, problem: &'static str) -> Result<(), String> {
        let pushed = self.0.push(Work::Write { new, problem });
        pushed.map_err(|_| format!("{problem}: the disk does not answer"))
    }

    /// Reports what watchdogs have left in their note.
    pub(crate) fn take_note(&self, note: &Path) {
        // One that is not read now is read at the next start.
        let _ = self.0.push(Work::TakeNote(note.to_owned()));
    }

    /// Waits until all is written, but not for a disk that hangs.
    pub(crate) fn finish(self) {
        self.0.finish(PATIENCE);
    }
}

impl Work {
    /// Does it; what people should know afterwards, a line each.
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

/// Files that wait to be written, at most: people change them, one at a time.
const WAITING: usize = 64;
const PATIENCE: Duration = Duration::from_secs(1);
