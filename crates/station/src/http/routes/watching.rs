//! Routes for observers: the document, the state of the arm.

use dobot_api::problem_kinds::{
    BAD_POLICY, DETECTING, ENDING, JOB_RUNNING, MALFORMED, POLICY_FILE, ProblemKind, STILL_MOVING,
    TOO_MANY_CLIENTS, UNKNOWN_PATH, UPGRADE,
};
use dobot_api::{Notice, State};
use dobot_safety::Policy;

use super::{GET, POST, PUT};
use crate::http::arm_facts::ArmFacts;
use crate::http::exchange::requester::{EditPolicy, PolicyDraft, PolicyText};
use crate::http::exchange::responses::Body;
use crate::http::route::Route;
use crate::http::{exchange::requester, live::socket};

pub(super) fn all() -> Vec<Route> {
    // table
    vec![
        Route::new(
            GET,
            "/api/v1/openapi.json",
            "This document",
            requester::document,
        )
        .open()
        .gives::<serde_json::Value>(200, "this document"),
        Route::new(
            GET,
            "/api/v1/problems/{kind}",
            "Explains a problem type",
            requester::problem,
        )
        .open()
        .gives::<ProblemKind>(200, "the kind")
        .problems(&[UNKNOWN_PATH]),
        Route::new(
            GET,
            "/api/v1/state",
            "The state of the station",
            requester::state,
        )
        .gives::<State>(200, "the state"),
        Route::new(
            GET,
            "/api/v1/arm",
            "The facts of the arm: its lengths, tools, limits and periods, and the meaning of mouse and gesture packets in its \
                dialect. They change with the policy and the dialect",
            requester::arm,
        )
        .gives::<ArmFacts>(200, "the facts"),
        Route::new(
            GET,
            "/api/v1/notices",
            "The latest notices, the oldest first",
            requester::notices,
        )
        .gives::<Vec<Notice>>(200, "the notices"),
        Route::new(
            GET,
            "/api/v1/policy",
            "The safety policy, as shown by `dobot policy`",
            requester::policy,
        )
        .gives::<Policy>(200, "the policy"),
        Route::new(
            GET,
            "/api/v1/policy/text",
            "The safety policy as a TOML text, with its comments if it came from a file",
            requester::policy_text,
        )
        .gives_text(200, "text/plain; charset=utf-8", "the text"),
        Route::new(
            PUT,
            "/api/v1/policy",
            "Replaces and stores the safety policy; \
                the arm must be idle. With `check` the text is only validated",
            requester::set_policy,
        )
        .brings::<Body<PolicyText>>()
        .example(r#"{"text": "[table]\nz_mm = -60\n", "check": true}"#)
        .gives::<Policy>(200, "the policy")
        .problems(&[BAD_POLICY, JOB_RUNNING, DETECTING, STILL_MOVING, POLICY_FILE]),
        Route::new(
            POST,
            "/api/v1/policy/keep-outs",
            "Adds, replaces or removes a keep-out zone in the text of a draft; the rest keeps its comments and its format, and the \
                active policy is unchanged",
            requester::edit_policy,
        )
        .brings::<Body<EditPolicy>>()
        .example(EDIT_EXAMPLE)
        .gives::<PolicyDraft>(200, "the text")
        .problems(&[BAD_POLICY]),
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
        .gives_nothing(101, "the protocol changes to WebSocket")
        .problems(&[MALFORMED, UPGRADE, TOO_MANY_CLIENTS, ENDING]),
    ]
}

const EDIT_EXAMPLE: &str = r#"{"text": "[table]\nz_mm = -60\n", "edit": {"type": "add", "keep_out": {"box": {"x_mm": [200, 260], "y_mm": [80, 140], "z_mm": [-60, 0]}}}}"#;
