//! A job: a drawing or a program, with what becomes of it.

use std::fmt;

use dobot_api::{JobKind, JobPause, JobProgram, JobState};
use dobot_arm::Calibration;
use dobot_wire::{Command, Dialect};
use serde::{Deserialize, Serialize};

use crate::{Adjustment, Window};

/// The number of a job in its journal. It is never used again, not even after the job is removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JobId(pub u64);

impl fmt::Display for JobId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A job to be put into the journal: planned, for the dialect of one arm.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedJob {
    /// What people call it.
    pub title: String,
    /// What it is made from.
    pub kind: JobKind,
    /// How the arm reads its packets.
    pub dialect: Dialect,
    /// The calibration of the arm for which its places are meant.
    pub calibration: Calibration,
    /// How far the pen is lifted where the job is interrupted, above 0, in millimetres; `None`
    /// where it is not lifted.
    pub lift_mm: Option<f32>,
    /// When it was made: milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// How long it should take, in seconds, where that is known.
    pub planned_s: Option<f64>,
    /// What the arm is to do, in order.
    pub commands: Vec<Command>,
    /// Where it waits for a person, in order.
    pub pauses: Vec<JobPause>,
    /// How it goes through its commands.
    pub program: JobProgram,
    /// What the sender calls the request for it, where that may be sent again: its answer may be lost on the way.
    pub key: Option<String>,
}

/// A job in the journal, without its commands.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Its number.
    pub id: JobId,
    /// What people call it.
    pub title: String,
    /// What it is made from.
    pub kind: JobKind,
    /// How the arm reads its packets.
    pub dialect: Dialect,
    /// The calibration of the arm for which its places are meant.
    pub calibration: Calibration,
    /// How far the pen is lifted where the job is interrupted, above 0, in millimetres; `None`
    /// where it is not lifted.
    pub lift_mm: Option<f32>,
    /// When it was made: milliseconds since 1970-01-01T00:00:00Z.
    pub created_ms: i64,
    /// How long it should take, in seconds, where that is known.
    pub planned_s: Option<f64>,
    /// How many commands it has.
    pub commands: usize,
    /// Where it waits for a person, in order.
    pub pauses: Vec<JobPause>,
    /// How it goes through its commands.
    pub program: JobProgram,
    /// What a person has changed while it runs.
    pub adjustment: Adjustment,
    /// What became of it.
    pub state: JobState,
    /// What it has behind it, besides commands.
    pub behind: Behind,
    /// How far it has come.
    pub window: Window,
    /// What the sender calls the request for it, where that may be sent again.
    pub key: Option<String>,
}

impl Job {
    /// Whether a request for a job asked for this one: as far as can be told without the commands.
    #[must_use]
    pub fn is_as(&self, asked: &PlannedJob) -> bool {
        self.title == asked.title
            && self.kind == asked.kind
            && self.commands == asked.commands.len()
    }
}

/// What a job has behind it, besides commands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Behind {
    /// At how many of its [pause](JobPause)s it has waited, over all cycles.
    pub pauses: usize,
    /// How long it ran, without pauses, in seconds; `None` where a crash has left nobody who knows.
    pub ran_s: Option<f64>,
}

impl Default for Behind {
    fn default() -> Self {
        Self {
            pauses: 0,
            ran_s: Some(0.0),
        }
    }
}
