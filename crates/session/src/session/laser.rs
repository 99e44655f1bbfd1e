//! The laser of a session: it burns only while it is armed, and not while the arm stands.

use std::time::Duration;

use dobot_motion::{Button, LASER_OFF, burns};
use dobot_wire::{Command, LINE_TIME, Status};

use super::{CommandId, Session};
use crate::{Disarmed, Event, SendError};

/// What a session knows of the laser, besides what it believes of the arm.
#[derive(Clone, Debug, Default)]
pub(super) struct Laser {
    /// Until when it may be lit; `Duration::MAX` where it needs no arming.
    armed_until: Option<Duration>,
    /// It may burn on the spot.
    may_stand: bool,
    /// When somebody told the arm last to switch it off, with nothing that burns sent since.
    told_off: Option<Duration>,
    /// Something that burns was sent since: where a packet was lost, it may be on whatever was to follow.
    was_lit: bool,
    /// When it is said again that it is to be off, and how often that was said.
    again: Option<Duration>,
    rounds: u32,
    /// The packet that left last is on the line until then.
    line_free: Duration,
    /// What the session switched the laser off with is on the line until then.
    off_on_line: Duration,
    /// When the last status came that differs from the one before, and whether the last one does not.
    changed: Duration,
    stands: bool,
}

impl Laser {
    /// The arm was reset: its laser is off.
    pub(super) const fn forget(&mut self) {
        self.was_lit = false;
        self.again = None;
    }
}

impl Session {
    /// The same with a laser that needs no arming: that of a virtual arm in this process, which burns
    /// nobody.
    #[must_use]
    pub fn with_free_laser(mut self) -> Self {
        self.free_laser();
        self
    }

    /// The laser needs no arming from now on: that of a virtual arm in this process burns nobody.
    pub const fn free_laser(&mut self) {
        self.laser.armed_until = Some(Duration::MAX);
    }

    /// Says whether the laser may burn while the arm stands; it may not unless told so.
    ///
    /// Where it may not, a laser that is on is switched off as soon as nothing that goes on is sent in
    /// time, whatever lit it (note N36): at the end of what burns, before a pause, and where the arm
    /// stops on its way.
    pub const fn set_laser_may_stand(&mut self, may: bool) {
        self.laser.may_stand = may;
    }

    /// Lets the laser be lit until then, in the time of the session: a person has put the goggles on.
    /// It is disarmed before where the link is lost or opened again, and where the arm is reset.
    pub fn arm_laser(&mut self, until: Duration) {
        if !self.is_laser_free() {
            self.laser.armed_until = Some(until);
        }
    }

    /// Keeps the laser from being lit until it is armed anew. Returns the commands that are forgotten
    /// for it: the first waiting one that burns, and those behind. What the arm was sent it does; to
    /// end that, send [`LASER_OFF`].
    pub fn disarm_laser(&mut self) -> Vec<CommandId> {
        if self.is_laser_free() {
            return Vec::new();
        }
        self.laser.armed_until = None;
        self.estimate.discard_from_first(burns)
    }

    /// Until when the laser may be lit; `None` while it is disarmed, `Duration::MAX` where it needs no
    /// arming.
    #[must_use]
    pub const fn laser_armed_until(&self) -> Option<Duration> {
        self.laser.armed_until
    }

    /// Whether the laser of the arm may be on, as its dialect has it (note N36): from when it was told
    /// to burn until that is over, and where it does not switch itself off, until what switches it off
    /// had time to act.
    #[must_use]
    pub fn is_laser_on(&self) -> bool {
        self.estimate.is_lit()
    }

    /// When somebody told the arm last to switch the laser off; `None` where nobody did, or where
    /// something that burns was sent since. That the session did it by itself does not count.
    #[must_use]
    pub const fn laser_told_off(&self) -> Option<Duration> {
        self.laser.told_off
    }

    pub(super) fn check_laser(&self, command: &Command) -> Result<(), SendError> {
        let armed = self.laser.armed_until.is_some_and(|it| it > self.now);
        if armed || !burns(command) {
            return Ok(());
        }
        Err(SendError::LaserDisarmed)
    }

    /// Takes note of a command that leaves.
    pub(super) fn note_laser(&mut self, command: &Command) {
        self.laser.line_free = self.now + LINE_TIME;
        self.laser.again = None;
        if burns(command) {
            self.laser.told_off = None;
            self.laser.was_lit = true;
        } else if Button::of(command) == Some(Button::Laser(false)) {
            self.laser.told_off = Some(self.now);
            self.laser.was_lit = false;
        }
    }

    /// Takes note of whether the arm stands, before the estimate takes the status.
    pub(super) fn see_laser(&mut self, status: &Status) {
        self.laser.stands = self.status == Some(*status);
        if !self.laser.stands {
            self.laser.changed = self.now;
        }
    }

