//! What everyone may see: the document, the state of the arm.

use dobot_api::problem_kinds::{
    ENDING, MALFORMED, ProblemKind, TOO_MANY_CLIENTS, UNKNOWN_PATH, UPGRADE,
};
use dobot_api::{Notice, State};
use dobot_safety::Policy;

use super::super::route::Route;
use super::super::{calls, socket};
use super::GET;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/openapi.json",
            "This document",
            calls::document,
        )
        .open()
        .gives::<serde_json::Value>(200, "this document"),
        Route::new(
            GET,
            "/api/v1/problems/{kind}",
            "Explains a kind of problem",
            calls::problem,
        )
        .open()
        .gives::<ProblemKind>(200, "the kind")
        .problems(&[UNKNOWN_PATH]),
        Route::new(
            GET,
            "/api/v1/state",
            "What the station knows now",
            calls::state,
        )
        .gives::<State>(200, "the state"),
        Route::new(
            GET,
            "/api/v1/notices",
            "What happened lately, the oldest first",
            calls::notices,
        )
        .gives::<Vec<Notice>>(200, "the notices"),
        Route::new(
            GET,
            "/api/v1/policy",
            "The safety policy, as `dobot policy` shows it",
            calls::policy,
        )
        .gives::<Policy>(200, "the policy"),
        Route::new(
            GET,
            "/api/v1/ws",
            "A WebSocket for states, notices and requests. The station sends \
                messages as in `ToClient`, the client as in `FromClient`, both as \
                text. The lease of the client ends with the connection. A browser, \
                which cannot send headers, offers the subprotocols `dobot` and \
                `dobot.token.<token>`.",
            socket::upgrade,
        )
        .queries(socket::QUERIES)
        .gives_text(101, "text/plain", "the protocol changes to WebSocket")
        .problems(&[MALFORMED, UPGRADE, TOO_MANY_CLIENTS, ENDING]),
    ]
}
