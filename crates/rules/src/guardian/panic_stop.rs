//! What is sent to the arm when a part of the station panics.

use std::sync::{Mutex, PoisonError};

#[cfg(unix)]
use std::os::fd::OwnedFd;
#[cfg(unix)]
use std::time::Duration;

use super::Hazards;

/// The arm's port and what the arm was told, kept apart from the thread that has the arm: when that
/// panics, laser off and the release are sent all the same, at once and without its help.
#[derive(Debug, Default)]
pub(crate) struct PanicStop(Mutex<GuardedPort>);

#[derive(Debug, Default)]
struct GuardedPort {
    hazards: Hazards,
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

impl PanicStop {
    /// Takes what the arm is told now.
    pub(crate) fn note(&self, hazards: Hazards) {
        self.lock().hazards = hazards;
    }

    /// Takes by which port the arm is reached; none while there is no link.
    #[cfg(unix)]
    pub(crate) fn set_port(&self, port: Option<OwnedFd>) {
        self.lock().port = port;
    }

    /// The same port once more; none while there is no link.
    ///
    /// # Errors
    ///
    /// What the system says.
    #[cfg(unix)]
    pub(crate) fn port(&self) -> std::io::Result<Option<OwnedFd>> {
        self.lock()
            .port
            .as_ref()
            .map(OwnedFd::try_clone)
            .transpose()
    }

    /// Sends laser off and the release, without anything that may have panicked; the guardian sends them again.
    #[cfg(unix)]
    pub(crate) fn send(&self) {
        let known = self.lock();
        let Some(port) = &known.port else {
            return;
        };
        for packet in known.hazards.stop_packets() {
            // A port that takes nothing helps nobody; the guardian tries on.
            super::port::write_within(port, &packet.to_bytes(), PATIENCE);
            std::thread::sleep(super::GAP);
        }
    }

    /// Without a port there is nothing to send to.
    #[cfg(not(unix))]
    pub(crate) fn send(&self) {}

    fn lock(&self) -> std::sync::MutexGuard<'_, GuardedPort> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// So long a port may take for a packet.
#[cfg(unix)]
const PATIENCE: Duration = Duration::from_millis(100);
