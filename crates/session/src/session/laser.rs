//! The laser of a session: it burns only while it is armed, and not while the arm stands still.

use std::time::Duration;

use dobot_motion::{Button, LASER_OFF, burns};
use dobot_wire::{Command, LINE_TIME, Status};

use super::{CommandId, Session};
use crate::{Disarmed, Event, SendError};

/// What a session knows about the laser beyond the arm estimate.
#[derive(Clone, Debug, Default)]
pub(super) struct Laser {
    /// Until when it may burn; `Duration::MAX` if it needs no arming.
    armed_until: Option<Duration>,
    /// It may burn while the arm stands still.
    may_stand: bool,
    /// When a client last sent "laser off" with nothing that burns sent since.
    off_sent: Option<Duration>,
    /// Something that burns was sent since: if a packet was lost, the laser may be on whatever follows.
    was_lit: bool,
    /// When "laser off" is repeated, and the number of repetitions.
    again: Option<Duration>,
    rounds: u32,
    /// Until when the last packet occupies the line.
    line_free: Duration,
    /// Until when the session's own "laser off" occupies the line.
    off_on_line: Duration,
    /// When a status last differed from the one before, and whether the last two are equal.
    changed: Duration,
    is_still: bool,
}

impl Laser {
    /// Handles a reset of the arm, which switches its laser off.
    pub(super) const fn handle_reset(&mut self) {
        self.was_lit = false;
        self.again = None;
    }
}

impl Session {
    /// Removes the need to arm the laser, for a virtual arm in this process.
    #[must_use]
    pub fn with_free_laser(mut self) -> Self {
        self.free_laser();
        self
    }

    /// Removes the need to arm the laser, for a virtual arm in this process.
    pub const fn free_laser(&mut self) {
        self.laser.armed_until = Some(Duration::MAX);
    }

    /// Sets whether the laser may burn while the arm stands still (default: no).
    ///
    /// If it may not, the session switches the laser off, whatever switched it on (note N36), when the
    /// next motion is not sent in time: at the end of burning, before a pause, and where the arm stops
    /// unexpectedly.
    pub const fn set_laser_may_stand(&mut self, may: bool) {
        self.laser.may_stand = may;
    }

    /// Arms the laser until the given session time; everyone present must wear goggles. A lost or
    /// reopened link and a reset disarm it earlier.
    pub fn arm_laser(&mut self, until: Duration) {
        if !self.is_laser_free() {
            self.laser.armed_until = Some(until);
        }
    }

    /// Disarms the laser. Returns the commands that are discarded: the first waiting one that burns and all
    /// after it. The arm still executes what it was sent; to end that, send [`LASER_OFF`].
    pub fn disarm_laser(&mut self) -> Vec<CommandId> {
        if self.is_laser_free() {
            return Vec::new();
        }
        self.laser.armed_until = None;
        self.estimate.discard_from_first(burns)
    }

    /// Until when the laser is armed; `None` while it is disarmed, `Duration::MAX` if it needs no
    /// arming.
    #[must_use]
    pub const fn laser_armed_until(&self) -> Option<Duration> {
        self.laser.armed_until
    }

    /// Whether the laser may be on, by the rules of the dialect (note N36): from a command that burns until
    /// its end, and where it does not switch off by itself, until "laser off" has taken effect.
    #[must_use]
    pub fn is_laser_on(&self) -> bool {
        self.estimate.is_lit()
    }

    /// When a client last sent "laser off"; `None` if none did or something that burns was sent since.
    /// The session's own "laser off" does not count.
    #[must_use]
    pub const fn laser_off_sent_at(&self) -> Option<Duration> {
        self.laser.off_sent
    }

    pub(super) fn check_laser(&self, command: &Command) -> Result<(), SendError> {
        let armed = self.laser.armed_until.is_some_and(|until| until > self.now);
        if armed || !burns(command) {
            return Ok(());
        }
        Err(SendError::LaserDisarmed)
    }

    /// Records a command that is sent.
    pub(super) fn note_laser(&mut self, command: &Command) {
        self.laser.line_free = self.now + LINE_TIME;
        self.laser.again = None;
        if burns(command) {
            self.laser.off_sent = None;
            self.laser.was_lit = true;
        } else if Button::of(command) == Some(Button::Laser(false)) {
            self.laser.off_sent = Some(self.now);
            self.laser.was_lit = false;
        }
    }

    /// Records whether the arm stands still, before the estimate handles the status.
    pub(super) fn see_laser(&mut self, status: &Status) {
        self.laser.is_still = self.status == Some(*status);
        if !self.laser.is_still {
            self.laser.changed = self.now;
        }
    }

    /// Disarms the laser for a reason that the session detected.
    pub(super) fn lose_laser(&mut self, why: Disarmed) {
        let was_armed = self.laser.armed_until.is_some() && !self.is_laser_free();
        for command in self.disarm_laser() {
            let reason = SendError::LaserDisarmed;
            self.events.push_back(Event::NotSent { command, reason });
        }
        if was_armed {
            self.events.push_back(Event::LaserDisarmed(why));
        }
    }

