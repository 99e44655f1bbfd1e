//! The station by which the others are asked.

use dobot_api::problem_kinds::{ENDING, MEMBER_AWAY, ProblemKind, TIMEOUT};
use dobot_api::{ApiAnswer, MemberAnswer, Problem, StationAddress, post};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// The station by which the others are asked, with the token that each of them accepts.
#[derive(Clone, Debug)]
pub struct Home {
    address: StationAddress,
}

/// What a station is asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Asked {
    pub(super) method: &'static str,
    pub(super) path: String,
    pub(super) lease: Option<String>,
    pub(super) key: Option<String>,
    pub(super) body: Option<Value>,
}

/// Why a station has not done what it was asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum AskError {
    /// It has refused it.
    #[error("{detail}")]
    Refused {
        /// The end of the address of the kind of problem.
        kind: String,
        /// Why, and what to do.
        detail: String,
    },
    /// No answer came: it may have done it or not.
    #[error("{0}")]
    Unclear(String),
}

impl Home {
    /// The station at an address, which belongs to a fleet.
    #[must_use]
    pub const fn new(address: StationAddress) -> Self {
        Self { address }
    }

    /// Asks one station of the fleet.
    pub(super) async fn ask<T: DeserializeOwned>(
        &self,
        arm: &str,
        asked: &Asked,
    ) -> Result<T, AskError> {
        let request = json!({
            "to": { "members": [arm] },
            "method": asked.method,
            "path": asked.path,
            "lease": asked.lease,
            "key": asked.key,
            "body": asked.body,
        });
        let answers: Result<Vec<MemberAnswer>, _> = post(&self.address, REQUESTS, &request).await;
        let answers = answers.map_err(|error| AskError::Unclear(error.to_string()))?;
        let none = || AskError::Unclear("no answer came".to_owned());
        read(&answers.into_iter().next().ok_or_else(none)?.answer)
    }
}

impl Asked {
    pub(super) fn get(path: &str) -> Self {
        Self {
            method: "GET",
            path: path.to_owned(),
            ..Self::default()
        }
    }

    pub(super) fn post(path: &str) -> Self {
        Self {
            method: "POST",
            ..Self::get(path)
        }
    }
}

impl AskError {
    /// Whether it is this kind of problem.
    pub(super) fn is(&self, kind: &str) -> bool {
        matches!(self, Self::Refused { kind: found, .. } if found == kind)
    }
}

/// What an answer says. A station that is away has refused nothing.
fn read<T: DeserializeOwned>(answer: &ApiAnswer) -> Result<T, AskError> {
    if answer.is_success() {
        let body = serde_json::from_value(answer.body.clone());
        return body.map_err(|error| {
            AskError::Unclear(format!(
                "its station answers what is not understood: {error}"
            ))
        });
    }
    let Ok(problem) = serde_json::from_value::<Problem>(answer.body.clone()) else {
        let status = answer.status;
        return Err(AskError::Unclear(format!(
            "its station answers with the status {status}"
        )));
    };
    let kind = problem.name().to_owned();
    let hint = problem.hint.map(|it| format!("; {it}")).unwrap_or_default();
    let detail = format!("{}{hint}", problem.detail);
    if UNCLEAR.iter().any(|it| it.name == kind) {
        return Err(AskError::Unclear(detail));
    }
    Err(AskError::Refused { kind, detail })
}

const REQUESTS: &str = "/api/v1/fleet/requests";
/// Where a station may have done what it was asked for all the same.
const UNCLEAR: [&ProblemKind; 3] = [&MEMBER_AWAY, &ENDING, &TIMEOUT];
