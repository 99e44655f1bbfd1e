//! What a job brings along, and what it leaves in the journal.

use dobot_api::JobPause;
use dobot_api::{JobKind, JobPhase};
use dobot_journal::{Adjustment, Behind, Window};
use dobot_wire::{Dialect, Status};

use crate::supervisor::JobPlan;

/// What the journal is to keep.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Before any command below `upto` is sent, this has to be on the disk:
    /// [`Supervisor::handle_written`](crate::Supervisor::handle_written) says that it is.
    Give {
        /// The job.
        job: u64,
        /// So many commands are over.
        completed: usize,
        /// Commands below this one may be sent.
        upto: usize,
        /// The arm as command `completed` finds it.
        start: Option<Status>,
    },
    /// The job is in another phase.
    Phase {
        /// The job.
        job: u64,
        /// The phase.
        phase: JobPhase,
        /// Why.
        reason: Option<String>,
        /// How far the job is for certain, where that is news.
        window: Option<Window>,
        /// What it has behind it, besides commands.
        behind: Behind,
    },
    /// A person has changed the speed or the height of the job. Before a command is sent that is
    /// changed by it, this has to be on the disk.
    Adjust {
        /// The job.
        job: u64,
        /// What holds from now on.
        adjustment: Adjustment,
    },
}

/// A job that is to be begun, or gone on with.
#[derive(Clone, Debug)]
pub struct Begun {
    /// Its number.
    pub job: u64,
    /// What a person calls it.
    pub title: String,
    /// What kind of job.
    pub kind: JobKind,
    /// What the arm has to speak.
    pub dialect: Dialect,
    /// Its commands.
    pub plan: JobPlan,
    /// Where it waits for a person, in order.
    pub pauses: Vec<JobPause>,
    /// What a person has changed on it.
    pub adjustment: Adjustment,
    /// So many of its commands are over.
    pub completed: usize,
    /// What else it has behind it.
    pub behind: Behind,
    /// What may have been done beyond that, where nobody has found out yet.
    pub doubt: Option<Window>,
}

impl Begun {
    /// Where it waits next for a person.
    pub(super) fn next_pause(&self) -> Option<&JobPause> {
        self.pauses.get(self.behind.pauses)
    }

    /// How far above the plan it is drawn, in mm.
    pub(super) fn height_mm(&self) -> f64 {
        let last = self.adjustment.heights.last();
        last.map_or(0.0, |it| it.offset_mm)
    }
}
