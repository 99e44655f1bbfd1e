//! Agents, which come over HTTP to the tools of `dobot_mcp`.

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
use crate::http::exchange::answer::{NotDone, collect};

/// Answers an agent: what it asks for is done with its own token, as for every client of the station.
pub(super) async fn agents(
    State(app): State<Arc<App>>,
    Extension(peer): Extension<Peer>,
    request: Request,
) -> Result<Response, NotDone> {
    if peer.by_fleet {
        let text = "path: agents come to each station by themselves, and not through a fleet";
        return Err(INVALID.problem(text).into());
    }
    let place = app.place()?;
    let token = presented(request.headers())?;
    let (parts, body) = request.into_parts();
    let body = collect(body, HttpAgents::MOST_BYTES).await?;
    let request = Request::from_parts(parts, Body::from(body));
    let answer = app.agents.answer(request, token, place).await;
    let answer = answer.map_err(|error| TOO_MANY_CLIENTS.problem(error.to_string()))?;
    told(answer).await
}

/// What is wrong with a request is told as everywhere here, unless the protocol tells it in a message of its own.
async fn told(answer: Response) -> Result<Response, NotDone> {
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
            "there is no such session: it is over, or the station was started again",
            "begin another one with `initialize`",
        ),
        StatusCode::NOT_ACCEPTABLE => MALFORMED.hinted(
            "the Accept header does not name what agents are answered in",
            "send `Accept: application/json, text/event-stream`",
        ),
        StatusCode::UNSUPPORTED_MEDIA_TYPE => MEDIA_TYPE.hinted(
            "the body is no JSON",
            "send `Content-Type: application/json`",
        ),
        _ => MALFORMED.problem(text),
    }
}

/// How long a text about what is wrong may be, in bytes.
const LONGEST_TEXT: usize = 4096;
