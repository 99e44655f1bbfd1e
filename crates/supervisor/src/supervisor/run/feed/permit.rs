//! How far a job may be ahead of the journal: the journal cannot restore what it does not have.

use dobot_journal::Adjustment;

/// What the journal has of a job, and what was requested.
#[derive(Debug)]
pub(crate) struct Permit {
    /// Commands below this one may be sent: the journal has the window.
    upto: usize,
    /// The number of completed commands in the journal, from which a station starts to locate the
    /// arm after a crash.
    kept: usize,
    asked: Option<PendingRequest>,
    /// An adjustment not yet in the journal; the commands it changes are not sent before.
    adjustment: Option<Adjustment>,
}

/// A request that the journal has not completed yet.
#[derive(Debug)]
struct PendingRequest {
    upto: usize,
    completed: usize,
}

impl Permit {
    /// Starts without a permit, with this many completed commands in the journal.
    pub(crate) const fn new(completed: usize, kept: usize) -> Self {
        Self {
            upto: completed,
            kept,
            asked: None,
            adjustment: None,
        }
    }

    /// Returns whether a command may be sent.
    pub(crate) const fn allows(&self, index: usize) -> bool {
        index < self.upto && self.adjustment.is_none()
    }

    /// Returns whether to request more, when this command is the next.
    pub(crate) const fn is_low(&self, next: usize) -> bool {
        self.asked.is_none() && self.upto < next + LOW_WATER
    }

    /// Requests a window up to a command; returns whether that is more than before.
    pub(crate) fn ask(&mut self, upto: usize, completed: usize) -> bool {
        let is_more = upto > self.upto;
        if is_more {
            self.asked = Some(PendingRequest { upto, completed });
        }
        is_more
    }

    /// Handles the journal's window up to a command.
    pub(crate) fn handle_given(&mut self, upto: usize) {
        let Some(asked) = &self.asked else {
            return;
        };
        self.upto = self.upto.max(upto.min(asked.upto));
        if self.upto == asked.upto {
            self.kept = asked.completed;
            self.asked = None;
        }
    }

    /// Waits until the journal has this adjustment.
    pub(crate) fn wait_for(&mut self, adjustment: Adjustment) {
        self.adjustment = Some(adjustment);
    }

    /// Handles an adjustment that the journal has written.
    pub(crate) fn handle_adjusted(&mut self, adjustment: &Adjustment) {
        let same = |waited: &mut Adjustment| waited.heights == adjustment.heights;
        self.adjustment.take_if(same);
    }

    /// Moves back in the plan.
    pub(crate) fn go_back(&mut self, back: usize) {
        self.upto -= back;
        self.kept = self.kept.saturating_sub(back);
        if let Some(asked) = &mut self.asked {
            asked.upto -= back;
            asked.completed = asked.completed.saturating_sub(back);
        }
    }

    /// Returns the number of completed commands in the journal.
    pub(crate) const fn kept(&self) -> usize {
        self.kept
    }
}

/// More is requested when this many are left.
const LOW_WATER: usize = 12;
