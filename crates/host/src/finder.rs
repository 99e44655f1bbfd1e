//! The finder: listens on serial ports until it receives an arm's status.

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

pub use candidate::is_chip_of_arms;
pub(crate) use probe_failures::cause_of_link;
pub use probe_failures::{NothingFound, ProbeFailure};
pub use reconnect::Reconnect;
pub use search::{KnownPort, Search};

/// Searches for the arm.
///
/// It opens a port and listens for five seconds (a stock arm restarts when its port is opened, and
/// sends nothing for two). An arm is found when a valid status arrives, one whose position agrees
/// with its angles. The finder writes nothing to a port except laser off: to an arm that was found,
/// and immediately if the port was named or had the arm before.
///
/// The ports tried are those named in the [`Search`] and no others; if none is named:
///
/// 1. the port where the arm was last found: the same USB chip, wherever it is plugged in now;
/// 2. ports of the USB chips that arms were built with: Arduino Mega (2341:0010, 2341:0042), CH340
///    (1a86:7523), FTDI (0403:6001), CP2102 (10c4:ea60);
/// 3. the other USB serial ports.
///
/// All are tried at 9600 baud, then all at each other speed in the search. Ports that are not USB
/// (`/dev/ttyS0`, Bluetooth) are tried only when named: other devices may be attached, and opening
/// the port may disturb them. For the same reason a port without an arm is not tried again for a
/// minute, or until it is plugged in again, unless it is named or is the arm's.
#[derive(Debug)]
pub struct Finder {
    search: Search,
    failed_attempts: FailedAttempts,
    started: Instant,
}

/// A connected arm.
#[derive(Debug)]
pub struct Found {
    /// Its address.
    pub address: Address,
    /// The open port: opening it again would reset the arm.
    pub link: Link,
    /// The bytes received, at most the last 4096.
    pub bytes: Vec<u8>,
}

/// The finder's progress.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FinderNews {
    /// Listening to a port.
    Listening {
        /// The port.
        address: Address,
        /// The attached device, if the system reports it.
        device: Option<String>,
    },
    /// No arm at a port.
    Failed {
        /// The port.
        address: Address,
        /// The reason.
        why: String,
        /// How to fix it.
        hint: Option<String>,
    },
}

impl Finder {
    /// Creates a finder.
    #[must_use]
    pub fn new(search: Search) -> Self {
        Self {
            search,
            failed_attempts: FailedAttempts::default(),
            started: Instant::now(),
        }
    }

    /// Returns where an arm was last found, to save for the next start.
    #[must_use]
    pub const fn last(&self) -> Option<&KnownPort> {
        self.search.last.as_ref()
    }

    /// Tries each port once, reporting each; returns the first arm found.
    ///
    /// # Errors
    ///
    /// [`NothingFound`], with the reason for each port.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn find(&mut self, report: impl FnMut(FinderNews)) -> Result<Found, NothingFound> {
        let listed = tokio::task::spawn_blocking(dobot_session::ports).await;
        match listed.map_err(io::Error::other).flatten() {
            Ok(ports) => self.find_among(&ports, report).await,
            // The named ports can still be tried.
            Err(error) => {
                let found = self.find_among(&[], report).await;
                found.map_err(|nothing| nothing.without_list(&error))
            }
        }
    }

    async fn find_among(
        &mut self,
        ports: &[Port],
        mut report: impl FnMut(FinderNews),
    ) -> Result<Found, NothingFound> {
        let Choice {
            candidates,
            passed_over,
        } = choose(&self.search, ports);
        self.failed_attempts.keep(&candidates);
        let mut failures = Vec::new();
        for candidate in candidates {
            match self.try_one(&candidate, &mut report).await {
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
        report: &mut impl FnMut(FinderNews),
    ) -> Result<Found, ProbeFailure> {
        let now = self.started.elapsed();
        if let Some(why) = self.failed_attempts.reason_to_wait(candidate, now) {
            return Err(ProbeFailure::Before(why.clone()));
        }
        tracing::debug!(address = %candidate.address, device = candidate.device, "listening for an arm");
        report(FinderNews::Listening {
            address: candidate.address.clone(),
            device: candidate.device.clone(),
        });
        let heard = listen(candidate).await;
        if let Err(failure) = &heard {
            self.note_failure(candidate, failure, report);
        }
        heard
    }

    fn note_failure(
        &mut self,
        candidate: &Candidate,
        failure: &ProbeFailure,
        report: &mut impl FnMut(FinderNews),
    ) {
        tracing::debug!(address = %candidate.address, why = %failure, "no arm is heard there");
        self.failed_attempts
            .note(candidate, failure, self.started.elapsed());
        report(FinderNews::Failed {
            address: candidate.address.clone(),
            why: failure.to_string(),
            hint: failure.hint(),
        });
    }
}

/// Opens a port and listens for an arm. A known arm's laser is switched off before anything is
/// received, otherwise when the first status arrives.
async fn listen(candidate: &Candidate) -> Result<Found, ProbeFailure> {
    let address = &candidate.address;
    let mut link = Link::open(address).await?;
    if candidate.sure {
        darken(&mut link).await;
    }
    let mut listening = Listening::new();
    let mut some = Vec::new();
    while link.now() < Listening::UNTIL {
        let open = link.receive(Listening::UNTIL, &mut some).await;
        if listening.handle_bytes(&some) {
            darken(&mut link).await;
            return Ok(Found {
                address: address.clone(),
                link,
                bytes: listening.into_bytes(),
            });
        }
        if let Err(error) = check_open(open) {
            let received = listening.no_status();
            return Err(ProbeFailure::Link { error, received });
        }
        some.clear();
    }
    Err(ProbeFailure::NoStatus(listening.no_status()))
}

/// Turns the end of a link into an error.
pub(crate) fn check_open(received: Result<bool, LinkError>) -> Result<(), LinkError> {
    received?.then_some(()).ok_or(LinkError::Closed)
}

/// Sends laser off, whatever the arm was sent before.
pub(crate) async fn darken(link: &mut Link) {
    link.send(&LASER_OFF.emit(&Dialect::SPECIFICATION).to_bytes());
    // Reading a broken link reports the error.
    let _ = link.flush().await;
}

#[cfg(test)]
mod tests;