    /// Switches the laser off when its time is over or it would burn without moving.
    pub(super) fn watch_laser(&mut self) {
        let is_over = self
            .laser
            .armed_until
            .is_some_and(|until| until <= self.now);
        if is_over {
            self.lose_laser(Disarmed::TimeOver);
        }
        if is_over && self.laser.was_lit {
            self.switch_laser_off();
        } else if self.laser_off_due().is_some_and(|due| due <= self.now) {
            let again = self.laser.again.is_some();
            self.switch_laser_off();
            self.laser.rounds = if again { self.laser.rounds + 1 } else { 1 };
            self.laser.again = (self.laser.rounds < ROUNDS).then_some(self.now + RETRY_DELAY);
        }
    }

    /// When [`Session::watch_laser`] has to run next.
    pub(super) fn laser_wakeup(&self) -> Option<Duration> {
        let ends = self.laser.armed_until.filter(|_| !self.is_laser_free());
        ends.into_iter().chain(self.laser_off_due()).min()
    }

    /// Whether the laser has to be off before this command, because the arm would pause with it on.
    pub(super) fn needs_laser_off_first(&self, command: &Command) -> bool {
        !self.laser.may_stand && self.estimate.would_pause_lit(command)
    }

    /// Sends "laser off" ahead of the waiting commands, which continue with a status that arrives when the
    /// line is free again.
    pub(super) fn switch_laser_off(&mut self) {
        let Ok(packet) = self.emit_now(&LASER_OFF) else {
            return;
        };
        if self.laser.was_lit && self.estimate.is_lit() {
            self.events.push_back(Event::LaserOff);
        }
        self.note_urgent(&LASER_OFF);
        self.to_send.push_back(packet);
        // A client that wants it off sends that itself.
        self.laser.off_sent = None;
        self.laser.off_on_line = self.laser.line_free;
        self.permit = false;
    }

    /// Whether the line is free after "laser off": a stock arm needs a gap between packets.
    pub(super) fn has_line(&self) -> bool {
        self.now >= self.laser.off_on_line
    }

    /// When "laser off" has to be sent if nothing else is sent before.
    fn laser_off_due(&self) -> Option<Duration> {
        if self.laser.may_stand || self.opened {
            return None;
        }
        if let Some(again) = self.laser.again {
            // A silent arm has no room for it, or does not receive it.
            let receives = self.status_arrived + RETRY_DELAY > again;
            return (receives && self.estimate.waiting() == 0).then_some(again);
        }
        if !self.laser.was_lit {
            return None;
        }
        let due = self
            .foreseen_to_stand()
            .into_iter()
            .chain(self.seen_to_stand())
            .min()?;
        Some(due.max(self.laser.line_free))
    }

    /// When "laser off" has to be sent because the predicted motion ends.
    fn foreseen_to_stand(&self) -> Option<Duration> {
        let from = self.estimate.in_flight().stops_at()?;
        if self.estimate.waiting() > 0 {
            return self.estimate.stays_lit().then_some(from + PERMIT_IN_TIME);
        }
        // It waits in the arm's queue for the end of burning.
        let lead = if self.estimate.stays_lit() {
            self.lead()
        } else {
            Duration::ZERO
        };
        Some(from.saturating_sub(lead))
    }

    /// How long before the end of burning the packet has to be sent to arrive in time.
    fn lead(&self) -> Duration {
        ON_THE_LINE + self.extra_latency()
    }

    /// How much slower than usual this link is.
    pub(super) fn extra_latency(&self) -> Duration {
        let latency = self.meter.latency().unwrap_or(LATENCY);
        latency.saturating_sub(LATENCY)
    }

    /// Now, if the arm is seen standing still although it should move.
    fn seen_to_stand(&self) -> Option<Duration> {
        // Standing still counts only if the arm has moved before or should have by now.
        let since = self.estimate.in_flight().running_since(self.now);
        let shows = self.meter.latency().unwrap_or(LATENCY) + self.meter.period();
        let stopped = self.laser.changed > since || self.now >= since + shows;
        (self.laser.is_still && stopped).then_some(self.now)
    }

    fn is_laser_free(&self) -> bool {
        self.laser.armed_until == Some(Duration::MAX)
    }
}

/// 43.68 ms for a packet and a tick of 20 ms until it acts.
const ON_THE_LINE: Duration = Duration::from_millis(60);
/// How long after the end of burning a waiting command may be sent: with transmission and a tick, less
/// than 0.2 s.
const PERMIT_IN_TIME: Duration = Duration::from_millis(100);
/// How often "laser off" is sent while nothing else is: a packet may get lost.
const ROUNDS: u32 = 4;
const RETRY_DELAY: Duration = Duration::from_millis(150);
/// Time from a command to the first status that shows it on a usual link.
const LATENCY: Duration = Duration::from_millis(250);
