//! A virtual arm that plays a recording back.

use std::fmt;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use data_encoding::HEXLOWER;
use dobot_session::Peer;

use crate::playback::Playback;
use crate::{Damage, OpenError};

/// A virtual arm that plays a recording back: it sends what the arm sent, at the times at which it
/// did, and compares what its client sends with what was recorded. So a bug report becomes a test.
///
/// Time is virtual, begins with the first byte on the wire, and passes when somebody waits. Clones
/// share the arm: one is given to a `Connection`, another tells what came of it.
#[derive(Clone, Debug)]
pub struct Replay {
    playback: Arc<Mutex<Playback>>,
}

/// What came of a replay.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Packets that the client sent as recorded.
    pub same: u64,
    /// The first hundred packets that it did not.
    pub differences: Vec<Difference>,
    /// Differences beyond those hundred.
    pub more: u64,
    /// The greatest time between sending a packet and when it was recorded.
    pub furthest_apart: Duration,
    /// Bytes that the client sent and that belong to no packet.
    pub noise_bytes: u64,
    /// Bytes of that kind that were recorded.
    pub recorded_noise_bytes: u64,
    /// Where the recording breaks off, if it does and was played to there.
    pub damage: Option<Damage>,
}

/// A packet that the client did not send as recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// When it was sent or, if it was not, recorded: since the recorder was started.
    pub at: Duration,
    /// What was recorded; `None` where nothing more was.
    pub recorded: Option<[u8; 42]>,
    /// What the client sent; `None` where it sent nothing more.
    pub sent: Option<[u8; 42]>,
}

impl Replay {
    /// Plays a recording back.
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

    /// When the arm sends next, or the recording ends, by the replay's own time; `None` when it is
    /// over.
    #[must_use]
    pub fn poll_wakeup(&self) -> Option<Duration> {
        self.playback().poll_wakeup()
    }

    /// What came of it until now: what was recorded up to now and was not sent is a difference.
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
    /// Whether the client did what was recorded.
    #[must_use]
    pub const fn is_same(&self) -> bool {
        self.differences.is_empty() && self.noise_bytes == self.recorded_noise_bytes
    }

    /// Takes note of a difference.
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
            "at {:.3} s the client sent {}, recorded was {}",
            self.at.as_secs_f64(),
            text(&self.sent),
            text(&self.recorded)
        )
    }
}

/// So many differences are told one by one.
const LISTED: usize = 100;
