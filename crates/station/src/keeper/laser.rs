//! The laser's interlock: off, unless a person has armed it, for a while. The session holds it; here
//! is who arms it, and what becomes of jobs without it.

use std::time::Duration;

use dobot_course::LASER_OFF;

use super::arm::Arm;
use super::{Keeper, seconds};
use crate::words::{ClientId, LaserView, News, Refusal, Reply};

impl Keeper {
    /// Lets the laser burn without having been armed: that of a virtual arm harms nobody.
    pub fn free_laser(&mut self) {
        self.arm.session_mut().free_laser();
    }

    pub(super) fn arm_laser(&mut self, client: ClientId, for_s: f64) -> Result<Reply, Refusal> {
        self.leases.check_arms_laser(client)?;
        self.stop.check()?;
        let most_s = self.arm.policy().laser.arm_for_s;
        if !self.arm.policy().laser.allowed {
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
        let until = self.arm.now() + seconds(for_s);
        self.arm.session_mut().arm_laser(until);
        let text = format!(
            "{} armed the laser for {for_s:.0} s: goggles on",
            self.name(client)
        );
        self.tell(News::LaserArmed, text);
        Ok(Reply::Done)
    }

    /// Switches the laser off and keeps it off; a job that burns is paused.
    pub(super) fn disarm_laser(&mut self, why: &str) {
        let was_armed = self.arm.session().laser_armed_until().is_some();
        for id in self.arm.session_mut().disarm_laser() {
            self.command_forgotten(id, &Refusal::LaserDisarmed.to_string());
        }
        if was_armed || self.arm.session().is_laser_on() {
            self.laser_disarmed(why);
        }
    }

    /// The laser is disarmed: it goes off, and a job that burns is paused.
    pub(super) fn laser_disarmed(&mut self, why: &str) {
        self.arm.part_from_laser();
        self.interrupt_burning(why);
        self.tell(
            News::LaserDisarmed,
            format!("the laser is off and disarmed: {why}"),
        );
    }

    /// The session has switched the laser off.
    pub(super) fn laser_switched_off(&mut self) {
        let text = "the laser was switched off: nothing that goes on came in time, and it may not burn on the spot";
        self.tell(News::LaserOff, text.into());
    }
}

impl Arm {
    /// Whether a person has armed the laser.
    pub(super) const fn check_laser_armed(&self) -> Result<(), Refusal> {
        match self.session().laser_armed_until() {
            Some(_) => Ok(()),
            None => Err(Refusal::LaserDisarmed),
        }
    }

    /// Laser off, at once. Said again only after a while, unless something that burns was sent, and
    /// only to an arm that has nothing else to do first: whoever asks for nonsense many times must not
    /// fill its queue.
    pub(super) fn part_from_laser(&mut self) {
        let lately = |off: Duration| self.now().saturating_sub(off) < LATELY;
        let waits = self.session().under_way() > 0;
        let told = self.session().laser_told_off();
        if !told.is_some_and(|off| waits || lately(off)) {
            self.send_urgent(LASER_OFF);
        }
    }

    pub(super) fn laser_view(&self) -> LaserView {
        let left = |until: Duration| until.saturating_sub(self.now()).as_secs_f64();
        LaserView {
            armed_for_s: self
                .session()
                .laser_armed_until()
                .map_or(0.0, left)
                .min(self.policy().laser.arm_for_s),
            on: self.session().is_laser_on(),
        }
    }
}

/// The time of a few statuses.
const LATELY: Duration = Duration::from_millis(500);
