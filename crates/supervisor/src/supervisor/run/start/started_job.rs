//! What a job brings along, and what it leaves in the journal.

use dobot_api::{JobKind, JobPause, JobPhase, JobProgram};
use dobot_journal::{Adjustment, Behind, Job, Window};
use dobot_wire::{Dialect, PlaybackAdjustment, Status, single};

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
pub struct StartedJob {
    /// Its number.
    pub job: u64,
    /// What a person calls it.
    pub title: String,
    /// What kind of job.
    pub kind: JobKind,
    /// When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// What the arm has to speak.
    pub dialect: Dialect,
    /// Its commands.
    pub plan: JobPlan,
    /// Where it waits for a person, in order.
    pub pauses: Vec<JobPause>,
    /// How it goes through its commands.
    pub program: JobProgram,
    /// How many commands it has; those of a cycle count once.
    pub commands: usize,
    /// What a person has changed on it.
    pub adjustment: Adjustment,
    /// By how many commands its places in the plan have gone back, in whole cycles: the journal counts on.
    pub back: usize,
    /// So many of its commands are over, by its places in the plan.
    pub completed: usize,
    /// What else it has behind it.
    pub behind: Behind,
    /// What may have been done beyond that, where nobody has found out yet.
    pub doubt: Option<Window>,
    /// It comes to rest behind the next step.
    pub single_step: bool,
}

impl StartedJob {
    /// A job as the journal has it, whose way was looked at.
    #[must_use]
    pub fn new(job: &Job, plan: JobPlan) -> Self {
        let back = plan
            .cycle()
            .map_or(0, |it| it.cycles_back(job.window.completed) * it.len);
        let window = back_by(job.window, back);
        Self {
            job: job.id.0,
            title: job.title.clone(),
            kind: job.kind,
            created_ms: job.created_ms,
            dialect: job.dialect,
            plan,
            pauses: job.pauses.clone(),
            program: job.program.clone(),
            commands: job.commands,
            adjustment: job.adjustment.clone(),
            back,
            completed: window.completed,
            behind: job.behind,
            doubt: (window.upto > window.completed).then_some(window),
            single_step: false,
        }
    }

    /// Where it waits next for a person: the command, by its place in the plan, and what the person is told.
    pub(crate) fn next_pause(&self) -> Option<(usize, &str)> {
        self.pause(self.behind.pauses)
    }

    /// What a person has to do before it goes on, if it has come to rest for that.
    pub(crate) fn waits_for_person(&self) -> Option<&str> {
        let (before, message) = self.pause(self.behind.pauses.checked_sub(1)?)?;
        (before == self.completed && self.doubt.is_none()).then_some(message)
    }

    /// Where it waits for a person after it has waited so many times, and what the person is told.
    fn pause(&self, waited: usize) -> Option<(usize, &str)> {
        let (pause, cycles) = match self.plan.cycle() {
            None => (self.pauses.get(waited)?, 0),
            Some(cycle) => {
                let once = self.pauses.partition_point(|it| it.before < cycle.from);
                let each = self.pauses.len() - once;
                let over = waited.saturating_sub(once).checked_div(each).unwrap_or(0);
                (self.pauses.get(waited - over * each)?, over * cycle.len)
            }
        };
        let before = (pause.before + cycles).checked_sub(self.back)?;
        Some((before, &pause.message))
    }

    /// Where it ends, by its place in the plan.
    pub(crate) fn end(&self) -> usize {
        let cycle = self.plan.cycle();
        cycle.map_or(self.plan.len(), |it| it.job_end(self.back / it.len))
    }

    /// Where the step ends that it is at, by its place in the plan.
    pub(crate) fn step_end(&self) -> usize {
        let (_, within) = self.program.at(self.completed + self.back, self.commands);
        let steps = &self.program.steps;
        let next = match steps.get(steps.partition_point(|it| *it <= within)) {
            Some(next) => *next,
            None if steps.is_empty() => within + 1,
            None => self.commands,
        };
        self.completed + next - within
    }

    /// The same window as the journal counts it.
    pub(crate) fn counted(&self, window: Window) -> Window {
        Window {
            completed: window.completed + self.back,
            upto: window.upto + self.back,
            ..window
        }
    }

    /// A window of the journal by its places in the plan.
    pub(crate) fn in_plan(&self, window: Window) -> Window {
        back_by(window, self.back)
    }

    /// How fast it may be done at the most, in percent of the plan.
    pub(crate) fn most_percent(&self) -> f64 {
        match self.kind {
            JobKind::Drawing => f64::INFINITY,
            JobKind::Program => 100.0 * 100.0 / self.plan.fastest_percent(),
        }
    }

    /// How fast the targets from a command on are gone to, where a person has changed that.
    pub(crate) fn target_speed(&self, index: usize) -> Option<PlaybackAdjustment> {
        let playback = self.plan.drawn_with(index).playback;
        (self.kind == JobKind::Program).then(|| self.at_speed(playback))
    }

    /// A playback adjustment of a program at the speed that a person has chosen.
    pub(crate) fn at_speed(&self, planned: PlaybackAdjustment) -> PlaybackAdjustment {
        let percent = f64::from(planned.speed_percent) * self.adjustment.speed_percent / 100.0;
        PlaybackAdjustment {
            speed_percent: single(percent),
            ..planned
        }
    }

    /// Goes back by a cycle, if one is over that may be done again; says by how many commands.
    pub(crate) fn go_back(&mut self) -> Option<usize> {
        let cycle = self.plan.cycle()?;
        let len = cycle.len * cycle.cycles_back(self.completed);
        self.back += len;
        self.completed -= len;
        (len > 0).then_some(len)
    }

    /// How far above the plan it is drawn, in mm.
    pub(crate) fn height_mm(&self) -> f64 {
        let last = self.adjustment.heights.last();
        last.map_or(0.0, |it| it.offset_mm)
    }
}

fn back_by(window: Window, back: usize) -> Window {
    Window {
        completed: window.completed.saturating_sub(back),
        upto: window.upto.saturating_sub(back),
        ..window
    }
}
