//! Finds the arm: listens on serial ports until one of them tells where an arm is.

mod candidate;
mod failed_attempts;
mod listening;
mod probe_failures;
mod reconnect;
mod search;

use std::io;

use dobot_motion::LASER_OFF;
use dobot_session::{Address, Link, LinkError, Port};
use dobot_wire::Dialect;
use tokio::time::Instant;

use self::candidate::{Candidate, Choice, choose};
use self::failed_attempts::FailedAttempts;
use self::listening::Listening;

pub use probe_failures::{NothingFound, ProbeFailure};
pub use reconnect::Reconnect;
pub use search::{Search, WhereFound};

/// Finds the arm.
///
/// A port is opened and listened to for five seconds (a stock arm starts anew when its port is
/// opened, and says nothing for two); the arm is where a valid status comes from, one whose position
/// agrees with its angles. Nothing is written to a port by the finder but laser off: to an arm that
/// was found, and at once where a person has named the port or the arm was found before.
///
/// Which ports are tried: those that the [`Search`] names, and no others; or else
///
/// 1. the port where the arm was found last: the same USB chip, wherever it is plugged in now;
/// 2. ports of the USB chips that arms were built with: Arduino Mega (2341:0010, 2341:0042), CH340
///    (1a86:7523), FTDI (0403:6001), CP2102 (10c4:ea60);
/// 3. the other USB serial ports.
///
/// All of them at 9600 baud, then all of them at each other speed that the search tells. Ports that
/// are not USB (`/dev/ttyS0`, Bluetooth) are tried only when named: what is behind them is not an arm,
/// and opening may disturb it. For the same reason a port that was found to be something else is left
/// alone for a minute, or until it is plugged in again, unless it is named or is the arm's.
#[derive(Debug)]
pub struct Finder {
    search: Search,
    failed_attempts: FailedAttempts,
    started: Instant,
}

/// An arm, with its port open.
#[derive(Debug)]
pub struct Found {
    /// Where it is reached.
    pub address: Address,
    /// The open port: to open it once more would reset the arm.
    pub link: Link,
    /// What was received so far, the last 4096 bytes of it.
    pub bytes: Vec<u8>,
}

/// What the finder does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FinderNews {
    /// It listens to a port.
    Listening {
        /// Which one.
        address: Address,
        /// What is plugged in there, where the system tells.
        device: Option<String>,
    },
    /// There is no arm to be heard.
    Failed {
        /// Where.
        address: Address,
        /// Why not.
        why: String,
        /// What to do about it.
        hint: Option<String>,
    },
}

impl Finder {
    /// A finder that has not looked yet.
    #[must_use]
    pub fn new(search: Search) -> Self {
        Self {
            search,
            failed_attempts: FailedAttempts::default(),
            started: Instant::now(),
        }
    }

    /// Where an arm was found last, to be remembered for the next start.
    #[must_use]
    pub const fn last(&self) -> Option<&WhereFound> {
        self.search.last.as_ref()
    }

    /// Tries each port once and tells of it; the first arm that is found is it.
    ///
    /// # Errors
    ///
    /// [`NothingFound`], with the reason for each port.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn find(&mut self, tell: impl FnMut(FinderNews)) -> Result<Found, NothingFound> {
        let listed = tokio::task::spawn_blocking(dobot_session::ports).await;
        match listed.map_err(io::Error::other).flatten() {
            Ok(ports) => self.find_among(&ports, tell).await,
            // The ports that are named can be tried all the same.
            Err(error) => {
                let found = self.find_among(&[], tell).await;
                found.map_err(|nothing| nothing.without_list(&error))
            }
        }
    }

    async fn find_among(
        &mut self,
        ports: &[Port],
        mut tell: impl FnMut(FinderNews),
    ) -> Result<Found, NothingFound> {
        let Choice {
            candidates,
            passed_over,
        } = choose(&self.search, ports);
        self.failed_attempts.keep(&candidates);
        let mut failures = Vec::new();
        for candidate in candidates {
            match self.try_one(&candidate, &mut tell).await {
                Ok(found) => {
                    self.search.last = candidate.place().or(self.search.last.take());
                    return Ok(found);
                }
                Err(why) => failures.push((candidate.address, why)),
            }
        }
        Err(NothingFound::new(failures, passed_over))
    }

    async fn try_one(
        &mut self,
        candidate: &Candidate,
        tell: &mut impl FnMut(FinderNews),
    ) -> Result<Found, ProbeFailure> {
        let now = self.started.elapsed();
        if let Some(why) = self.failed_attempts.reason_to_wait(candidate, now) {
            return Err(ProbeFailure::Before {
                why: why.to_owned(),
            });
        }
        tracing::debug!(address = %candidate.address, device = candidate.device, "listening for an arm");
        tell(FinderNews::Listening {
            address: candidate.address.clone(),
            device: candidate.device.clone(),
        });
        let failure = match listen(candidate).await {
            Ok(found) => return Ok(found),
            Err(failure) => failure,
        };
        tracing::debug!(address = %candidate.address, why = %failure, "no arm is heard there");
        self.failed_attempts
            .note(candidate, &failure, self.started.elapsed());
        tell(FinderNews::Failed {
            address: candidate.address.clone(),
            why: failure.to_string(),
            hint: failure.hint(),
        });
        Err(failure)
    }
}

/// Opens a port and listens until an arm is heard. Where it is known to be an arm, its laser is
/// switched off before it says anything; where it shows to be one, in that moment.
async fn listen(candidate: &Candidate) -> Result<Found, ProbeFailure> {
    let address = &candidate.address;
    let mut link = Link::open(address).await?;
    if candidate.sure {
        darken(&mut link).await;
    }
    let mut listening = Listening::new();
    let mut some = Vec::new();
    while link.now() < Listening::UNTIL {
        let open = match link.receive(Listening::UNTIL, &mut some).await {
            Ok(open) => open,
            Err(LinkError::Broken(source)) => return Err(ProbeFailure::Broken(source)),
            Err(_) => false,
        };
        if listening.handle_bytes(&some) {
            darken(&mut link).await;
            return Ok(Found {
                address: address.clone(),
                link,
                bytes: listening.into_bytes(),
            });
        }
        if !open {
            return Err(ProbeFailure::Closed);
        }
        some.clear();
    }
    Err(listening.failure())
}

/// Laser off: whatever the arm was told before, and whoever told it.
pub(crate) async fn darken(link: &mut Link) {
    link.send(&LASER_OFF.emit(&Dialect::SPECIFICATION).to_bytes());
    // A link that is broken says so to whoever listens next.
    let _ = link.flush().await;
}

#[cfg(test)]
mod tests;
