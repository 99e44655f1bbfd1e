//! The watchdog's note: a file in the data folder.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::Path;
use std::time::Duration;

use tokio::sync::oneshot;
use tokio::time::Instant;

/// The watchdog's side of the file: locked while the watchdog has the port.
#[derive(Debug)]
pub(super) struct Note(Option<File>);

impl Note {
    /// Opens and locks it. A watchdog without a note still does its work.
    pub(super) fn open(path: &Path) -> Self {
        let mut options = OpenOptions::new();
        options.append(true).create(true);
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        let file = options.open(path).ok();
        // If another watchdog has the lock, it also has the port.
        Self(file.inspect(|file| drop(file.try_lock())))
    }

    /// Adds a line with the time of day.
    pub(super) fn write(&mut self, text: &str) {
        let line = format!("{:.0}: {text}\n", jiff::Timestamp::now());
        if let Some(file) = &mut self.0 {
            // It was written to standard error as well.
            let _ = file.write_all(line.as_bytes());
        }
    }
}

/// Reads the lines left by watchdogs and empties the file.
pub(crate) fn take_note(path: &Path) -> Vec<String> {
    let taken = || -> io::Result<String> {
        if !path.metadata()?.is_file() {
            return Ok(String::new());
        }
        let mut file = OpenOptions::new().read(true).write(true).open(path)?;
        let mut text = String::new();
        file.read_to_string(&mut text)?;
        if !text.is_empty() {
            file.set_len(0)?;
        }
        Ok(text)
    };
    // Usually there is none.
    let text = taken().unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

/// Waits until the watchdog of a previous station has released the port. A file system that does
/// not respond counts as released: switching the laser off must not wait for a disk.
pub(crate) async fn wait_for_watchdog(path: &Path) {
    let latest = Instant::now() + LONGEST;
    while Instant::now() < latest {
        let (answer, locked) = oneshot::channel();
        let path = path.to_owned();
        // In a thread of its own: a runtime would wait for it at its end.
        let asking = std::thread::Builder::new().name("note".into());
        let _ = asking.spawn(move || answer.send(is_locked(&path)));
        match tokio::time::timeout(ANSWER, locked).await {
            Ok(Ok(true)) => tokio::time::sleep(SOON).await,
            _ => return,
        }
    }
}

/// Returns whether a watchdog is running.
fn is_locked(path: &Path) -> bool {
    // Opening a pipe would wait for its other end.
    path.metadata().is_ok_and(|metadata| metadata.is_file())
        && File::open(path).is_ok_and(|file| file.try_lock_shared().is_err())
}

/// Longer than a watchdog runs after its station.
const LONGEST: Duration = Duration::from_secs(6);
/// The time a file system may take for a small query.
const ANSWER: Duration = Duration::from_millis(500);
const SOON: Duration = Duration::from_millis(20);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_note_of_the_watchdog_is_read_once_and_its_lock_is_awaited() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("watchdog.txt");
        wait_for_watchdog(&path).await;
        assert_eq!(take_note(&path), Vec::<String>::new());
        let mut note = Note::open(&path);
        note.write("the station ended");
        note.write("and again");
        let locked = tokio::time::timeout(Duration::from_millis(1), wait_for_watchdog(&path));
        assert!(locked.await.is_err());
        drop(note);
        wait_for_watchdog(&path).await;
        let lines = take_note(&path);
        assert!(lines[0].ends_with("Z: the station ended"), "{lines:?}");
        assert_eq!(lines.len(), 2);
        assert_eq!(take_note(&path), Vec::<String>::new());
    }
}
