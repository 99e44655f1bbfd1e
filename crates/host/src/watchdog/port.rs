//! A port that is written to without anything asynchronous around it.

use std::os::fd::AsFd;
use std::time::{Duration, Instant};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;

/// What a port says to bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Taken {
    /// It took so many.
    Some(usize),
    /// None just now.
    Later,
    /// None any more.
    Gone,
}

/// Writes what the port takes without waiting. Whether it waits is not ours to say: the station and
/// its watchdog share that.
pub(super) fn write_some(port: impl AsFd, bytes: &[u8]) -> Taken {
    match rustix::io::write(port, bytes) {
        Ok(written) => Taken::Some(written),
        Err(Errno::AGAIN | Errno::INTR) => Taken::Later,
        Err(_) => Taken::Gone,
    }
}

/// Writes all of it within a while; says whether that was done.
pub(super) fn write_within(port: impl AsFd, mut bytes: &[u8], within: Duration) -> bool {
    let latest = Instant::now() + within;
    while !bytes.is_empty() {
        let mut waited = [PollFd::new(&port, PollFlags::OUT)];
        let left = latest.saturating_duration_since(Instant::now());
        if poll(&mut waited, Some(&timespec(left))) == Ok(0) {
            return false;
        }
        match write_some(&port, bytes) {
            Taken::Some(written) => bytes = &bytes[written..],
            Taken::Later if left.is_zero() => return false,
            Taken::Later => {}
            Taken::Gone => return false,
        }
    }
    true
}

/// A time to wait, at the most a day.
pub(super) fn timespec(time: Duration) -> Timespec {
    let time = time.min(Duration::from_secs(86400));
    Timespec::try_from(time).expect("a day is a number of seconds")
}
