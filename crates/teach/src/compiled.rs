//! A program as commands.

use std::sync::Arc;

use dobot_api::{JobKind, JobPause, JobProgram, JobRepeat, NewJob};
use dobot_wire::Command;

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
}

impl Compiled {
    /// The step to which a command belongs.
    #[must_use]
    pub fn step_of(&self, command: usize) -> Option<usize> {
        let begun = self.steps.partition_point(|it| it.first <= command);
        begun.checked_sub(1)
    }

    /// The job of it: how far the tool is lifted in a pause is said in mm.
    #[must_use]
    pub fn job(&self, lift_mm: f32) -> NewJob {
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
