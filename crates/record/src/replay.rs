//! A virtual arm that plays a recording back.

use std::fmt;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use data_encoding::HEXLOWER;
use dobot_session::Peer;

use crate::playback::Playback;
use crate::{Damage, OpenError};

/// A virtual arm that plays a recording back: it sends the recorded bytes of the arm at their
/// times, and compares the bytes of its client with the recorded ones. This turns a bug report into
/// a test.
///
/// Time is virtual, starts with the first byte on the wire, and passes while somebody waits. Clones
/// share the arm: give one to a `Connection` and keep another for the result.
#[derive(Clone, Debug)]
pub struct Replay {
    playback: Arc<Mutex<Playback>>,
}

/// The result of a replay.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// The number of packets sent as recorded.
    pub same: u64,
    /// The first hundred differences.
    pub differences: Vec<Difference>,
    /// The number of further differences.
    pub more: u64,
    /// The largest difference between the sending and the recorded time of a packet.
    pub furthest_apart: Duration,
    /// The number of bytes from the client that belong to no packet.
    pub noise_bytes: u64,
    /// The number of recorded bytes of that kind.
    pub recorded_noise_bytes: u64,
    /// The damage of the recording, if the replay reached it.
    pub damage: Option<Damage>,
}

/// A packet that differs from the recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The time when it was sent or, if it was not, recorded, since the start of the recorder.
    pub at: Duration,
    /// The recorded packet; `None` if there was none left.
    pub recorded: Option<[u8; 42]>,
    /// The packet of the client; `None` if it sent no more.
    pub sent: Option<[u8; 42]>,
}

impl Replay {
    /// Opens a recording for replay.
    ///
    /// # Errors
    ///
    /// [`OpenError`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        let path = path.as_ref();
        let playback = Playback::new(crate::Recording::open(path)?, crate::Recording::open(path)?);
        Ok(Self {
            playback: Arc::new(Mutex::new(playback)),
        })
    }

    /// The replay time of the next bytes of the arm or of the end; `None` after the end.
    #[must_use]
    pub fn poll_wakeup(&self) -> Option<Duration> {
        self.playback().poll_wakeup()
    }

    /// Returns the result so far; packets recorded up to now that were not sent are differences.
    #[must_use]
    pub fn report(&self) -> Report {
        self.playback().report()
    }

    fn playback(&self) -> MutexGuard<'_, Playback> {
        self.playback.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Peer for Replay {
    fn now(&self) -> Duration {
        self.playback().now()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.playback().handle_bytes(bytes);
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        self.playback().receive(until, bytes)
    }
}

impl Report {
    /// Whether the client behaved as recorded.
    #[must_use]
    pub const fn is_same(&self) -> bool {
        self.differences.is_empty() && self.noise_bytes == self.recorded_noise_bytes
    }

    /// Adds a difference.
    pub(crate) fn push(&mut self, difference: Difference) {
        if self.differences.len() < LISTED {
            self.differences.push(difference);
        } else {
            self.more += 1;
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |packet: &Option<[u8; 42]>| {
            packet.map_or_else(|| "nothing".to_owned(), |packet| HEXLOWER.encode(&packet))
        };
        write!(
            f,
            "at {:.3} s the client sent {}; the recording has {}",
            self.at.as_secs_f64(),
            text(&self.sent),
            text(&self.recorded)
        )
    }
}

/// The number of differences listed individually.
const LISTED: usize = 100;
