//! Control of the arm.

use std::sync::Arc;

use axum::Json;
use dobot_api::problem_kinds::{
    BAD_SLOTS, INVALID, LOCKED, NO_LEASE, NOT_ASKING, SLOT, TOO_MANY_CLIENTS,
};
use dobot_api::{ClientId, LeaseView, Problem, Reply, Request, TimeSlot};
use dobot_host::Client;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{DELETE, GET, POST, PUT};
use crate::http::access::http_leases::LASTS;
use crate::http::app::Caller;
use crate::http::exchange::requester::{Requester, is_name};
use crate::http::exchange::responses::{Body, Maybe, Nothing, RequestFailed};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    // table
    vec![
        holds(
            "/api/v1/lease",
            "Takes control if it is free; with a lease token, renews the lease",
            "control",
            Request::TakeLease,
        )
        .problems(&[NO_LEASE, LOCKED, SLOT, TOO_MANY_CLIENTS]),
        Route::new(DELETE, "/api/v1/lease", "Releases control", release)
            .brings::<Maybe<Nothing>>()
            .gives::<Reply>(200, "control is free")
            .problems(&[NO_LEASE]),
        holds(
            "/api/v1/lease/ask",
            "Asks the lease holder for control; the state shows when it is granted",
            "a lease token, valid when control is granted",
            Request::AskLease,
        )
        .problems(&[LOCKED, SLOT, TOO_MANY_CLIENTS]),
        Route::asks(
            POST,
            "/api/v1/lease/grant",
            "Grants control to a client that asked for it",
            |Body(new): Body<HandOver>| Request::GrantLease { to: new.to },
        )
        .example(r#"{"to": 3}"#)
        .gives::<Reply>(200, "the new lease holder")
        .problems(&[NO_LEASE, NOT_ASKING, LOCKED, SLOT]),
        holds(
            "/api/v1/lease/seize",
            "Takes control from the lease holder (admin)",
            "control",
            Request::SeizeLease,
        )
        .problems(&[TOO_MANY_CLIENTS]),
        Route::asks(
            POST,
            "/api/v1/lock",
            "Locks the arm for administrators (admin): any other lease ends, and a running job is paused",
            |Maybe(new): Maybe<NewLock>| Request::Lock {
                message: new.message,
            },
        )
        .example(r#"{"message": "eyes on me"}"#)
        .gives::<Reply>(200, "the arm is locked"),
        Route::asks(
            DELETE,
            "/api/v1/lock",
            "Unlocks the arm (admin)",
            |_: Maybe<Nothing>| Request::Unlock,
        )
        .gives::<Reply>(200, "the arm is unlocked"),
        Route::new(
            GET,
            "/api/v1/slots",
            "All current and future time slots, in order",
            slots,
        )
        .gives::<Reply>(200, "the slots"),
        Route::asks(
            PUT,
            "/api/v1/slots",
            "Replaces the time slots (admin): during a slot only its student and \
                administrators can take control",
            |Body(new): Body<NewSlots>| Request::SetSlots { slots: new.slots },
        )
        .example(SLOTS_EXAMPLE)
        .gives::<Reply>(200, "the slots")
        .problems(&[BAD_SLOTS]),
        Route::asks(
            DELETE,
            "/api/v1/slots",
            "Removes all time slots (admin)",
            |_: Maybe<Nothing>| Request::SetSlots { slots: Vec::new() },
        )
        .gives::<Reply>(200, "no time slots are left"),
        Route::asks(
            POST,
            "/api/v1/message",
            "Sends a message to all observers",
            |Body(new): Body<NewMessage>| Request::Message { text: new.text },
        )
        .example(r#"{"text": "five more minutes"}"#)
        .gives::<Reply>(200, "the message is sent"),
    ]
}

/// A lock of the arm.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewLock {
    /// The message for others. Cut to 200 characters.
    #[serde(default)]
    message: Option<String>,
}

const SLOTS_EXAMPLE: &str = r#"{"slots": [{"student": "Anna", "starts_in_s": 0, "ends_in_s": 900}, {"student": "Ben", "group": "red", "starts_in_s": 900, "ends_in_s": 1800}]}"#;

/// The time slots of the arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewSlots {
    /// The slots, in any order: up to 200, without overlaps.
    #[schemars(length(max = 200))]
    slots: Vec<TimeSlot>,
}

/// A message to all observers.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewMessage {
    /// The text. Cut to 200 characters.
    text: String,
}

/// Returns a route that requests control, and stores the client if it is granted.
fn holds(path: &'static str, summary: &'static str, what: &'static str, request: Request) -> Route {
    let hold = move |requester: Requester, Maybe(wanted): Maybe<LeaseRequest>| {
        hold(requester, wanted, request)
    };
    Route::new(POST, path, summary, hold)
        .brings::<Maybe<LeaseRequest>>()
        .example(r#"{"name": "my script"}"#)
        .gives::<Granted>(200, what)
}

/// A request for control.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LeaseRequest {
    /// The name of the client.
    #[serde(default)]
    #[schemars(length(min = 1, max = 60))]
    name: Option<String>,
}

/// A granted or pending lease.
#[derive(Debug, Serialize, JsonSchema)]
struct Granted {
    /// The value of the header `Dobot-Lease` for all requests with this lease.
    token: String,
    /// The time after which the unused token expires, in seconds.
    lasts_s: u64,
    /// The current lease, if any.
    lease: Option<LeaseView>,
}

/// The new lease holder.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HandOver {
    /// One of the clients that asked for control.
    to: ClientId,
}

/// Requests control, and stores the client if it is granted.
async fn hold(
    requester: Requester,
    wanted: LeaseRequest,
    request: Request,
) -> Result<Json<Granted>, RequestFailed> {
    let name = called(wanted, &requester.caller)?;
    let client = match &requester.lease {
        Some(_) => requester.client().await?,
        None => requester.come(&name, None).await?,
    };
    let reply = client.request(request).await?;
    let app = &requester.app;
    let token = match &requester.lease {
        Some(token) => token.clone(),
        None => new_token(&requester, client)?,
    };
    let lease = match reply {
        Reply::Lease { lease } => lease,
        _ => app.handle.state().state().lease.clone(),
    };
    Ok(Json(Granted {
        token,
        lasts_s: LASTS.as_secs(),
        lease,
    }))
}

/// Stores a client with a new token.
fn new_token(requester: &Requester, client: Arc<Client>) -> Result<String, Problem> {
    let app = &requester.app;
    let token = app
        .http_leases
        .keep(client, requester.caller.clone(), app.now())?;
    Ok(token.secret().into())
}

/// Returns the client's requested name, or the name of its token.
fn called(wanted: LeaseRequest, caller: &Caller) -> Result<String, Problem> {
    let Some(name) = wanted.name else {
        return Ok(caller.name.clone());
    };
    if is_name(&name) {
        return Ok(name);
    }
    Err(INVALID.problem("name: allowed are 1 to 60 printable characters"))
}

async fn slots(requester: Requester) -> Result<Json<Reply>, RequestFailed> {
    requester.ask(Request::ShowSlots).await
}

async fn release(requester: Requester, _: Maybe<Nothing>) -> Result<Json<Reply>, RequestFailed> {
    let Some(token) = requester.lease.clone() else {
        return Err(NO_LEASE
            .hinted(
                "this request requires a lease token",
                "send it as header `Dobot-Lease`",
            )
            .into());
    };
    let reply = requester.ask(Request::ReleaseLease).await;
    requester.app.http_leases.end(&token);
    reply
}
