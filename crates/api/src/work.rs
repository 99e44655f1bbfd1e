//! Drawings and programs for any arm of a fleet.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::JobView;

/// A drawing or a program that any arm of the fleet may do, once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WorkView {
    /// What it goes by: 32 hexadecimal digits.
    pub id: String,
    /// What a person calls it.
    pub title: String,
    /// Whose it is.
    pub student: String,
    /// The group of that one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
    /// What an arm has to have for it, as in `pen`, `a5`.
    pub needs: Vec<String>,
    /// When it was submitted, in milliseconds since 1970-01-01T00:00:00Z.
    pub submitted_ms: i64,
    /// How far it is.
    pub phase: WorkPhase,
    /// Why nobody knows whether it is or will be drawn: it is in doubt, and no other arm gets it until that is known or a
    /// person decides so.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub doubt: Option<String>,
    /// Why it waits, or how it ended.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// The station that was offered it, or has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<WorkMember>,
    /// The job there, as it was heard of last.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub job: Option<JobView>,
    /// The stations from which a person has taken it, and what may have been drawn there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub before: Vec<WorkBefore>,
}

/// How far work for any arm is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WorkPhase {
    /// It waits for an arm.
    Waiting,
    /// A station was asked to take it, and has not answered yet.
    Offered,
    /// A station has it among its jobs.
    Taken,
    /// It is done.
    Done,
    /// It was not done, or not to its end.
    Failed,
    /// A person does not want it any more.
    Cancelled,
}

/// A station that work was offered to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkMember {
    /// What it is called.
    pub name: String,
    /// The number that it goes by.
    pub id: String,
}

/// A station from which a person has taken work that was in doubt or had failed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct WorkBefore {
    /// Which.
    pub member: WorkMember,
    /// What of it may have been drawn there, in words.
    pub drawn: String,
    /// Whether that station has answered since, so that nothing more of it is drawn there.
    pub is_settled: bool,
}

/// What a station does with the work of its fleet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TakesWork {
    /// It queues it, and a person starts it at the arm.
    Queue,
    /// It starts it too, while nobody has control.
    Start,
}

impl WorkPhase {
    /// Whether nothing more will come of it.
    #[must_use]
    pub const fn is_over(self) -> bool {
        matches!(self, Self::Done | Self::Failed | Self::Cancelled)
    }
}
