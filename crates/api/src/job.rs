//! Drawings and programs as jobs.

use dobot_wire::Command;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::decision::{AskingProgram, PendingQuestion};

/// A job to queue.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NewJob {
    /// The title.
    #[schemars(length(min = 1, max = 200))]
    pub title: String,
    /// The kind of job.
    pub kind: JobKind,
    /// The commands, in order. The first motion must be a target (state 3 or 6).
    #[schemars(length(min = 1, max = 1_000_000))]
    pub commands: Vec<Command>,
    /// The height by which the tool is lifted while the job is paused, in millimetres.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 100.0))]
    pub lift_mm: f32,
    /// Pauses that wait for a person, in command order.
    #[serde(default)]
    #[schemars(length(max = 1_000))]
    pub pauses: Vec<JobPause>,
    /// The steps and cycles of a program.
    #[serde(default, skip_serializing_if = "JobProgram::is_plain")]
    pub program: JobProgram,
}

/// The steps and cycles of a job.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobProgram {
    /// The index of the first command of each step, in order; if empty, each command is a step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 1_000_000))]
    pub steps: Vec<usize>,
    /// The line of each step in the text of the program, counted from 1, 0 if unknown; or empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 1_000_000))]
    pub lines: Vec<u32>,
    /// The repeated commands.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeat: Option<JobRepeat>,
    /// The program, if it asks while it runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub asking: Option<Box<AskingProgram>>,
}

impl JobProgram {
    /// Returns whether each command is a step and runs once.
    #[must_use]
    pub const fn is_plain(&self) -> bool {
        self.steps.is_empty() && self.repeat.is_none() && self.asking.is_none()
    }

    /// Returns the question asked after the last command.
    #[must_use]
    pub fn question(&self) -> Option<&PendingQuestion> {
        self.asking.as_ref()?.question.as_ref()
    }

    /// Checks that the program fits a job with this number of commands.
    ///
    /// # Errors
    ///
    /// What was found and what is allowed, in one line.
    pub fn check(&self, commands: usize) -> Result<(), String> {
        let (steps, lines) = (self.steps.len(), self.lines.len());
        if lines != 0 && lines != steps {
            return Err(format!(
                "there are {lines} lines for {steps} steps; allowed is one for each step, or none"
            ));
        }
        let mut least = 0;
        for &step in &self.steps {
            if !(least..commands).contains(&step) {
                let most = commands.saturating_sub(1);
                return Err(format!(
                    "a step begins with command {step}; allowed are {least} to {most}, in order"
                ));
            }
            least = step + 1;
        }
        match self.repeat {
            Some(repeat) if repeat.from >= commands => Err(format!(
                "the cycle begins with command {}; the last one is {}",
                repeat.from,
                commands.saturating_sub(1)
            )),
            Some(JobRepeat { times: Some(0), .. }) => {
                Err("a cycle runs 0 times; allowed is 1 or more, or no number to repeat until the job is ended".into())
            }
            Some(_) if self.asking.is_some() => {
                Err("a program that asks has no repeat: its next cycle is an answer".into())
            }
            _ => Ok(()),
        }
    }

    /// Returns the total number of commands over all cycles of a job with `commands` commands;
    /// `None` if it repeats until it is ended.
    #[must_use]
    pub fn total(&self, commands: usize) -> Option<usize> {
        let Some(repeat) = self.repeat else {
            return Some(commands);
        };
        let times = usize::try_from(repeat.times?).unwrap_or(usize::MAX);
        let cycle = commands.saturating_sub(repeat.from);
        Some(cycle.saturating_mul(times).saturating_add(repeat.from))
    }

    /// Returns the progress in steps and cycles after `completed` commands, counted over all
    /// cycles; `None` if the job has neither steps nor cycles.
    #[must_use]
    pub fn view(&self, commands: usize, completed: usize) -> Option<ProgramView> {
        if self.is_plain() {
            return None;
        }
        let (cycles_done, within) = self.at(completed, commands);
        let is_plain = self.steps.is_empty();
        let begun = self.steps.partition_point(|step| *step <= within);
        let step = match (is_plain, within == commands) {
            (true, _) => within,
            (false, true) => self.steps.len(),
            (false, false) => begun.saturating_sub(1),
        };
        Some(ProgramView {
            steps: if is_plain { commands } else { self.steps.len() },
            step,
            line: self.lines.get(step).copied().filter(|line| *line > 0),
            cycles_done,
            cycles: self.repeat.map_or(Some(1), |repeat| repeat.times),
            planned_cycle_s: None,
            mean_cycle_s: None,
        })
    }

