//! Fleet jobs: drawings and programs for any arm of a fleet.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::JobView;

/// A fleet job: a drawing or a program that one arm of the fleet runs once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WorkView {
    /// The id: 32 hexadecimal digits.
    pub id: String,
    /// The title.
    pub title: String,
    /// The student.
    pub student: String,
    /// The student's group.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
    /// The equipment the arm must have, as in `pen`, `a5`.
    pub needs: Vec<String>,
    /// When it was submitted, in milliseconds since 1970-01-01T00:00:00Z.
    pub submitted_ms: i64,
    /// The phase.
    pub phase: WorkPhase,
    /// Why it is unknown whether it is or will be drawn: no other arm gets it until that is known
    /// or a person decides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub doubt: Option<String>,
    /// Why it waits, or how it ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// The station that was offered it or has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<WorkMember>,
    /// The job at that station, as last reported.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub job: Option<JobView>,
    /// The stations from which a person has withdrawn it, and what may have been drawn there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub before: Vec<WorkBefore>,
}

/// The phase of a fleet job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WorkPhase {
    /// Waiting for an arm.
    Waiting,
    /// Offered to a station that has not answered yet.
    Offered,
    /// Accepted: a station has it among its jobs.
    Taken,
    /// Done.
    Done,
    /// Failed: not done, or not completely.
    Failed,
    /// Cancelled by a person.
    Cancelled,
}

/// A station that a fleet job was offered to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkMember {
    /// The fleet name.
    pub name: String,
    /// The station's id.
    pub id: String,
}

/// A station from which a person has withdrawn a fleet job that was in doubt or had failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WorkBefore {
    /// The station.
    pub member: WorkMember,
    /// What may have been drawn there, in words.
    pub drawn: String,
    /// Whether that station has answered since, so nothing more is drawn there.
    pub is_settled: bool,
}

/// How a station handles fleet jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TakesWork {
    /// Queues them; a person starts them at the arm.
    Queue,
    /// Queues and starts them, while control is free.
    Start,
}

impl WorkPhase {
    /// Returns whether the job is over.
    #[must_use]
    pub const fn is_over(self) -> bool {
        matches!(self, Self::Done | Self::Failed | Self::Cancelled)
    }
}
