//! A clock that advances while the computer sleeps.

use std::time::Duration;

/// A clock that advances while the computer sleeps, if the system has one (Linux). Elsewhere it
/// stops meanwhile, and a sleep is noticed by its other effects.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    #[cfg(not(target_os = "linux"))]
    started: std::time::Instant,
}

impl Clock {
    pub(crate) fn new() -> Self {
        Self {
            #[cfg(not(target_os = "linux"))]
            started: std::time::Instant::now(),
        }
    }

    /// Returns the time since a fixed moment.
    #[cfg(target_os = "linux")]
    #[expect(clippy::unused_self, reason = "other systems need where it began")]
    pub(crate) fn now(self) -> Duration {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::Boottime);
        Duration::try_from(time).expect("no computer was started before its clock began")
    }

    /// Returns the time since a fixed moment.
    #[cfg(not(target_os = "linux"))]
    pub(crate) fn now(self) -> Duration {
        self.started.elapsed()
    }
}
