//! Refusals, in the form for agents.

use dobot_api::{ConnectError, Problem, RemoteError};
use dobot_host::{JobsError, LongWorkError};
use rmcp::model::CallToolResult;
use serde::Serialize;
use serde_json::json;

use crate::NoStation;

/// The reason why a call failed: the station's text if the station refused.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Refused {
    /// The kind of problem, in one word.
    kind: String,
    /// The location, what was found, and what is allowed.
    detail: String,
    /// The remedy.
    #[serde(skip_serializing_if = "Option::is_none")]
    hint: Option<String>,
    /// The rule of the policy that would be violated.
    #[serde(skip_serializing_if = "Option::is_none")]
    rule: Option<String>,
    /// The position on the path where it would be violated: x, y and z in millimetres.
    #[serde(skip_serializing_if = "Option::is_none")]
    at_mm: Option<[f64; 3]>,
    /// The nearest allowed position: x, y and z in millimetres.
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest_mm: Option<[f64; 3]>,
}

impl Refused {
    pub(crate) fn new(kind: &str, detail: impl Into<String>) -> Self {
        Self {
            kind: kind.to_owned(),
            detail: detail.into(),
            hint: None,
            rule: None,
            at_mm: None,
            nearest_mm: None,
        }
    }

    pub(crate) fn hinted(self, hint: impl Into<String>) -> Self {
        Self {
            hint: Some(hint.into()),
            ..self
        }
    }

    /// Returns the result of the call.
    pub(crate) fn result(&self) -> CallToolResult {
        CallToolResult::structured_error(json!(self))
    }
}

impl From<Problem> for Refused {
    fn from(problem: Problem) -> Self {
        let kind = problem.name();
        Self {
            kind: kind.to_owned(),
            detail: problem.detail,
            hint: problem.hint,
            rule: problem.rule,
            at_mm: problem.at_mm,
            nearest_mm: problem.nearest_mm,
        }
    }
}

/// A panic is a bug here; the text contains its location.
impl From<LongWorkError> for Refused {
    fn from(error: LongWorkError) -> Self {
        Self::new("internal", error.to_string())
    }
}

impl From<ConnectError> for Refused {
    fn from(error: ConnectError) -> Self {
        let hint = error.hint();
        match error {
            ConnectError::Refused(problem) => (*problem).into(),
            error => Self {
                hint,
                ..Self::new("no-station", error.to_string())
            },
        }
    }
}

impl From<RemoteError> for Refused {
    fn from(error: RemoteError) -> Self {
        let hint = error.hint();
        match error {
            RemoteError::Refused(problem) => (*problem).into(),
            RemoteError::Failed(text) => Self {
                hint,
                ..Self::new("not-done", text)
            },
            error => Self {
                hint,
                ..Self::new("no-station", error.to_string())
            },
        }
    }
}

impl From<JobsError> for Refused {
    fn from(error: JobsError) -> Self {
        match error {
            JobsError::Connect(error) => error.into(),
            JobsError::Request(error) => error.into(),
            error => Self::new("no-station", error.to_string()),
        }
    }
}

impl From<NoStation> for Refused {
    fn from(NoStation { detail, hint }: NoStation) -> Self {
        Self {
            hint,
            ..Self::new("no-station", detail)
        }
    }
}
