//! Refusals as documents (RFC 9457).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Refusal;

/// A refusal as a problem document (RFC 9457, `application/problem+json`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Problem {
    /// The kind of problem; the address tells about it.
    #[serde(rename = "type")]
    pub kind: String,
    /// The kind of problem in words.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// What is wrong: where, what was found, what is allowed.
    pub detail: String,
    /// What to do about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// Which rule of the policy was broken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<String>,
    /// Where on its way a motion would break the rule: x, y, z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_mm: Option<[f64; 3]>,
    /// The nearest place that is allowed: x, y, z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest_mm: Option<[f64; 3]>,
}

impl Problem {
    /// A problem of a kind that only the web interface knows.
    #[must_use]
    pub fn new(kind: &str, title: &str, status: u16, detail: impl Into<String>) -> Self {
        Self {
            kind: format!("/api/v1/problems/{kind}"),
            title: title.to_owned(),
            status,
            detail: detail.into(),
            hint: None,
            rule: None,
            at_mm: None,
            nearest_mm: None,
        }
    }
}

impl From<&Refusal> for Problem {
    fn from(refusal: &Refusal) -> Self {
        let (title, status) = title_and_status(refusal);
        let mut problem = Self::new(refusal.kind(), title, status, refusal.to_string());
        problem.hint = refusal.hint();
        if let Refusal::Policy(violation) = refusal {
            problem.rule = Some(violation.rule.clone());
            problem.nearest_mm = violation.nearest;
            problem.at_mm = violation.at.as_ref().map(|it| it.position_mm);
        }
        problem
    }
}

const fn title_and_status(refusal: &Refusal) -> (&'static str, u16) {
    match refusal {
        Refusal::Role { .. } => ("the role does not allow this", 403),
        Refusal::NoLease { .. } => ("this client does not have control", 409),
        Refusal::NotAsking(_) => ("nobody asks for control", 409),
        Refusal::Stopped { .. } => ("the arm is stopped", 409),
        Refusal::StillMoving { .. } => ("the arm still moves", 409),
        Refusal::LetGo(_) => ("the button was let go", 409),
        Refusal::NoLink(_) => ("there is no arm", 503),
        Refusal::Send(_) => ("the command is not sent", 422),
        Refusal::Policy(_) => ("the policy does not allow this", 422),
        Refusal::LaserDisarmed => ("the laser is disarmed", 409),
        Refusal::OutOfRange { .. } => ("a number is not allowed", 422),
        Refusal::TooMany { .. } => ("too much waits already", 429),
        Refusal::JobRunning(_) => ("a job has the arm", 409),
        Refusal::Detecting => ("the arm is finding out its dialect", 409),
        Refusal::NotFound(_) => ("the dialect was not found", 422),
        Refusal::NoJobRuns => ("no job is running", 409),
        Refusal::NoSuchJob(_) => ("there is no such job", 404),
        Refusal::JobPhase { .. } => ("the job does not allow this now", 409),
        Refusal::NoVectors(_) => ("the job has no vectors", 409),
        Refusal::BadJob { .. } => ("the job cannot be done", 422),
        Refusal::CannotResume(_) => ("the job cannot be gone on with", 409),
        Refusal::Journal(_) => ("the journal cannot be written", 507),
        Refusal::Malformed(_) => ("the request cannot be understood", 400),
        Refusal::Ending => ("the station is shutting down", 503),
    }
}
