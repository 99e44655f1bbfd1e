//! The messages of the WebSocket, as text.

use dobot_api::{FromClient, Problem, ToClient};
use serde::Deserialize;

use crate::http::exchange::strict_json;

/// Serialises a message to a client.
pub(crate) fn text(message: &ToClient<'_>) -> String {
    serde_json::to_string(message).expect("structures with text keys are JSON")
}

/// Parses a message of a client.
///
/// # Errors
///
/// The problem, and the id of the request if it could be read.
pub(crate) fn read(text: &[u8]) -> Result<FromClient, (Option<u64>, Problem)> {
    strict_json::read(text).map_err(|problem| {
        let numbered = serde_json::from_slice::<Numbered>(text);
        (numbered.ok().map(|message| message.id), problem)
    })
}

/// A message of which only the id is read.
#[derive(Deserialize)]
struct Numbered {
    id: u64,
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::Request;

    use super::*;

    #[test]
    fn a_message_is_read_with_its_number() {
        let read = read(br#"{"id": 7, "request": {"type": "release"}}"#).unwrap();
        assert_eq!((read.id, read.request), (7, Request::Release));
    }

    #[test]
    fn an_invalid_message_is_answered_with_its_number_if_it_has_one() {
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
            let (found, problem) = read(text.as_bytes()).unwrap_err();
            assert_eq!(found, id, "{text}");
            assert!(problem.detail.contains(word), "{text}: {}", problem.detail);
        }
    }
}
