//! Notifications to the service manager (the `sd_notify` protocol of systemd).
//!
//! The crate `sd-notify` uses a blocking socket, which could delay the arm, and does not support
//! abstract names (`@...`).

use std::time::Duration;

#[cfg(unix)]
use std::os::unix::net::{SocketAddr, UnixDatagram};

/// The service manager that runs this program, if any: systemd, found through the environment
/// variables `NOTIFY_SOCKET` and `WATCHDOG_USEC`.
#[derive(Debug, Default)]
pub struct ServiceManager {
    #[cfg(unix)]
    socket: Option<(UnixDatagram, SocketAddr)>,
    watchdog: Option<Duration>,
}

/// A notification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notification {
    /// The station has started.
    Ready,
    /// The arm thread is running.
    Alive,
    /// The station is ending.
    Stopping,
}

impl ServiceManager {
    /// Returns the service manager named by the environment; without one, notifications are
    /// dropped.
    #[must_use]
    pub fn of_environment() -> Self {
        let number = |name| std::env::var(name).ok()?.parse::<u64>().ok();
        let is_ours = number("WATCHDOG_PID").is_none_or(|pid| pid == u64::from(std::process::id()));
        let watchdog = number("WATCHDOG_USEC").filter(|timeout_us| is_ours && *timeout_us > 0);
        Self {
            #[cfg(unix)]
            socket: std::env::var("NOTIFY_SOCKET")
                .ok()
                .and_then(|socket| connect(&socket)),
            watchdog: watchdog.map(Duration::from_micros),
        }
    }

    /// Returns the interval of alive notifications, if required: a quarter of its timeout.
    #[must_use]
    pub(crate) fn period(&self) -> Option<Duration> {
        self.watchdog.map(|watchdog| watchdog / 4)
    }

    /// Sends a notification.
    #[cfg(unix)]
    pub fn notify(&self, notification: Notification) {
        if let Some((socket, address)) = &self.socket {
            // It may be gone.
            let _ = socket.send_to_addr(notification.text(), address);
        }
    }

    /// This system has none.
    #[cfg(not(unix))]
    pub fn notify(&self, _: Notification) {}
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
    // The arm must never wait for it.
    socket.set_nonblocking(true).ok()?;
    Some((socket, address))
}

/// An abstract name.
#[cfg(target_os = "linux")]
fn hidden(name: &str) -> Option<SocketAddr> {
    use std::os::linux::net::SocketAddrExt;
    SocketAddr::from_abstract_name(name).ok()
}

#[cfg(all(unix, not(target_os = "linux")))]
fn hidden(_: &str) -> Option<SocketAddr> {
    None
}
