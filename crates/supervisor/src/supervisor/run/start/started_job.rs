//! A job to start, and its journal entries.

use dobot_api::{JobKind, JobPause, JobPhase, JobProgram};
use dobot_journal::{Adjustment, Job, JobHistory, Window};
use dobot_wire::{Dialect, PlaybackAdjustment, Status, single};

use crate::supervisor::JobPlan;

/// A request to the journal.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Must be on the disk before any command below `upto` is sent:
    /// [`Supervisor::handle_written`](crate::Supervisor::handle_written) confirms it.
    ExtendWindow {
        /// The job.
        job: u64,
        /// The number of completed commands.
        completed: usize,
        /// Commands below this one may be sent.
        upto: usize,
        /// The arm before command `completed`.
        start: Option<Status>,
    },
    /// The phase of the job has changed.
    Phase {
        /// The job.
        job: u64,
        /// The phase.
        phase: JobPhase,
        /// The reason.
        reason: Option<String>,
        /// The window, if it is certain and has changed.
        window: Option<Window>,
        /// The job's history apart from commands.
        history: JobHistory,
    },
    /// A person has changed the speed or the height of the job. It must be on the disk before a
    /// command changed by it is sent.
    Adjust {
        /// The job.
        job: u64,
        /// The new adjustment.
        adjustment: Adjustment,
    },
}

/// A job to start or resume.
#[derive(Clone, Debug)]
pub struct StartedJob {
    /// The job number.
    pub job: u64,
    /// The title.
    pub title: String,
    /// The kind of job.
    pub kind: JobKind,
    /// When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// The required dialect of the arm.
    pub dialect: Dialect,
    /// The commands.
    pub plan: JobPlan,
    /// The pauses for a person, in order.
    pub pauses: Vec<JobPause>,
    /// The steps and cycles.
    pub program: JobProgram,
    /// The number of commands; those of a cycle count once.
    pub commands: usize,
    /// The adjustment by a person.
    pub adjustment: Adjustment,
    /// The number of commands by which its position in the plan has moved back, in whole cycles;
    /// the journal keeps counting.
    pub back: usize,
    /// The number of completed commands, by position in the plan.
    pub completed: usize,
    /// The job's history apart from commands.
    pub history: JobHistory,
    /// Commands that may be done beyond that, if not determined yet.
    pub doubt: Option<Window>,
    /// Whether it comes to rest after the next step.
    pub single_step: bool,
}

impl StartedJob {
    /// Builds a job from its journal entry and its checked plan.
    #[must_use]
    pub fn new(job: &Job, plan: JobPlan) -> Self {
        let back = plan.cycle().map_or(0, |cycle| {
            cycle.cycles_back(job.window.completed) * cycle.len
        });
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
            history: job.history,
            doubt: (window.upto > window.completed).then_some(window),
            single_step: false,
        }
    }

    /// Returns the next pause for a person: the command, by position in the plan, and the message.
    pub(crate) fn next_pause(&self) -> Option<(usize, &str)> {
        self.pause(self.history.pauses)
    }

    /// Returns the message of the pause that the job has reached.
    pub(crate) fn waits_for_person(&self) -> Option<&str> {
        let (before, message) = self.pause(self.history.pauses.checked_sub(1)?)?;
        (before == self.completed && self.doubt.is_none()).then_some(message)
    }

    /// Returns the pause after this many pauses, and its message.
    fn pause(&self, waited: usize) -> Option<(usize, &str)> {
        let (pause, cycles) = match self.plan.cycle() {
            None => (self.pauses.get(waited)?, 0),
            Some(cycle) => {
                let once = self
                    .pauses
                    .partition_point(|pause| pause.before < cycle.from);
                let each = self.pauses.len() - once;
                let over = waited.saturating_sub(once).checked_div(each).unwrap_or(0);
                (self.pauses.get(waited - over * each)?, over * cycle.len)
            }
        };
        let before = (pause.before + cycles).checked_sub(self.back)?;
        Some((before, &pause.message))
    }

    /// Returns the end, by position in the plan.
    pub(crate) fn end(&self) -> usize {
        let cycle = self.plan.cycle();
        cycle.map_or(self.plan.len(), |cycle| {
            cycle.job_end(self.back / cycle.len)
        })
    }

    /// Returns the end of the current step, by position in the plan.
    pub(crate) fn step_end(&self) -> usize {
        let (_, within) = self.program.at(self.completed + self.back, self.commands);
        let steps = &self.program.steps;
        // Settings before the first step belong to it.
        let begun = steps.first().map_or(within, |first| within.max(*first));
        let next = match steps.get(steps.partition_point(|step| *step <= begun)) {
            Some(next) => *next,
            None if steps.is_empty() => within + 1,
            None => self.commands,
        };
        self.completed + next - within
    }

    /// Converts a window to the journal's count.
    pub(crate) fn counted(&self, window: Window) -> Window {
        Window {
            completed: window.completed + self.back,
            upto: window.upto + self.back,
            ..window
        }
    }

    /// Converts a window of the journal to positions in the plan.
    pub(crate) fn in_plan(&self, window: Window) -> Window {
        back_by(window, self.back)
    }

    /// Returns the highest speed, in percent of the plan.
    pub(crate) fn most_percent(&self) -> f64 {
        match self.kind {
            JobKind::Drawing => f64::INFINITY,
            JobKind::Program => 100.0 * 100.0 / self.plan.fastest_percent(),
        }
    }

    /// Returns the speed of the targets from a command on, if a person has changed it.
    pub(crate) fn target_speed(&self, index: usize) -> Option<PlaybackAdjustment> {
        let playback = self.plan.drawn_with(index).playback;
        (self.kind == JobKind::Program).then(|| self.at_speed(playback))
    }

    /// Scales a program's playback adjustment to the chosen speed.
    pub(crate) fn at_speed(&self, planned: PlaybackAdjustment) -> PlaybackAdjustment {
        let percent = f64::from(planned.speed_percent) * self.adjustment.speed_percent / 100.0;
        PlaybackAdjustment {
            speed_percent: single(percent),
            ..planned
        }
    }

    /// Moves back by completed cycles that repeat; returns the number of commands.
    pub(crate) fn go_back(&mut self) -> Option<usize> {
        let cycle = self.plan.cycle()?;
        let len = cycle.len * cycle.cycles_back(self.completed);
        self.back += len;
        self.completed -= len;
        (len > 0).then_some(len)
    }

    /// Returns the height above the plan, in mm.
    pub(crate) fn height_mm(&self) -> f64 {
        let last = self.adjustment.heights.last();
        last.map_or(0.0, |last| last.offset_mm)
    }
}

fn back_by(window: Window, back: usize) -> Window {
    Window {
        completed: window.completed.saturating_sub(back),
        upto: window.upto.saturating_sub(back),
        ..window
    }
}
