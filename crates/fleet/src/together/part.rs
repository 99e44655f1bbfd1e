//! One part of a coordinated program.

use std::collections::BTreeMap;

use dobot_api::NewJob;
use dobot_teach::{Compiled, barrier_reason};
use dobot_wire::{Command, JointJogAxis};

use super::barriers::Barriers;

/// One part of a coordinated program.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The arm, by the name of its station.
    pub arm: String,
    /// The file of its program, for messages.
    pub file: String,
    /// The text of the program.
    pub text: String,
    /// The texts of the programs that it calls and of its drawings, by the names used in it.
    pub files: BTreeMap<String, String>,
    /// The commands of the program for a nominal arm. The station compiles the text again for its
    /// own arm.
    pub compiled: Compiled,
}

impl Part {
    /// Returns its barriers.
    pub(super) fn barriers(&self) -> Barriers {
        Barriers::of(&self.compiled)
    }

    /// Returns its job for a nominal arm.
    pub(super) fn job(&self) -> NewJob {
        self.compiled.job()
    }

    /// Whether it repeats until a person ends it.
    pub(super) fn never_ends(&self) -> bool {
        self.compiled
            .repeat
            .is_some_and(|repeat| repeat.times.is_none())
    }

    /// Returns the barrier at which its job is paused for this reason.
    pub(super) fn barrier_of(&self, reason: &str) -> Option<&str> {
        let names = self.compiled.steps.iter();
        let mut names = names.filter_map(|step| step.barrier.as_deref());
        names.find(|name| barrier_reason(name) == reason)
    }

    /// Whether its program waits for a person with this message.
    pub(super) fn waits_for_person(&self, reason: &str) -> bool {
        self.compiled
            .pauses
            .iter()
            .any(|pause| pause.message == reason)
    }

    /// Returns the step that switches the laser on, counted from 0.
    pub(super) fn burning_step(&self) -> Option<usize> {
        let burns = |command: &Command| match command {
            Command::JointJog(command) => command.axis == JointJogAxis::LaserOn,
            Command::WriteVector(command) => command.laser,
            _ => false,
        };
        let command = self.compiled.commands.iter().position(burns)?;
        self.compiled.step_of(command)
    }
}