    /// Returns the number of cycles completed after `completed` commands, counted over all cycles,
    /// and the number of commands completed in the current cycle. When a job is over, that is all
    /// of its commands.
    #[must_use]
    pub fn at(&self, completed: usize, commands: usize) -> (u64, usize) {
        let Some(repeat) = self
            .repeat
            .filter(|repeat| completed >= repeat.from && commands > repeat.from)
        else {
            return (0, completed);
        };
        let cycle = commands - repeat.from;
        let (over, within) = (
            (completed - repeat.from) / cycle,
            (completed - repeat.from) % cycle,
        );
        let is_over = self.total(commands) == Some(completed);
        let within = if is_over { cycle } else { within };
        (over as u64, repeat.from + within)
    }
}

/// A cycle: the commands at the end of a job that repeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobRepeat {
    /// The index of the first repeated command, from 0; commands before it run once.
    pub from: usize,
    /// The total number of cycles; without it, the job repeats until it is ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1))]
    pub times: Option<u64>,
}

/// A pause where the job waits for a person, for example to change the pen. `start` resumes it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobPause {
    /// The index of the command before which it pauses, from 0. The arm must be at rest there.
    pub before: usize,
    /// The message shown to the person.
    #[schemars(length(min = 1, max = 200))]
    pub message: String,
}

/// The kind of job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JobKind {
    /// Vectors for a pen or a laser.
    Drawing,
    /// Moves to targets.
    Program,
}

/// The phase of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JobPhase {
    /// Waiting to be started.
    Queued,
    /// Running on the arm.
    Running,
    /// Paused; can be resumed.
    Paused,
    /// Ended by a person.
    Stopped,
    /// Done.
    Done,
    /// Failed; cannot be resumed.
    Failed,
}

impl JobPhase {
    /// Returns whether the job is over.
    #[must_use]
    pub const fn is_over(self) -> bool {
        matches!(self, Self::Stopped | Self::Done | Self::Failed)
    }
}

/// A job in its current state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct JobView {
    /// The job number.
    pub job: u64,
    /// The title.
    pub title: String,
    /// The kind of job.
    pub kind: JobKind,
    /// When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// The phase.
    pub phase: JobPhase,
    /// The reason why it is paused, stopped or failed.
    pub reason: Option<String>,
    /// Whether the job is paused until a person has done something, such as change the pen: it
    /// resumes only after [`Request::ConfirmJob`](crate::Request::ConfirmJob).
    #[serde(default)]
    pub waits_for_person: bool,
    /// The number of commands; those of a cycle count once.
    pub commands: usize,
    /// The number of completed commands in this cycle.
    pub completed: usize,
    /// The planned duration in seconds (motion model), if computed.
    pub planned_s: Option<f64>,
    /// The planned remaining time in seconds (motion model), if computed; an estimate if the speed
    /// has been changed.
    pub left_s: Option<f64>,
    /// The actual duration in seconds, without pauses; for a job that is done and was not
    /// interrupted by a crash.
    pub took_s: Option<f64>,
    /// The speed of its vectors, in percent of the plan.
    pub speed_percent: f64,
    /// The height offset from the plan, in millimetres.
    pub height_mm: f64,
    /// The progress in steps and cycles, if it is a program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<ProgramView>,
    /// The question that the job waits for, while the arm is at rest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub question: Option<PendingQuestion>,
}

/// The progress of a program in steps and cycles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ProgramView {
    /// The number of steps.
    pub steps: usize,
    /// The current step, from 0; the number of steps once all are done.
    pub step: usize,
    /// The line of the current step in the text of the program, counted from 1, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// The number of completed cycles.
    pub cycles_done: u64,
    /// The total number of cycles; absent if it repeats until it is ended.
    pub cycles: Option<u64>,
    /// The planned duration of a cycle in seconds (motion model).
    pub planned_cycle_s: Option<f64>,
    /// The mean actual duration of a cycle in seconds, without pauses: over the uninterrupted
    /// cycles since the job was last started.
    pub mean_cycle_s: Option<f64>,
}
