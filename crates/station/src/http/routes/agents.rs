//! The endpoint for agents.

use axum::http::Method;
use dobot_api::problem_kinds::{
    INVALID, MEDIA_TYPE, NOT_BUILT, TIMEOUT, TOO_LARGE, TOO_MANY_CLIENTS, UNKNOWN_PATH,
};

use super::{DELETE, GET, POST};
use crate::http::agents;
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        agents(
            POST,
            "A message of an agent (Model Context Protocol, streamable HTTP): each tool uses the token of the \
                request. Closing the connection before the response cancels the call, and the arm \
                is stopped if the call has moved it.",
        )
        .gives_nothing(202, "the message is accepted, without a response"),
        agents(
            GET,
            "Messages of the server to an agent, as server-sent events",
        ),
        agents(DELETE, "Ends the session of an agent").gives_nothing(202, "the session has ended"),
    ]
}

fn agents(method: Method, summary: &'static str) -> Route {
    Route::new(method, "/mcp", summary, agents::agents)
        .gives_text(200, "text/event-stream", "messages of the protocol")
        .problems(&[
            INVALID,
            MEDIA_TYPE,
            NOT_BUILT,
            TIMEOUT,
            TOO_LARGE,
            TOO_MANY_CLIENTS,
            UNKNOWN_PATH,
        ])
}
