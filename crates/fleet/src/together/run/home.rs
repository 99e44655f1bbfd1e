//! The station through which requests to the others are sent.

use dobot_api::problem_kinds::{ENDING, MEMBER_AWAY, ProblemKind, TIMEOUT};
use dobot_api::{ApiAnswer, MemberAnswer, Problem, StationAddress, post};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// The station through which requests to the others are sent, with a token that each of them
/// accepts.
#[derive(Clone, Debug)]
pub struct Home {
    address: StationAddress,
}

/// A request to a station.
#[derive(Clone, Debug, Default)]
pub(super) struct Asked {
    pub(super) method: &'static str,
    pub(super) path: String,
    pub(super) lease: Option<String>,
    pub(super) key: Option<String>,
    pub(super) body: Option<Value>,
}

/// The error returned when a request was not carried out.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum AskError {
    /// The station refused it.
    #[error("{detail}")]
    Refused {
        /// The last part of the problem's type.
        kind: String,
        /// The reason and the remedy.
        detail: String,
    },
    /// No response: it may have been carried out or not.
    #[error("{0}")]
    Unclear(String),
}

impl Home {
    /// Returns the station at an address, which must belong to a fleet.
    #[must_use]
    pub const fn new(address: StationAddress) -> Self {
        Self { address }
    }

    /// Sends a request to one station of the fleet.
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
        let none = || AskError::Unclear("no response".to_owned());
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

/// Parses a response. A station that is away has refused nothing.
fn read<T: DeserializeOwned>(answer: &ApiAnswer) -> Result<T, AskError> {
    if answer.is_success() {
        let body = serde_json::from_value(answer.body.clone());
        return body.map_err(|error| {
            AskError::Unclear(format!("its station sent an unreadable response: {error}"))
        });
    }
    let Ok(problem) = serde_json::from_value::<Problem>(answer.body.clone()) else {
        let status = answer.status;
        return Err(AskError::Unclear(format!(
            "its station responded with status {status}"
        )));
    };
    let kind = problem.name().to_owned();
    let hint = problem.hint.map(|hint| format!("; {hint}"));
    let hint = hint.unwrap_or_default();
    let detail = format!("{}{hint}", problem.detail);
    if UNCLEAR.iter().any(|unclear| unclear.name == kind) {
        return Err(AskError::Unclear(detail));
    }
    Err(AskError::Refused { kind, detail })
}

const REQUESTS: &str = "/api/v1/fleet/requests";
/// Problems after which the station may still have carried out the request.
const UNCLEAR: [&ProblemKind; 3] = [&MEMBER_AWAY, &ENDING, &TIMEOUT];
