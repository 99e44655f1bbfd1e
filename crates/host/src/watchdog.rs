//! What is said to the arm when the station says nothing any more.

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

/// The watchdog of an arm, as an engine: it owns no port, no process and no clock.
///
/// The station tells it [`Heartbeat`]s, ten in a second and more. When the station ends without a
/// goodbye, or is silent for [`PATIENCE`](Self::PATIENCE), the watchdog switches the laser off and
/// lets go of the button that is held: at least three times, with the gap between two packets that a
/// stock arm wants (note N26). While the station lives it says nothing.
///
/// Where something burns laser off comes first, and a jog stops dead. Otherwise the button is let go
/// first, and the arm runs down. Either way the release is of the same kind as the jog, for a stock
/// arm would run another axis down with the other one (note N44).
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
    /// When the last heartbeat came.
    last_heartbeat: Duration,
    phase: WatchdogPhase,
}

/// Why the watchdog speaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Silence {
    /// The station ended without a goodbye: it was killed, or panicked.
    Ended,
    /// The station stands still.
    Stalled,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WatchdogPhase {
    Watching,
    Speaking(Speech),
    /// All is said to the arm of a station that stands still.
    Spoken(Silence),
    Over,
}

/// What is being said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Speech {
    why: Silence,
    started: Duration,
    /// When the next packet is due.
    next: Duration,
    /// Packets of this round said already.
    said: usize,
    /// Rounds said already.
    rounds: u32,
    /// The arm was heard since the last round, so it has room for another one.
    heard: bool,
}

impl Watchdog {
    /// So long the station may be silent.
    pub const PATIENCE: Duration = Duration::from_millis(300);

    /// A watchdog of a station that lives.
    #[must_use]
    pub fn new(now: Duration) -> Self {
        Self {
            now,
            hazards: Hazards::default(),
            last_heartbeat: now,
            phase: WatchdogPhase::Watching,
        }
    }

    /// Takes what the station says. One that stood still and is back speaks for itself.
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

    /// Takes that the station is gone; after a goodbye that is well.
    pub fn handle_end(&mut self, now: Duration) {
        self.now = now;
        match &mut self.phase {
            WatchdogPhase::Watching => self.speak(Silence::Ended),
            WatchdogPhase::Speaking(speech) => speech.why = Silence::Ended,
            // The arm was told, and nothing came from the station since.
            WatchdogPhase::Spoken(_) => self.phase = WatchdogPhase::Over,
            WatchdogPhase::Over => {}
        }
    }

    /// Takes that the arm says something: it has room for a packet.
    pub fn handle_heard(&mut self, now: Duration) {
        self.handle_time(now);
        if let WatchdogPhase::Speaking(speech) = &mut self.phase {
            speech.heard = true;
        }
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        self.now = now;
        if self.phase == WatchdogPhase::Watching && now >= self.last_heartbeat + Self::PATIENCE {
            self.speak(Silence::Stalled);
        }
    }

    /// The packet to send now, if there is one.
    pub fn poll_bytes(&mut self) -> Option<Packet> {
        let WatchdogPhase::Speaking(speech) = self.phase else {
            return None;
        };
        if self.now < speech.due() {
            return None;
        }
        let packets = self.hazards.stop_packets();
        let packet = packets.get(speech.said).copied();
        self.phase = speech.after(self.now, packets.len());
        packet
    }

    /// When [`Watchdog::handle_time`] wants to be called next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        match &self.phase {
            WatchdogPhase::Watching => self.last_heartbeat + Self::PATIENCE,
            WatchdogPhase::Speaking(speech) => speech.due(),
            WatchdogPhase::Spoken(_) | WatchdogPhase::Over => Duration::MAX,
        }
    }

    /// Why it speaks, or has spoken to the arm of a station that is still silent.
    #[must_use]
    pub const fn silence(&self) -> Option<Silence> {
        match &self.phase {
            WatchdogPhase::Speaking(speech) => Some(speech.why),
            WatchdogPhase::Spoken(why) => Some(*why),
            WatchdogPhase::Watching | WatchdogPhase::Over => None,
        }
    }

    /// What the arm was told last that must not outlive the station.
    #[must_use]
    pub const fn hazards(&self) -> Hazards {
        self.hazards
    }

    /// When the last heartbeat came.
    #[must_use]
    pub const fn last_heartbeat(&self) -> Duration {
        self.last_heartbeat
    }

    /// Whether there is nothing more to do for it.
    #[must_use]
    pub const fn is_over(&self) -> bool {
        matches!(self.phase, WatchdogPhase::Over)
    }

    fn speak(&mut self, why: Silence) {
        // What the station said last may still be on the line, unless it was silent for long.
        let free = self.last_heartbeat + GAP;
        self.phase = WatchdogPhase::Speaking(Speech {
            why,
            started: self.now,
            next: self.now.max(free),
            said: 0,
            rounds: 0,
            heard: true,
        });
    }
}

impl Speech {
    /// A round waits for the arm to be heard: with a full queue it is silent, and would lose what
    /// comes. One that is silent for long is told all the same.
    fn due(&self) -> Duration {
        if self.said > 0 || self.heard {
            self.next
        } else {
            self.next + UNHEARD
        }
    }

    fn after(self, now: Duration, packets: usize) -> WatchdogPhase {
        if self.said + 1 < packets {
            return WatchdogPhase::Speaking(Self {
                next: now + GAP,
                said: self.said + 1,
                ..self
            });
        }
        let rounds = self.rounds + 1;
        let heard_enough = rounds >= ROUNDS && self.heard;
        if heard_enough || now >= self.started + LONGEST {
            return match self.why {
                Silence::Ended => WatchdogPhase::Over,
                Silence::Stalled => WatchdogPhase::Spoken(self.why),
            };
        }
        WatchdogPhase::Speaking(Self {
            next: now + AGAIN,
            said: 0,
            rounds,
            heard: false,
            ..self
        })
    }
}

/// More than a packet takes on the line, and the 8 ms that a stock arm wants between two (note N26).
pub(crate) const GAP: Duration = dobot_wire::PACKET_GAP;
/// Two statuses may show that it was heard.
const AGAIN: Duration = Duration::from_millis(200);
/// An arm that was not heard for so long is told again all the same.
const UNHEARD: Duration = Duration::from_millis(500);
/// A packet may get lost; three hardly ever do.
const ROUNDS: u32 = 3;
/// An arm that is silent for so long is not helped by more of the same.
const LONGEST: Duration = Duration::from_secs(4);
