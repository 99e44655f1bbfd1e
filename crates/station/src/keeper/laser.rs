//! The laser's interlock: off, unless a person has armed it, for a while.

use std::time::Duration;

use dobot_safety::burns;
use dobot_wire::{Command, JointJogAxis};

use super::halt::LASER_OFF;
use super::{Keeper, seconds};
use crate::words::{ClientId, LaserView, News, Refusal, Reply};

/// The laser's interlock.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Interlock {
    /// Nobody has to arm it: it is that of a virtual arm.
    free: bool,
    /// Until when it may be switched on.
    armed_until: Option<Duration>,
    /// The arm was told to burn, and not told to stop that.
    on: bool,
    /// When it was last told to switch the laser off, with nothing sent since.
    off: Option<Duration>,
}

impl Interlock {
    /// Nobody knows whether the arm heard that it is to switch the laser off.
    pub(super) const fn forget(&mut self) {
        self.off = None;
    }

    pub(super) const fn ends(&self) -> Option<Duration> {
        self.armed_until
    }
}

impl Keeper {
    /// Lets the laser burn without having been armed: that of a virtual arm harms nobody.
    pub const fn free_laser(&mut self) {
        self.laser.free = true;
    }

    pub(super) fn arm_laser(&mut self, client: ClientId, for_s: f64) -> Result<Reply, Refusal> {
        self.check_lease(client)?;
        self.check_stop()?;
        let most_s = self.policy.laser.arm_for_s;
        if !self.policy.laser.allowed {
            return Err(Refusal::OutOfRange {
                name: "for_s",
                found: for_s,
                allowed: "nothing: the policy forbids the laser (laser.allowed)".into(),
            });
        }
        if !(for_s > 0.0 && for_s <= most_s) {
            return Err(Refusal::OutOfRange {
                name: "for_s",
                found: for_s,
                allowed: format!(
                    "more than 0 and at most {most_s} s (laser.arm_for_s of the policy)"
                ),
            });
        }
        self.laser.armed_until = Some(self.now + seconds(for_s));
        let text = format!(
            "{} armed the laser for {for_s:.0} s: goggles on",
            self.name(client)
        );
        self.tell(News::LaserArmed, text);
        Ok(Reply::Done)
    }

    /// Switches the laser off and keeps it off; a job that burns is paused.
    pub(super) fn disarm_laser(&mut self, why: &str) {
        let armed = self.laser.armed_until.take().is_some();
        if armed || self.laser.on {
            self.part_from_laser();
            self.interrupt_burning(why);
            self.tell(
                News::LaserDisarmed,
                format!("the laser is off and disarmed: {why}"),
            );
        }
    }

    /// Whether a command may be sent as far as the laser goes.
    pub(super) fn check_laser(&self, command: &Command) -> Result<(), Refusal> {
        if burns(command) {
            self.check_laser_armed()?;
        }
        Ok(())
    }

    /// Whether a person has armed the laser.
    pub(super) const fn check_laser_armed(&self) -> Result<(), Refusal> {
        match self.laser.armed_until {
            _ if self.laser.free => Ok(()),
            Some(_) => Ok(()),
            None => Err(Refusal::LaserDisarmed),
        }
    }

    /// Takes note of what a command does to the laser.
    pub(super) fn note_laser(&mut self, command: &Command) {
        match command {
            _ if burns(command) => {
                self.laser.on = true;
                self.laser.off = None;
            }
            Command::WriteVector(_) => self.laser.on = false,
            Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOff => self.laser.on = false,
            _ => {}
        }
    }

    /// The laser's time is over.
    pub(super) fn watch_laser(&mut self) {
        if self.laser.armed_until.is_some_and(|it| it <= self.now) {
            self.disarm_laser("the time for which it was armed is over");
        }
    }

    /// Laser off, at once. Said again only after a while, unless it was on, and only to an arm that
    /// has nothing else to do first: whoever asks for nonsense many times must not fill its queue.
    pub(super) fn part_from_laser(&mut self) {
        let lately = |off: Duration| self.now.saturating_sub(off) < LATELY;
        let waits = self.session.under_way() > 0;
        if self.laser.on || !self.laser.off.is_some_and(|off| waits || lately(off)) {
            self.laser.on = false;
            self.laser.off = Some(self.now);
            self.send_urgent(LASER_OFF);
        }
    }

    pub(super) fn laser_view(&self) -> LaserView {
        let left = |until: Duration| until.saturating_sub(self.now).as_secs_f64();
        LaserView {
            armed_for_s: if self.laser.free {
                self.policy.laser.arm_for_s
            } else {
                self.laser.armed_until.map_or(0.0, left)
            },
            on: self.laser.on,
        }
    }
}

/// The time of a few statuses.
const LATELY: Duration = Duration::from_millis(500);
