//! Synchronous writes to a port.

use std::os::fd::AsFd;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;

/// The outcome of a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WriteOutcome {
    /// This many bytes were accepted.
    Some(usize),
    /// None at the moment.
    Later,
    /// The port is gone.
    Gone,
}

/// Writes what the port accepts without waiting. Blocking mode cannot be set here, because station
/// and watchdog share the port.
pub(super) fn write_some(port: impl AsFd, bytes: &[u8]) -> WriteOutcome {
    match rustix::io::write(port, bytes) {
        Ok(written) => WriteOutcome::Some(written),
        Err(Errno::RETRY_DELAY | Errno::INTR) => WriteOutcome::Later,
        Err(_) => WriteOutcome::Gone,
    }
}

/// Writes all bytes within a time; returns whether that succeeded.
pub(super) fn write_within(port: impl AsFd, mut bytes: &[u8], within: Duration) -> bool {
    let latest = Instant::now() + within;
    while !bytes.is_empty() {
        let mut waited = [PollFd::new(&port, PollFlags::OUT)];
        let left = latest.saturating_duration_since(Instant::now());
        if poll(&mut waited, Some(&timespec(left))) == Ok(0) {
            return false;
        }
        match write_some(&port, bytes) {
            WriteOutcome::Some(written) => bytes = &bytes[written..],
            WriteOutcome::Later if left.is_zero() => return false,
            WriteOutcome::Later => {}
            WriteOutcome::Gone => return false,
        }
    }
    true
}

/// Converts a waiting time, at most a day.
pub(super) fn timespec(time: Duration) -> Timespec {
    let time = time.min(Duration::from_secs(86400));
    Timespec::try_from(time).expect("a day is a number of seconds")
}
