//! Checks of pump and gripper: a grip is confirmed by a status before anything else is sent.
//!
//! A lost command is detected late, after the arm has done what follows. For motions that is
//! harmless, since a target is absolute, but an object that was not picked up stays missing. So a
//! command that changes what is held is sent when everything before it is over, and nothing is sent
//! after it before a status shows its effect.

use std::time::Duration;

use dobot_wire::Status;

use crate::supervisor::run::{Run, SentCommand};

/// A grip that is over by the session's estimate, but not shown by a status yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnseenGrip {
    pub(crate) command: SentCommand,
    /// The end of the wait.
    pub(crate) until: Duration,
}

impl Run {
    /// Returns whether the next command has to wait for those before it.
    pub(crate) fn waits_for_grip(&self) -> bool {
        let grips = |index| self.started.plan.grips(index);
        let last = self.given.back().is_some_and(|sent| grips(sent.index));
        self.unseen.is_some() || last || grips(self.next) && !self.given.is_empty()
    }

    /// Returns whether a status shows the effect of a command on pump and gripper.
    pub(crate) fn shows_grip(&self, index: usize, status: &Status) -> bool {
        !self.started.plan.grips(index) || self.started.plan.shows_grip(index, status)
    }

    /// Checks the awaited grip: seen, or overdue and why.
    pub(in crate::supervisor) fn check_grip(
        &mut self,
        now: Duration,
        status: &Status,
    ) -> Option<String> {
        let unseen = self.unseen?;
        if self.shows_grip(unseen.command.index, status) {
            self.unseen = None;
            self.handle_done(unseen.command, now);
            return None;
        }
        if now < unseen.until {
            return None;
        }
        self.unseen = None;
        Some("the status does not show the expected grip: the command was lost".to_owned())
    }
}

/// Statuses arrive twelve times per second: within this time one would have shown it.
pub(crate) const SEEN_WITHIN: Duration = Duration::from_millis(1500);
