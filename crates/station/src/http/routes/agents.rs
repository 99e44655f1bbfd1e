//! What agents come by.

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
            "A message of an agent (Model Context Protocol, streamable HTTP): each tool acts with the token that comes \
                with it. One who ends the connection before the answer has given up what was asked for, and the arm \
                is stopped where it was moved for that.",
        )
        .gives_nothing(202, "the message is taken, and nothing is answered to it"),
        agents(
            GET,
            "What the server tells an agent of itself, as server-sent events",
        ),
        agents(DELETE, "Ends the session of an agent").gives_nothing(202, "the session is over"),
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
