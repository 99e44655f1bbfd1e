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
    /// How far it is.
    pub phase: JobPhase,
    /// Why it is paused, stopped or failed.
    pub reason: Option<String>,
    /// How many commands it has.
    pub commands: usize,
    /// How many of them are over.
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
}
