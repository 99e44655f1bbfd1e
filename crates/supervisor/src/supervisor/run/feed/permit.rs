//! How far a job may go on before the journal has more of it: what it does not know it cannot bring
//! back.

use dobot_journal::Adjustment;

/// What the journal has of a job, and what it has been asked for.
#[derive(Debug)]
pub(crate) struct Permit {
    /// Commands below this one may be sent: the journal has it.
    upto: usize,
    /// As many commands are done as the journal has it: a station that is started after a crash
    /// looks for the arm from there on.
    kept: usize,
    asked: Option<PendingRequest>,
    /// The journal does not have this yet: what it changes is not sent before.
    adjustment: Option<Adjustment>,
}

/// What the journal does not have yet.
#[derive(Debug)]
struct PendingRequest {
    upto: usize,
    completed: usize,
}

impl Permit {
    /// No command may be sent yet, and so many are done as the journal has it.
    pub(crate) const fn new(completed: usize, kept: usize) -> Self {
        Self {
            upto: completed,
            kept,
            asked: None,
            adjustment: None,
        }
    }

    /// Whether a command may be sent.
    pub(crate) const fn allows(&self, index: usize) -> bool {
        index < self.upto && self.adjustment.is_none()
    }

    /// Whether it is time to ask for more, when this command is the next.
    pub(crate) const fn is_low(&self, next: usize) -> bool {
        self.asked.is_none() && self.upto < next + LOW_WATER
    }

    /// Asks to let the job go on up to there; says whether that is more than it has.
    pub(crate) fn ask(&mut self, upto: usize, completed: usize) -> bool {
        let is_more = upto > self.upto;
        if is_more {
            self.asked = Some(PendingRequest { upto, completed });
        }
        is_more
    }

    /// Takes that the journal has the job go on up to there.
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

    /// Waits until the journal has this.
    pub(crate) fn wait_for(&mut self, adjustment: Adjustment) {
        self.adjustment = Some(adjustment);
    }

    /// Takes that the journal has what a person changed.
    pub(crate) fn handle_adjusted(&mut self, adjustment: &Adjustment) {
        let same = |it: &mut Adjustment| it.heights == adjustment.heights;
        self.adjustment.take_if(same);
    }

    /// Takes that the places in the plan have gone back.
    pub(crate) fn go_back(&mut self, back: usize) {
        self.upto -= back;
        self.kept = self.kept.saturating_sub(back);
        if let Some(asked) = &mut self.asked {
            asked.upto -= back;
            asked.completed = asked.completed.saturating_sub(back);
        }
    }

    /// As many commands are done as the journal has it.
    pub(crate) const fn kept(&self) -> usize {
        self.kept
    }
}

/// The journal is asked for more when so few are left.
const LOW_WATER: usize = 12;
