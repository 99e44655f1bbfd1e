//! What one arm does in a program for several.

use std::collections::BTreeMap;

use dobot_api::NewJob;
use dobot_teach::{Compiled, barrier_reason};
use dobot_wire::{Command, JointJogAxis};

use super::barriers::Barriers;

/// What one arm does in a program for several.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The arm, by the name of its station.
    pub arm: String,
    /// The file of its program, as a person knows it.
    pub file: String,
    /// The text of that.
    pub text: String,
    /// The texts of the programs that it calls and of its drawings, by their names in it.
    pub files: BTreeMap<String, String>,
    /// The program as commands, for an arm as drawn. Its station makes its own of the text, for the arm that it has.
    pub compiled: Compiled,
}

impl Part {
    /// Its barriers.
    pub(super) fn barriers(&self) -> Barriers {
        Barriers::of(&self.compiled)
    }

    /// Its job, for an arm as drawn.
    pub(super) fn job(&self) -> NewJob {
        self.compiled.job()
    }

    /// Whether it goes on until a person ends it.
    pub(super) fn never_ends(&self) -> bool {
        self.compiled.repeat.is_some_and(|it| it.times.is_none())
    }

    /// The barrier at which its job is paused for this reason.
    pub(super) fn barrier_of(&self, reason: &str) -> Option<&str> {
        let names = self.compiled.steps.iter();
        let mut names = names.filter_map(|it| it.barrier.as_deref());
        names.find(|it| barrier_reason(it) == reason)
    }

    /// Whether its program waits for a person with this text.
    pub(super) fn waits_for_person(&self, reason: &str) -> bool {
        self.compiled.pauses.iter().any(|it| it.message == reason)
    }

    /// The step that switches the laser on, counted from 0, if one does.
    pub(super) fn burning_step(&self) -> Option<usize> {
        let burns = |it: &Command| match it {
            Command::JointJog(it) => it.axis == JointJogAxis::LaserOn,
            Command::WriteVector(it) => it.laser,
            _ => false,
        };
        let command = self.compiled.commands.iter().position(burns)?;
        self.compiled.step_of(command)
    }
}
