//! The laser interlock: off unless a person has armed it for a while. The session holds the state;
//! this module limits the time and sends laser-off packets.

use std::time::Duration;

use dobot_api::LaserView;
use dobot_motion::LASER_OFF;
use dobot_session::CommandId;

use super::arm::Arm;
use super::seconds;
use crate::refusal::Refusal;

impl Arm {
    /// Arms the laser for this time, if the policy allows it.
    pub(super) fn arm_laser(&mut self, for_s: f64) -> Result<(), Refusal> {
        let most_s = self.policy().laser.arm_for_s;
        let allowed = if !self.policy().laser.allowed {
            "nothing: the policy forbids the laser (laser.allowed)".into()
        } else if !(for_s > 0.0 && for_s <= most_s) {
            format!("more than 0 and at most {most_s} s (laser.arm_for_s of the policy)")
        } else {
            let until = self.now() + seconds(for_s);
            self.session_mut().arm_laser(until);
            return Ok(());
        };
        Err(Refusal::OutOfRange {
            name: "for_s",
            found: for_s,
            allowed,
        })
    }

    /// Disarms the laser; returns whether it was armed or on, and the commands dropped.
    pub(super) fn disarm_laser(&mut self) -> (bool, Vec<CommandId>) {
        let was_armed = self.session().laser_armed_until().is_some();
        let forgotten = self.session_mut().disarm_laser();
        (was_armed || self.session().is_laser_on(), forgotten)
    }

    /// Checks that the laser is armed.
    pub(super) const fn check_laser_armed(&self) -> Result<(), Refusal> {
        match self.session().laser_armed_until() {
            Some(_) => Ok(()),
            None => Err(Refusal::LaserDisarmed),
        }
    }

    /// Sends laser off urgently. It is repeated only after a while, unless a burning command was
    /// sent, and only to an arm with nothing else to do first: repeated bad requests must not fill
    /// its queue.
    pub(super) fn send_laser_off(&mut self) {
        let lately = |off: Duration| self.now().saturating_sub(off) < LATELY;
        let waits = self.session().in_flight() > 0;
        let sent_at = self.session().laser_off_sent_at();
        if !sent_at.is_some_and(|off| waits || lately(off)) {
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
