//! What pump and gripper do is never in doubt: it is seen before anything else is sent.
//!
//! A command that is lost is found out late: the arm does what comes behind it. For a motion that is no harm, since
//! a target says where it leads. An object that was not taken is missing for good. So a command that changes what
//! is held is sent when all before it is over, and nothing is sent behind it before a status shows what it did.

use std::time::Duration;

use dobot_wire::Status;

use crate::supervisor::run::{Run, SentCommand};

/// A grip that is over as far as anybody can tell, and that no status shows yet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnseenGrip {
    pub(crate) command: SentCommand,
    /// Until then it is waited for.
    pub(crate) until: Duration,
}

impl Run {
    /// Whether the next command has to wait for those before it.
    pub(crate) fn waits_for_grip(&self) -> bool {
        let grips = |index| self.started.plan.grips(index);
        let last = self.given.back().is_some_and(|it| grips(it.index));
        self.unseen.is_some() || last || grips(self.next) && !self.given.is_empty()
    }

    /// Whether a status shows what a command did with pump and gripper.
    pub(crate) fn shows_grip(&self, index: usize, status: &Status) -> bool {
        !self.started.plan.grips(index) || self.started.plan.shows_grip(index, status)
    }

    /// The grip was seen, or is not waited for any longer: then says why.
    pub(in crate::supervisor) fn judge_grip(
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
        Some("the arm does not hold what it should by its status: the command was lost".to_owned())
    }
}

/// Statuses come twelve times a second: after so long one would have shown it.
pub(crate) const SEEN_WITHIN: Duration = Duration::from_millis(1500);
