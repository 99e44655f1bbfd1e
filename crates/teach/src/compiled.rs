//! A program as commands.

use std::sync::Arc;

use dobot_api::{JobKind, JobPause, JobProgram, JobRepeat, NewJob};
use dobot_wire::Command;

use crate::Times;

/// A program as the commands that an arm carries out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Compiled {
    /// What a person calls it.
    pub title: String,
    /// The commands, in order; those of a repeat at the program's end stand here once.
    pub commands: Vec<Command>,
    /// Where it waits for a person.
    pub pauses: Vec<JobPause>,
    /// The steps, in the order in which they are done; each has one command at least.
    pub steps: Vec<CompiledStep>,
    /// Which commands are done again.
    pub repeat: Option<JobRepeat>,
    /// Whether the first cycle stands before `repeat`, on its own: it is another one, for it begins with the soft
    /// start or with another tool, speed or grip than it ends with. So there is one cycle more than `repeat` says.
    pub first_apart: bool,
}

/// A step of a compiled program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompiledStep {
    /// Its first command, counted from 0.
    pub first: usize,
    /// The called program in which it stands; `None` in the program itself.
    pub file: Option<Arc<str>>,
    /// The line on which it begins, counted from 1.
    pub line: usize,
    /// What it does, for a person.
    pub label: Arc<str>,
    /// The barrier at which the arm waits for the others, before its first command.
    pub barrier: Option<Arc<str>>,
}

impl Compiled {
    /// The step to which a command belongs.
    #[must_use]
    pub fn step_of(&self, command: usize) -> Option<usize> {
        let begun = self.steps.partition_point(|it| it.first <= command);
        begun.checked_sub(1)
    }

    /// Has it done so often in all, whatever it says itself.
    pub fn repeat(&mut self, times: Times) {
        let from = self.repeat.map_or(0, |it| it.from);
        // The first cycle may stand before those that repeat.
        let apart = u64::from(self.first_apart && self.repeat.is_some());
        let times = match times {
            Times::Count(count) => Some(count.saturating_sub(apart).max(1)),
            Times::Forever => None,
        };
        self.repeat = Some(JobRepeat { from, times });
    }

    /// The job of it. Where it draws, the tool is lifted in a pause.
    #[must_use]
    pub fn job(&self) -> NewJob {
        let draws = |it: &Command| matches!(it, Command::WriteVector(_));
        let lift_mm = if self.commands.iter().any(draws) {
            LIFT_MM
        } else {
            0.0
        };
        NewJob {
            title: self.title.clone(),
            kind: JobKind::Program,
            commands: self.commands.clone(),
            lift_mm,
            pauses: self.pauses.clone(),
            program: JobProgram {
                steps: self.steps.iter().map(|it| it.first).collect(),
                repeat: self.repeat,
            },
        }
    }
}

/// Why the job of a program is paused at a barrier, as its station tells it.
#[must_use]
pub fn barrier_reason(barrier: &str) -> String {
    format!("at the barrier {barrier:?} it waits for the other arms")
}

/// How far a pen is lifted where a program is paused that draws, in mm.
const LIFT_MM: f32 = 10.0;
