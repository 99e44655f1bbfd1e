//! Drawings and programs as jobs.

use dobot_wire::Command;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A job to be queued.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NewJob {
    /// What a person calls it.
    #[schemars(length(min = 1, max = 200))]
    pub title: String,
    /// What kind of job.
    pub kind: JobKind,
    /// What the arm is to do, in order. The first one that moves has to be a target (state 3 or 6).
    #[schemars(length(min = 1, max = 1_000_000))]
    pub commands: Vec<Command>,
    /// How far the tool is lifted while the job is paused, in millimetres.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 100.0))]
    pub lift_mm: f32,
    /// Where it waits for a person, in the order of its commands.
    #[serde(default)]
    #[schemars(length(max = 1_000))]
    pub pauses: Vec<JobPause>,
    /// How it goes through its commands, if it is a program.
    #[serde(default, skip_serializing_if = "JobProgram::is_plain")]
    pub program: JobProgram,
}

/// How a job goes through its commands: in steps, and perhaps more than once.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobProgram {
    /// The first command of each step, in order; without them each command is a step.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(length(max = 1_000_000))]
    pub steps: Vec<usize>,
    /// Which commands are done again.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeat: Option<JobRepeat>,
}

impl JobProgram {
    /// Whether each command is a step, and is done once.
    #[must_use]
    pub const fn is_plain(&self) -> bool {
        self.steps.is_empty() && self.repeat.is_none()
    }

    /// Whether it fits a job with so many commands.
    ///
    /// # Errors
    ///
    /// What was found, and what is allowed, in one line.
    pub fn check(&self, commands: usize) -> Result<(), String> {
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
            Some(it) if it.from >= commands => Err(format!(
                "the cycle begins with command {}; the last one is {}",
                it.from,
                commands.saturating_sub(1)
            )),
            Some(JobRepeat { times: Some(0), .. }) => {
                Err("a cycle is done 0 times; allowed is 1 or more, or nothing for ever".into())
            }
            _ => Ok(()),
        }
    }

    /// How many commands of a job with `commands` of them are done in all, cycle by cycle; none where it
    /// goes on until a person ends it.
    #[must_use]
    pub fn total(&self, commands: usize) -> Option<usize> {
        let Some(repeat) = self.repeat else {
            return Some(commands);
        };
        let times = usize::try_from(repeat.times?).unwrap_or(usize::MAX);
        let cycle = commands.saturating_sub(repeat.from);
        Some(cycle.saturating_mul(times).saturating_add(repeat.from))
    }

    /// How far a job with so many commands is, of which `completed` are over, counted over all cycles; nothing
    /// where it has neither steps nor a cycle.
    #[must_use]
    pub fn view(&self, commands: usize, completed: usize) -> Option<ProgramView> {
        if self.is_plain() {
            return None;
        }
        let (cycles_done, within) = self.at(completed, commands);
        let is_plain = self.steps.is_empty();
        let begun = self.steps.partition_point(|it| *it <= within);
        Some(ProgramView {
            steps: if is_plain { commands } else { self.steps.len() },
            step: match (is_plain, within == commands) {
                (true, _) => within,
                (false, true) => self.steps.len(),
                (false, false) => begun.saturating_sub(1),
            },
            cycles_done,
            cycles: self.repeat.map_or(Some(1), |it| it.times),
            planned_cycle_s: None,
            mean_cycle_s: None,
        })
    }

    /// How many cycles are over when so many commands are, counted over all cycles; and how many commands
    /// of the job that is, in the cycle that it is at. Where a job is over, all of its commands are.
    #[must_use]
    pub fn at(&self, completed: usize, commands: usize) -> (u64, usize) {
        let Some(repeat) = self
            .repeat
            .filter(|it| completed >= it.from && commands > it.from)
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

/// A cycle: the commands at the end of a job that are done again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobRepeat {
    /// The first of them, counted from 0; those before it are done once.
    pub from: usize,
    /// How often they are done in all; without it, until a person ends the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1))]
    pub times: Option<u64>,
}

/// Where a job waits for a person: to change the pen, say. `start` goes on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobPause {
    /// The command before which it waits, counted from 0. The arm has to be at rest there.
    pub before: usize,
    /// What the person is told.
    #[schemars(length(min = 1, max = 200))]
    pub message: String,
}

/// What kind of job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JobKind {
    /// Vectors of a pen or a laser.
    Drawing,
    /// Targets to go to.
    Program,
}

/// How far a job is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JobPhase {
    /// It waits to be started.
    Queued,
    /// The arm is at it.
    Running,
    /// It can be gone on with.
    Paused,
    /// A person ended it.
    Stopped,
    /// It is done.
    Done,
    /// It cannot be gone on with.
    Failed,
}

impl JobPhase {
    /// Whether nothing more will come of it.
    #[must_use]
    pub const fn is_over(self) -> bool {
        matches!(self, Self::Stopped | Self::Done | Self::Failed)
    }
}

/// A job, as it is now.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct JobView {
    /// Its number.
    pub job: u64,
    /// What a person calls it.
    pub title: String,
    /// What kind of job.
    pub kind: JobKind,
    /// When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// How far it is.
    pub phase: JobPhase,
    /// Why it is paused, stopped or failed.
    pub reason: Option<String>,
    /// Whether it is paused where a person has to do something, such as change the pen: it goes on only after
    /// [`Request::ConfirmJob`](crate::Request::ConfirmJob).
    #[serde(default)]
    pub waits_for_person: bool,
    /// How many commands it has; those of a cycle count once.
    pub commands: usize,
    /// How many of them are over, in this cycle.
    pub completed: usize,
    /// How long all of it takes, in seconds, by the motion model, where that has been looked at.
    pub planned_s: Option<f64>,
    /// How long the rest takes, in seconds, by the motion model, where that has been looked at; at
    /// another speed than planned that is an estimate.
    pub left_s: Option<f64>,
    /// How long all of it really took, in seconds, without pauses; of a job that is done, where no
    /// crash came between.
    pub took_s: Option<f64>,
    /// How fast its vectors are drawn, in percent of what was planned.
    pub speed_percent: f64,
    /// How far above the plan it is drawn, in millimetres.
    pub height_mm: f64,
    /// How far it is in its steps and cycles, if it is a program.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<ProgramView>,
}

/// How far a program is in its steps and cycles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ProgramView {
    /// How many steps it has.
    pub steps: usize,
    /// The step that it is at, counted from 0; the number of steps where all are over.
    pub step: usize,
    /// How many cycles are over.
    pub cycles_done: u64,
    /// How many it does in all; none where it goes on until a person ends it.
    pub cycles: Option<u64>,
    /// How long a cycle takes, in seconds, by the motion model.
    pub planned_cycle_s: Option<f64>,
    /// How long a cycle really took, in seconds, without pauses: the mean of those that were done in one go
    /// since the job was started last.
    pub mean_cycle_s: Option<f64>,
}
