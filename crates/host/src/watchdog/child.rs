//! The watchdog child process, as seen by the station.

use std::io::{self, ErrorKind, Write};
use std::os::fd::OwnedFd;
use std::path::Path;
use std::process::{ChildStdin, Command, Stdio};

use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};

use super::Heartbeat;

/// The watchdog child process, which receives heartbeats. When this is dropped without a goodbye,
/// the watchdog stops the arm.
#[derive(Debug)]
pub(super) struct Child {
    heartbeats: ChildStdin,
}

impl Child {
    /// Starts the process with the arm's port.
    ///
    /// # Errors
    ///
    /// The operating system's error.
    pub(super) fn start(program: &Path, note: &Path, port: OwnedFd) -> io::Result<Self> {
        let mut child = Command::new(program)
            .arg("watchdog")
            .arg("--note")
            .arg(note)
            .stdin(Stdio::piped())
            .stdout(Stdio::from(port))
            .spawn()?;
        let heartbeats = child.stdin.take().expect("it is piped");
        // The arm must never wait for its watchdog.
        fcntl_setfl(&heartbeats, fcntl_getfl(&heartbeats)? | OFlags::NONBLOCK)?;
        let waiting = std::thread::Builder::new().name("watchdog".into());
        waiting.spawn(move || {
            // Reap the process.
            let _ = child.wait();
        })?;
        Ok(Self { heartbeats })
    }

    /// Sends a heartbeat.
    ///
    /// # Errors
    ///
    /// The operating system's error if the watchdog is gone.
    pub(super) fn send(&mut self, heartbeat: Heartbeat) -> io::Result<()> {
        match self.heartbeats.write(&[heartbeat.to_byte()]) {
            // It reads too slowly: it hangs.
            Err(error) if error.kind() == ErrorKind::WouldBlock => Ok(()),
            sent => sent.map(drop),
        }
    }
}
