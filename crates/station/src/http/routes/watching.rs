//! What everyone may see: the page, the document, the state of the arm.

use std::sync::Arc;

use axum::handler::Handler;
use dobot_api::kinds::{ENDING, Kind, MALFORMED, TOO_MANY_CLIENTS, UNKNOWN_PATH, UPGRADE};
use dobot_api::{Notice, State};
use dobot_safety::Policy;

use super::super::app::App;
use super::super::route::Route;
use super::super::{calls, page, socket};
use super::GET;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(GET, "/", "A page to watch and move the arm", page::html)
            .open()
            .gives_text(200, "text/html", "the page"),
        Route::new(GET, "/page.css", "How the page looks", page::css)
            .open()
            .gives_text(200, "text/css", "the style"),
        script("/page.js", "What the page does", page::js),
        script("/preview.js", "Shows a drawing in time", page::preview),
        script(
            "/timeline.js",
            "What is at a moment of a drawing",
            page::timeline,
        ),
        script(
            "/reader.js",
            "Reads the timeline of a drawing",
            page::reader,
        ),
        script("/look.js", "How a drawing in time looks", page::look),
        script("/sketch.js", "Draws a drawing in time", page::sketch),
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
        .gives::<Kind>(200, "the kind")
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

/// A part of the page; browsers refuse it as a module unless it says that it is one.
fn script<H: Handler<T, Arc<App>>, T: 'static>(
    path: &'static str,
    summary: &'static str,
    handler: H,
) -> Route {
    Route::new(GET, path, summary, handler)
        .open()
        .gives_text(200, "text/javascript", "the module")
}
