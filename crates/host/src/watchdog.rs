//! The watchdog: stops the arm when the station goes silent.

#[cfg(unix)]
mod child;
mod clock;
mod heartbeat;
mod heartbeat_sender;
mod note;
mod panic_stop;
#[cfg(unix)]
mod port;
#[cfg(unix)]
mod process;
#[cfg(unix)]
mod reporter;

use std::time::Duration;

use dobot_wire::Packet;

pub use heartbeat::{Hazards, Heartbeat, JogKind};
pub(crate) use heartbeat_sender::HeartbeatSender;
pub(crate) use note::{take_note, wait_for_watchdog};
pub(crate) use panic_stop::PanicStop;
#[cfg(unix)]
pub use process::guard;

/// The watchdog of an arm, as an engine: it owns no port, process or clock.
///
/// The station sends it [`Heartbeat`]s, at least ten per second. If the station ends without a
/// goodbye, or is silent for [`PATIENCE`](Self::PATIENCE), the watchdog switches the laser off and
/// releases the held button: at least three times, with the gap between packets that a stock arm
/// needs (note N26). While the station lives it sends nothing.
///
/// If something burns, laser off comes first, and a jog stops abruptly. Otherwise the release comes
/// first, and the arm slows down. Either way the release is of the same kind as the jog, because a
/// release of the other kind makes a stock arm slow down another axis (note N44).
///
/// ```
/// use std::time::Duration;
/// use dobot_host::{Heartbeat, Watchdog, Hazards};
///
/// let ms = Duration::from_millis;
/// let mut watchdog = Watchdog::new(ms(0));
/// watchdog.handle_heartbeat(ms(100), Heartbeat::Alive(Hazards::default()));
/// watchdog.handle_time(ms(399));
/// assert!(watchdog.poll_bytes().is_none());
/// watchdog.handle_time(ms(400));
/// assert!(watchdog.poll_bytes().is_some()); // laser off
/// ```
#[derive(Clone, Debug)]
pub struct Watchdog {
    now: Duration,
    hazards: Hazards,
    /// When the last heartbeat arrived.
    last_heartbeat: Duration,
    phase: WatchdogPhase,
}

/// Why the watchdog acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Silence {
    /// The station ended without a goodbye: it was killed, or panicked.
    Ended,
    /// The station hangs.
    Stalled,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WatchdogPhase {
    Watching,
    Stopping(StopRounds),
    /// Everything has been sent to the arm of a hanging station.
    Stopped(Silence),
    Over,
}

/// The packets being sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct StopRounds {
    why: Silence,
    started: Duration,
    /// When the next packet is due.
    next: Duration,
    /// The packets of this round already sent.
    sent: usize,
    /// The completed rounds.
    rounds: u32,
    /// Whether the arm has sent since the last round, so it has room for another.
    received: bool,
}

impl Watchdog {
    /// The longest allowed silence of the station.
    pub const PATIENCE: Duration = Duration::from_millis(300);

    /// Creates the watchdog of a running station.
    #[must_use]
    pub fn new(now: Duration) -> Self {
        Self {
            now,
            hazards: Hazards::default(),
            last_heartbeat: now,
            phase: WatchdogPhase::Watching,
        }
    }

    /// Handles a heartbeat. A station that hung and is back acts for itself.
    pub fn handle_heartbeat(&mut self, now: Duration, heartbeat: Heartbeat) {
        self.now = now;
        match heartbeat {
            _ if self.phase == WatchdogPhase::Over => {}
            Heartbeat::Goodbye => self.phase = WatchdogPhase::Over,
            Heartbeat::Alive(hazards) => {
                self.hazards = hazards;
                self.last_heartbeat = now;
                self.phase = WatchdogPhase::Watching;
            }
        }
    }

    /// Handles the end of the station, which is fine after a goodbye.
    pub fn handle_end(&mut self, now: Duration) {
        self.now = now;
        match &mut self.phase {
            WatchdogPhase::Watching => self.speak(Silence::Ended),
            WatchdogPhase::Stopping(rounds) => rounds.why = Silence::Ended,
            // The arm was stopped, and nothing came from the station since.
            WatchdogPhase::Stopped(_) => self.phase = WatchdogPhase::Over,
            WatchdogPhase::Over => {}
        }
    }

