//! Jobs: drawings and programs with their state.

use std::fmt;

use dobot_api::{JobKind, JobPause, JobProgram, JobState};
use dobot_arm::Calibration;
use dobot_wire::{Command, Dialect};
use serde::{Deserialize, Serialize};

use crate::{Adjustment, Window};

/// The number of a job in its journal. It is never used again, even after the job is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JobId(pub u64);

impl fmt::Display for JobId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A planned job to be added to the journal, for the dialect of one arm.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedJob {
    /// The title.
    pub title: String,
    /// The kind of job.
    pub kind: JobKind,
    /// The dialect of the arm.
    pub dialect: Dialect,
    /// The calibration that its positions are meant for.
    pub calibration: Calibration,
    /// The height by which the pen is lifted when the job is interrupted, above 0, in millimetres;
    /// `None` if it is not lifted.
    pub lift_mm: Option<f32>,
    /// When it was created, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// The planned duration in seconds, if known.
    pub planned_s: Option<f64>,
    /// The commands, in order.
    pub commands: Vec<Command>,
    /// The pauses for a person, in order.
    pub pauses: Vec<JobPause>,
    /// The steps and cycles.
    pub program: JobProgram,
    /// The idempotency key of its request, which may be repeated because its answer can be lost.
    pub key: Option<String>,
}

/// A longer program for a job, with the same beginning.
#[derive(Clone, Debug, PartialEq)]
pub struct JobExtension {
    /// All commands, in order.
    pub commands: Vec<Command>,
    /// All pauses for a person, in order.
    pub pauses: Vec<JobPause>,
    /// The steps, and the program with its answers.
    pub program: JobProgram,
}

/// A job in the journal, without its commands.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// The job number.
    pub id: JobId,
    /// The title.
    pub title: String,
    /// The kind of job.
    pub kind: JobKind,
    /// The dialect of the arm.
    pub dialect: Dialect,
    /// The calibration that its positions are meant for.
    pub calibration: Calibration,
    /// The height by which the pen is lifted when the job is interrupted, above 0, in millimetres;
    /// `None` if it is not lifted.
    pub lift_mm: Option<f32>,
    /// When it was created, in milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// The planned duration in seconds, if known.
    pub planned_s: Option<f64>,
    /// The number of commands.
    pub commands: usize,
    /// The pauses for a person, in order.
    pub pauses: Vec<JobPause>,
    /// The steps and cycles.
    pub program: JobProgram,
    /// The adjustments by a person.
    pub adjustment: Adjustment,
    /// The state.
    pub state: JobState,
    /// The history apart from commands.
    pub history: JobHistory,
    /// The progress.
    pub window: Window,
    /// The idempotency key of its request.
    pub key: Option<String>,
}

impl Job {
    /// Returns whether a request for `asked` is the one that created this job, as far as visible
    /// without its commands.
    #[must_use]
    pub fn matches_request(&self, asked: &PlannedJob) -> bool {
        self.title == asked.title
            && self.kind == asked.kind
            && self.commands == asked.commands.len()
    }
}

/// The history of a job apart from commands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JobHistory {
    /// The number of [pause](JobPause)s reached, over all cycles.
    pub pauses: usize,
    /// How long it ran, without pauses, in seconds; `None` if unknown after a crash.
    pub ran_s: Option<f64>,
}

impl Default for JobHistory {
    fn default() -> Self {
        Self {
            pauses: 0,
            ran_s: Some(0.0),
        }
    }
}
