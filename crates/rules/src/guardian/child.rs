//! The guardian as the station sees it: a child process.

use std::io::{self, ErrorKind, Write};
use std::os::fd::OwnedFd;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{ChildStdin, Command, Stdio};

use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};

use super::Beat;

/// The guardian as the station sees it: a child process that is told beats. When this is dropped
/// without a goodbye, the guardian speaks.
#[derive(Debug)]
pub(super) struct Child {
    beats: ChildStdin,
}

impl Child {
    /// Starts it, with the arm's port.
    ///
    /// # Errors
    ///
    /// What the system says.
    pub(super) fn start(program: &Path, note: &Path, port: OwnedFd) -> io::Result<Self> {
        let mut child = Command::new(program)
            .arg("guardian")
            .arg("--note")
            .arg(note)
            .stdin(Stdio::piped())
            .stdout(Stdio::from(port))
            // Ctrl-C is for the station, which says goodbye then.
            .process_group(0)
            .spawn()?;
        let beats = child.stdin.take().expect("it is piped");
        // The arm never waits for its guardian.
        fcntl_setfl(&beats, fcntl_getfl(&beats)? | OFlags::NONBLOCK)?;
        let waiting = std::thread::Builder::new().name("guardian".into());
        waiting.spawn(move || {
            // Otherwise the system would keep what is left of it.
            let _ = child.wait();
        })?;
        Ok(Self { beats })
    }

    /// Tells it something.
    ///
    /// # Errors
    ///
    /// What the system says when the guardian is gone.
    pub(super) fn say(&mut self, beat: Beat) -> io::Result<()> {
        match self.beats.write(&[beat.to_byte()]) {
            // It has more to read than it can: it stands still.
            Err(error) if error.kind() == ErrorKind::WouldBlock => Ok(()),
            said => said.map(drop),
        }
    }
}
