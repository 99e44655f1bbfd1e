//! The messages of the WebSocket.

use dobot_api::{ClientId, Notice, Problem, Reply, Request, Role, State};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::kinds::INVALID;
use super::strict;

/// What a client sends over the WebSocket.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct FromClient {
    /// A number by which the client recognises the answer.
    pub(super) id: u64,
    /// What it asks for.
    pub(super) request: Request,
}

/// What the station sends over the WebSocket.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum ToClient<'a> {
    /// The first message.
    Hello {
        /// What the client has to know.
        hello: Hello,
    },
    /// The state changed. It is written once for all clients (`Snapshot`).
    #[expect(dead_code, reason = "it is here for the document")]
    State {
        /// The state.
        state: Box<State>,
    },
    /// Something happened.
    Notice {
        /// What.
        notice: &'a Notice,
    },
    /// A request was granted.
    Reply {
        /// The number of the request.
        id: u64,
        /// The answer.
        reply: Reply,
    },
    /// A request was refused, or a message not understood.
    Problem {
        /// The number of the request, if it could be read.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<u64>,
        /// What is wrong.
        problem: Problem,
    },
}

/// What a client has to know.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Hello {
    /// The client's number.
    pub(super) client: ClientId,
    /// What it may do.
    pub(super) role: Role,
    /// The version of the station.
    pub(super) version: &'static str,
    /// How long a jog button stays pressed without being said again, in seconds.
    pub(super) dead_man_s: f64,
}

impl ToClient<'_> {
    pub(super) fn text(&self) -> String {
        serde_json::to_string(self).expect("structures with text keys are JSON")
    }
}

impl FromClient {
    /// Reads a message.
    ///
    /// # Errors
    ///
    /// The problem, and the number of the request if it could be read.
    pub(super) fn read(text: &[u8]) -> Result<Self, (Option<u64>, Problem)> {
        let read = strict::read::<Self>(text).and_then(|it| match stray(text, &it.request) {
            Some(field) => Err(INVALID.problem(format!("request: unknown field `{field}`"))),
            None => Ok(it),
        });
        read.map_err(|problem| {
            let id = serde_json::from_slice::<Numbered>(text)
                .ok()
                .map(|it| it.id);
            (id, problem)
        })
    }
}

/// The number of a message whose rest may be anything.
#[derive(Deserialize)]
struct Numbered {
    id: u64,
}

/// A field of a request that takes none: reading passes over those.
fn stray(text: &[u8], request: &Request) -> Option<String> {
    #[derive(Deserialize)]
    struct Outer {
        request: serde_json::Map<String, serde_json::Value>,
    }
    if has_fields(request) {
        return None;
    }
    let outer: Outer = serde_json::from_slice(text).ok()?;
    outer
        .request
        .into_iter()
        .map(|(key, _)| key)
        .find(|key| key != "type")
}

const fn has_fields(request: &Request) -> bool {
    match request {
        Request::Command { .. }
        | Request::Jog { .. }
        | Request::Stop { .. }
        | Request::GrantLease { .. }
        | Request::ArmLaser { .. }
        | Request::SetDialect { .. }
        | Request::SubmitJob { .. }
        | Request::StartJob { .. }
        | Request::SetJobSpeed { .. }
        | Request::SetJobHeight { .. }
        | Request::CancelJob { .. } => true,
        Request::Release
        | Request::ResetStop
        | Request::TakeLease
        | Request::ReleaseLease
        | Request::AskLease
        | Request::SeizeLease
        | Request::DisarmLaser
        | Request::ConfirmPose
        | Request::Detect
        | Request::PauseJob => false,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_message_is_read_with_its_number() {
        let read = FromClient::read(br#"{"id": 7, "request": {"type": "release"}}"#).unwrap();
        assert_eq!((read.id, read.request), (7, Request::Release));
    }

    #[test]
    fn what_is_wrong_is_told_with_the_number_if_there_is_one() {
        for (text, id, word) in [
            (
                r#"{"id": 7, "request": {"type": "fly"}}"#,
                Some(7),
                "unknown variant `fly`",
            ),
            (
                r#"{"id": 7, "request": {"type": "release", "x": 1}}"#,
                Some(7),
                "unknown field `x`",
            ),
            (
                r#"{"id": 7, "request": {"type": "stop", "x": 1}}"#,
                Some(7),
                "unknown field `x`",
            ),
            (
                r#"{"id": 7, "request": {"type": "release"}, "x": 1}"#,
                Some(7),
                "unknown field `x`",
            ),
            (
                r#"{"id": -7, "request": {"type": "release"}}"#,
                None,
                "id: invalid value",
            ),
            (
                r#"{"request": {"type": "release"}}"#,
                None,
                "missing field `id`",
            ),
            ("hello", None, "line 1, column 1"),
        ] {
            let (found, problem) = FromClient::read(text.as_bytes()).unwrap_err();
            assert_eq!(found, id, "{text}");
            assert!(problem.detail.contains(word), "{text}: {}", problem.detail);
        }
    }
}
