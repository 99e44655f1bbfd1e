//! Agents, which use the tools of `dobot_mcp` over HTTP.

use std::sync::Arc;

use axum::Extension;
use axum::body::{Body, to_bytes};
use axum::extract::{Request, State};
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::response::Response;
use dobot_api::Problem;
use dobot_api::problem_kinds::{INVALID, MALFORMED, MEDIA_TYPE, TOO_MANY_CLIENTS, UNKNOWN_PATH};
pub(super) use dobot_mcp::HttpAgents;

use crate::http::access::auth::presented;
use crate::http::app::{App, Peer};
use crate::http::exchange::responses::{RequestFailed, collect};

/// Serves an agent: its calls are made with its own token, as for every client of the station.
pub(super) async fn agents(
    State(app): State<Arc<App>>,
    Extension(peer): Extension<Peer>,
    request: Request,
) -> Result<Response, RequestFailed> {
    if peer.by_fleet {
        let text = "path: agents must connect to each station directly, not through a fleet";
        return Err(INVALID.problem(text).into());
    }
    let place = app.place()?;
    let token = presented(request.headers())?;
    let (parts, body) = request.into_parts();
    let body = collect(body, HttpAgents::MAX_BYTES).await?;
    let request = Request::from_parts(parts, Body::from(body));
    let answer = app.agents.answer(request, token, place).await;
    let answer = answer.map_err(|error| TOO_MANY_CLIENTS.problem(error.to_string()))?;
    with_problem(answer).await
}

/// Converts an error response to a problem document, unless the protocol reports it in its own
/// message.
async fn with_problem(answer: Response) -> Result<Response, RequestFailed> {
    let status = answer.status();
    let kind = answer.headers().get(CONTENT_TYPE);
    if !status.is_client_error() || kind.is_some_and(|kind| kind == "application/json") {
        return Ok(answer);
    }
    let text = to_bytes(answer.into_body(), LONGEST_TEXT).await;
    let text = String::from_utf8_lossy(&text.unwrap_or_default()).into_owned();
    Err(problem(status, &text).into())
}

fn problem(status: StatusCode, text: &str) -> Problem {
    match status {
        StatusCode::NOT_FOUND => UNKNOWN_PATH.hinted(
            "there is no such session: it has ended, or the station was restarted",
            "start a new session with `initialize`",
        ),
        StatusCode::NOT_ACCEPTABLE => MALFORMED.hinted(
            "the Accept header does not allow the response formats for agents",
            "send `Accept: application/json, text/event-stream`",
        ),
        StatusCode::UNSUPPORTED_MEDIA_TYPE => MEDIA_TYPE.hinted(
            "the body is not JSON",
            "send `Content-Type: application/json`",
        ),
        _ => MALFORMED.problem(text),
    }
}

/// The maximum length of an error text, in bytes.
const LONGEST_TEXT: usize = 4096;
