//! What is said to the arm when something of the station panics.

use std::sync::{Mutex, PoisonError};

#[cfg(unix)]
use std::os::fd::OwnedFd;
#[cfg(unix)]
use std::time::Duration;

use super::Told;

/// The arm's port and what the arm was told, kept apart from the thread that has the arm: when that
/// panics, laser off and the release are said all the same, at once and without its help.
#[derive(Debug, Default)]
pub(crate) struct LastWords(Mutex<Known>);

#[derive(Debug, Default)]
struct Known {
    told: Told,
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

impl LastWords {
    /// Takes what the arm is told now.
    pub(crate) fn note(&self, told: Told) {
        self.lock().told = told;
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

    /// Says them, without anything that may have panicked; the guardian says them again.
    #[cfg(unix)]
    pub(crate) fn say(&self) {
        let known = self.lock();
        let Some(port) = &known.port else {
            return;
        };
        for packet in known.told.last_words() {
            // A port that takes nothing helps nobody; the guardian tries on.
            super::port::write_within(port, &packet.to_bytes(), PATIENCE);
            std::thread::sleep(super::GAP);
        }
    }

    /// Without a port there is nothing to say them to.
    #[cfg(not(unix))]
    pub(crate) fn say(&self) {}

    fn lock(&self) -> std::sync::MutexGuard<'_, Known> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// So long a port may take for a packet.
#[cfg(unix)]
const PATIENCE: Duration = Duration::from_millis(100);
