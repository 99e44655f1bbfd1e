//! Compiled programs.

use std::sync::Arc;

use dobot_api::{Answer, JobKind, JobPause, JobProgram, JobRepeat, NewJob, PendingQuestion};
use dobot_wire::Command;

use crate::Times;

/// A program as the commands that an arm executes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Compiled {
    /// The title.
    pub title: String,
    /// The speed of the first motion (soft start), in percent of the speed that is set then.
    pub start_speed_percent: Option<f64>,
    /// The commands, in order; those of a repeat at the end of the program appear once.
    pub commands: Vec<Command>,
    /// The pauses in which the arm waits for a person.
    pub pauses: Vec<JobPause>,
    /// The steps, in order of execution; each has at least one command.
    pub steps: Vec<CompiledStep>,
    /// The commands that repeat.
    pub repeat: Option<JobRepeat>,
    /// Whether the first cycle precedes `repeat` because it differs from the others: it starts
    /// softly, or with another tool, speed or grip than it ends with. The number of cycles is then
    /// one more than that of `repeat`.
    pub first_apart: bool,
    /// The answers that the commands follow, in order.
    pub answers: Vec<Answer>,
    /// The question asked after the last command.
    pub question: Option<PendingQuestion>,
    /// Whether the program asks anything while it runs, at least up to here.
    pub asks: bool,
}

/// A step of a compiled program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompiledStep {
    /// Its first command, counted from 0.
    pub first: usize,
    /// The called program that contains the step; `None` for the program itself.
    pub file: Option<Arc<str>>,
    /// The first line of the step, counted from 1.
    pub line: usize,
    /// The same in the program itself: of the step, or of the call that leads to it.
    pub main_line: usize,
    /// A description of the step.
    pub label: Arc<str>,
    /// The barrier at which the arm waits for the other arms before the first command.
    pub barrier: Option<Arc<str>>,
}

impl Compiled {
    /// Returns the step that contains a command.
    #[must_use]
    pub fn step_of(&self, command: usize) -> Option<usize> {
        let begun = self.steps.partition_point(|step| step.first <= command);
        begun.checked_sub(1)
    }

    /// Sets the total number of cycles, whatever the program specifies.
    pub fn repeat(&mut self, times: Times) {
        let from = self.repeat.map_or(0, |repeat| repeat.from);
        // The first cycle may precede the repeated ones.
        let apart = u64::from(self.first_apart && self.repeat.is_some());
        let times = match times {
            Times::Count(count) => Some(count.saturating_sub(apart).max(1)),
            Times::Forever => None,
        };
        self.repeat = Some(JobRepeat { from, times });
    }

    /// The program as a job. If it draws, a pause lifts the tool.
    #[must_use]
    pub fn job(&self) -> NewJob {
        let draws = |command: &Command| matches!(command, Command::WriteVector(_));
        let lift_mm = if self.commands.iter().any(draws) {
            LIFT_MM
        } else {
            0.0
        };
        let line = |step: &CompiledStep| u32::try_from(step.main_line).unwrap_or(0);
        NewJob {
            title: self.title.clone(),
            kind: JobKind::Program,
            commands: self.commands.clone(),
            lift_mm,
            pauses: self.pauses.clone(),
            program: JobProgram {
                steps: self.steps.iter().map(|step| step.first).collect(),
                lines: self.steps.iter().map(line).collect(),
                repeat: self.repeat,
                asking: None,
            },
        }
    }
}

/// The pause message of a job at a barrier.
#[must_use]
pub fn barrier_reason(barrier: &str) -> String {
    format!("waiting for the other arms at the barrier {barrier:?}")
}

/// The lift of the pen in a pause of a program that draws, in mm.
const LIFT_MM: f32 = 10.0;