    /// Handles bytes from the arm: it has room for a packet.
    pub fn handle_reply(&mut self, now: Duration) {
        self.handle_time(now);
        if let WatchdogPhase::Stopping(rounds) = &mut self.phase {
            rounds.received = true;
        }
    }

    /// Advances the time.
    pub fn handle_time(&mut self, now: Duration) {
        self.now = now;
        if self.phase == WatchdogPhase::Watching && now >= self.last_heartbeat + Self::PATIENCE {
            self.speak(Silence::Stalled);
        }
    }

    /// Returns the packet to send now, if any.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        let WatchdogPhase::Stopping(rounds) = self.phase else {
            return None;
        };
        if self.now < rounds.due() {
            return None;
        }
        let packets = self.hazards.stop_packets();
        let packet = packets.get(rounds.sent).copied();
        self.phase = rounds.after(self.now, packets.len());
        packet
    }

    /// Returns when to call [`Watchdog::handle_time`] next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        match &self.phase {
            WatchdogPhase::Watching => self.last_heartbeat + Self::PATIENCE,
            WatchdogPhase::Stopping(rounds) => rounds.due(),
            WatchdogPhase::Stopped(_) | WatchdogPhase::Over => Duration::MAX,
        }
    }

    /// Returns why it acts, or has acted for a station that is still silent.
    #[must_use]
    pub const fn silence(&self) -> Option<Silence> {
        match &self.phase {
            WatchdogPhase::Stopping(rounds) => Some(rounds.why),
            WatchdogPhase::Stopped(why) => Some(*why),
            WatchdogPhase::Watching | WatchdogPhase::Over => None,
        }
    }

    /// Returns the commands last sent to the arm that must not outlive the station.
    #[must_use]
    pub const fn hazards(&self) -> Hazards {
        self.hazards
    }

    /// Returns when the last heartbeat arrived.
    #[must_use]
    pub const fn last_heartbeat(&self) -> Duration {
        self.last_heartbeat
    }

    /// Returns whether there is nothing more to do.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self.phase, WatchdogPhase::Over)
    }

    fn speak(&mut self, why: Silence) {
        // The station's last packet may still be on the line, unless it was silent for long.
        let free = self.last_heartbeat + GAP;
        self.phase = WatchdogPhase::Stopping(StopRounds {
            why,
            started: self.now,
            next: self.now.max(free),
            sent: 0,
            rounds: 0,
            received: true,
        });
    }
}

impl StopRounds {
    /// A round waits until the arm sends: with a full queue it is silent and would lose packets.
    /// An arm that is silent for long gets them anyway.
    fn due(&self) -> Duration {
        if self.sent > 0 || self.received {
            self.next
        } else {
            self.next + MAX_SILENCE
        }
    }

    fn after(self, now: Duration, packets: usize) -> WatchdogPhase {
        if self.sent + 1 < packets {
            return WatchdogPhase::Stopping(Self {
                next: now + GAP,
                sent: self.sent + 1,
                ..self
            });
        }
        let rounds = self.rounds + 1;
        let received_enough = rounds >= ROUNDS && self.received;
        if received_enough || now >= self.started + LONGEST {
            return match self.why {
                Silence::Ended => WatchdogPhase::Over,
                Silence::Stalled => WatchdogPhase::Stopped(self.why),
            };
        }
        WatchdogPhase::Stopping(Self {
            next: now + RETRY_DELAY,
            sent: 0,
            rounds,
            received: false,
            ..self
        })
    }
}

/// Longer than a packet on the line plus the 8 ms that a stock arm needs between two (note N26).
pub(crate) const GAP: Duration = dobot_wire::PACKET_GAP;
/// Long enough for two statuses to show the effect.
const RETRY_DELAY: Duration = Duration::from_millis(200);
/// An arm silent for this long gets the next round anyway.
const MAX_SILENCE: Duration = Duration::from_millis(500);
/// A packet may get lost; three hardly ever do.
const ROUNDS: u32 = 3;
/// More packets do not help an arm that is silent for this long.
const LONGEST: Duration = Duration::from_secs(4);