    /// The laser is disarmed for a reason that the session sees itself.
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

    /// Its time may be over, and it may burn on the spot.
    pub(super) fn watch_laser(&mut self) {
        let is_over = self.laser.armed_until.is_some_and(|it| it <= self.now);
        if is_over {
            self.lose_laser(Disarmed::TimeOver);
        }
        if is_over && self.laser.was_lit {
            self.switch_laser_off();
        } else if self.laser_off_due().is_some_and(|it| it <= self.now) {
            let again = self.laser.again.is_some();
            self.switch_laser_off();
            self.laser.rounds = if again { self.laser.rounds + 1 } else { 1 };
            self.laser.again = (self.laser.rounds < ROUNDS).then_some(self.now + AGAIN);
        }
    }

    /// When [`Session::watch_laser`] has something to do.
    pub(super) fn laser_wakeup(&self) -> Option<Duration> {
        let ends = self.laser.armed_until.filter(|_| !self.is_laser_free());
        ends.into_iter().chain(self.laser_off_due()).min()
    }

    /// Whether the laser is to be off before this command, behind which the arm would pause with it.
    pub(super) fn parts_from_laser_first(&self, command: &Command) -> bool {
        !self.laser.may_stand && self.estimate.would_pause_lit(command)
    }

    /// Tells the arm to switch the laser off, beside all that waits. What waits leaves with a status
    /// that comes when this is off the line.
    pub(super) fn switch_laser_off(&mut self) {
        let Ok(packet) = self.emit_now(&LASER_OFF) else {
            return;
        };
        if self.laser.was_lit && self.estimate.is_lit() {
            self.events.push_back(Event::LaserOff);
        }
        self.note_urgent(&LASER_OFF);
        self.to_send.push_back(packet);
        // Whoever says it himself says it once more.
        self.laser.told_off = None;
        self.laser.off_on_line = self.laser.line_free;
        self.permit = false;
    }

    /// Whether the line is free of what switched the laser off: a stock arm wants a gap between packets.
    pub(super) fn has_line(&self) -> bool {
        self.now >= self.laser.off_on_line
    }

    /// When the laser has to be told to be off, if nothing more is sent until then.
    fn laser_off_due(&self) -> Option<Duration> {
        if self.laser.may_stand || self.opened {
            return None;
        }
        if let Some(again) = self.laser.again {
            // A silent arm has no room for it, or does not hear it.
            let hears = self.heard + AGAIN > again;
            return (hears && self.estimate.waiting() == 0).then_some(again);
        }
        if !self.laser.was_lit {
            return None;
        }
        let stops_at = self.estimate.in_flight().stops_at();
        let foreseen = stops_at.and_then(|from| {
            if self.estimate.waiting() > 0 {
                return self.estimate.stays_lit().then_some(from + PERMIT_IN_TIME);
            }
            // It waits in the arm for the end of what burns.
            let lead = if self.estimate.stays_lit() {
                self.lead()
            } else {
                Duration::ZERO
            };
            Some(from.saturating_sub(lead))
        });
        let due = foreseen.into_iter().chain(self.seen_to_stand()).min()?;
        Some(due.max(self.laser.line_free))
    }

    /// How long before the end of what burns a packet has to leave to be there by then.
    fn lead(&self) -> Duration {
        ON_THE_LINE + self.extra_latency()
    }

    /// How much longer packets take than on a usual link.
    pub(super) fn extra_latency(&self) -> Duration {
        let latency = self.meter.latency().unwrap_or(LATENCY);
        latency.saturating_sub(LATENCY)
    }

    /// Now, if the arm is seen to stand where it should move.
    fn seen_to_stand(&self) -> Option<Duration> {
        // Standing shows where it has moved before, or should have by now.
        let since = self.estimate.in_flight().running_since(self.now);
        let shows = self.meter.latency().unwrap_or(LATENCY) + self.meter.period();
        let stopped = self.laser.changed > since || self.now >= since + shows;
        (self.laser.stands && stopped).then_some(self.now)
    }

    fn is_laser_free(&self) -> bool {
        self.laser.armed_until == Some(Duration::MAX)
    }
}

/// A packet is under way for 43.68 ms, and acts in a tick of 20 ms.
const ON_THE_LINE: Duration = Duration::from_millis(60);
/// What waits for a permit has so long behind the end of what burns: with the way of the packet and a
/// tick, less than 0.2 s.
const PERMIT_IN_TIME: Duration = Duration::from_millis(100);
/// A packet may get lost: so often it is said, while nothing else is.
const ROUNDS: u32 = 4;
const AGAIN: Duration = Duration::from_millis(150);
/// From a command to the first status that shows it, on a usual link.
const LATENCY: Duration = Duration::from_millis(250);
