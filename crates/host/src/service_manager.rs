//! What the system that keeps a service running is told (the protocol of `sd_notify`, systemd).
//!
//! The crate `sd-notify` sends on a blocking socket, for which the arm would wait, and knows no abstract names (`@...`).

use std::time::Duration;

#[cfg(unix)]
use std::os::unix::net::{SocketAddr, UnixDatagram};

/// The system that keeps this program running as a service, if one does: systemd, by the environment
/// variables `NOTIFY_SOCKET` and `WATCHDOG_USEC`.
#[derive(Debug, Default)]
pub struct ServiceManager {
    #[cfg(unix)]
    socket: Option<(UnixDatagram, SocketAddr)>,
    watchdog: Option<Duration>,
}

/// What it is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notification {
    /// The station is there.
    Ready,
    /// The thread that has the arm is at work.
    Alive,
    /// The station ends.
    Stopping,
}

impl ServiceManager {
    /// The one that the environment names; nobody where it names none.
    #[must_use]
    pub fn of_environment() -> Self {
        let number = |name| std::env::var(name).ok()?.parse::<u64>().ok();
        let is_ours = number("WATCHDOG_PID").is_none_or(|it| it == u64::from(std::process::id()));
        let watchdog = number("WATCHDOG_USEC").filter(|it| is_ours && *it > 0);
        Self {
            #[cfg(unix)]
            socket: std::env::var("NOTIFY_SOCKET")
                .ok()
                .and_then(|it| connect(&it)),
            watchdog: watchdog.map(Duration::from_micros),
        }
    }

    /// How often it wants to hear that the station is alive, if it does: four times as often as it
    /// would lose patience.
    #[must_use]
    pub(crate) fn period(&self) -> Option<Duration> {
        self.watchdog.map(|it| it / 4)
    }

    /// Tells it.
    #[cfg(unix)]
    pub fn tell(&self, notification: Notification) {
        if let Some((socket, address)) = &self.socket {
            // One that is gone misses nothing.
            let _ = socket.send_to_addr(notification.text(), address);
        }
    }

    /// There is none on this system.
    #[cfg(not(unix))]
    pub fn tell(&self, _: Notification) {}
}

impl Notification {
    #[cfg(unix)]
    const fn text(self) -> &'static [u8] {
        match self {
            Self::Ready => b"READY=1",
            Self::Alive => b"WATCHDOG=1",
            Self::Stopping => b"STOPPING=1",
        }
    }
}

#[cfg(unix)]
fn connect(name: &str) -> Option<(UnixDatagram, SocketAddr)> {
    let address = match name.strip_prefix('@') {
        Some(name) => hidden(name)?,
        None => SocketAddr::from_pathname(name).ok()?,
    };
    let socket = UnixDatagram::unbound().ok()?;
    // The arm never waits for it.
    socket.set_nonblocking(true).ok()?;
    Some((socket, address))
}

/// A name that is no file.
#[cfg(target_os = "linux")]
fn hidden(name: &str) -> Option<SocketAddr> {
    use std::os::linux::net::SocketAddrExt;
    SocketAddr::from_abstract_name(name).ok()
}

#[cfg(all(unix, not(target_os = "linux")))]
fn hidden(_: &str) -> Option<SocketAddr> {
    None
}
