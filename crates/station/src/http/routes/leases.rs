//! Control of the arm.

use axum::Json;
use dobot_api::problem_kinds::{
    BAD_SLOTS, INVALID, LOCKED, NO_LEASE, NOT_ASKING, SLOT, TOO_MANY_CLIENTS,
};
use dobot_api::{ClientId, LeaseView, Problem, Reply, Request, TimeSlot};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{DELETE, GET, POST, PUT};
use crate::http::access::http_leases::LASTS;
use crate::http::app::Caller;
use crate::http::exchange::answer::{Body, Maybe, NotDone, Nothing};
use crate::http::exchange::requester::{Asker, is_name};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        holds(
            "/api/v1/lease",
            "Takes control, if nobody has it; with a lease token it renews the lease",
            "control",
            Request::TakeLease,
        )
        .problems(&[NO_LEASE, LOCKED, SLOT, TOO_MANY_CLIENTS]),
        Route::new(DELETE, "/api/v1/lease", "Gives control back", release)
            .brings::<Maybe<Nothing>>()
            .gives::<Reply>(200, "control is free")
            .problems(&[NO_LEASE]),
        holds(
            "/api/v1/lease/ask",
            "Asks the holder for control; the state tells when it is granted",
            "a lease token, for when control is granted",
            Request::AskLease,
        )
        .problems(&[LOCKED, SLOT, TOO_MANY_CLIENTS]),
        Route::asks(
            POST,
            "/api/v1/lease/grant",
            "Gives control to one who asked",
            |Body(new): Body<HandOver>| Request::GrantLease { to: new.to },
        )
        .example(r#"{"to": 3}"#)
        .gives::<Reply>(200, "who has control now")
        .problems(&[NO_LEASE, NOT_ASKING, LOCKED, SLOT]),
        holds(
            "/api/v1/lease/seize",
            "Takes control from whoever has it (admin)",
            "control",
            Request::SeizeLease,
        )
        .problems(&[TOO_MANY_CLIENTS]),
        Route::asks(
            POST,
            "/api/v1/lock",
            "Keeps the arm for administrators (admin): whoever else has control loses it, and a job that runs is paused",
            |Maybe(new): Maybe<NewLock>| Request::Lock {
                message: new.message,
            },
        )
        .example(r#"{"message": "eyes on me"}"#)
        .gives::<Reply>(200, "the arm is locked"),
        Route::asks(
            DELETE,
            "/api/v1/lock",
            "Lets everyone take control again (admin)",
            |_: Maybe<Nothing>| Request::Unlock,
        )
        .gives::<Reply>(200, "the arm is not locked"),
        Route::new(
            GET,
            "/api/v1/slots",
            "All time slots that are not over, in their order",
            slots,
        )
        .gives::<Reply>(200, "the slots"),
        Route::asks(
            PUT,
            "/api/v1/slots",
            "Says whose the arm is and when, in place of what was said before (admin): while a slot is under way only its student and \
                administrators have control",
            |Body(new): Body<NewSlots>| Request::SetSlots { slots: new.slots },
        )
        .example(SLOTS_EXAMPLE)
        .gives::<Reply>(200, "the slots")
        .problems(&[BAD_SLOTS]),
        Route::asks(
            DELETE,
            "/api/v1/slots",
            "Ends all time slots (admin): the arm is everyone's",
            |_: Maybe<Nothing>| Request::SetSlots { slots: Vec::new() },
        )
        .gives::<Reply>(200, "there are none"),
        Route::asks(
            POST,
            "/api/v1/message",
            "Tells something to all who watch",
            |Body(new): Body<NewMessage>| Request::Message { text: new.text },
        )
        .example(r#"{"text": "five more minutes"}"#)
        .gives::<Reply>(200, "it is told"),
    ]
}

/// Why the arm is locked.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewLock {
    /// For those who want to move the arm. What is longer than 200 characters is cut.
    #[serde(default)]
    message: Option<String>,
}

const SLOTS_EXAMPLE: &str = r#"{"slots": [{"student": "Anna", "starts_in_s": 0, "ends_in_s": 900}, {"student": "Ben", "group": "red", "starts_in_s": 900, "ends_in_s": 1800}]}"#;

/// Whose the arm is, and when.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewSlots {
    /// The slots, in any order: up to 200, none of which overlaps another one.
    #[schemars(length(max = 200))]
    slots: Vec<TimeSlot>,
}

/// What to tell.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewMessage {
    /// The text. What is longer than 200 characters is cut.
    text: String,
}

/// A route that asks for control, and keeps the client if that is granted.
fn holds(path: &'static str, summary: &'static str, what: &'static str, request: Request) -> Route {
    let hold = move |asker: Asker, Maybe(wanted): Maybe<LeaseRequest>| hold(asker, wanted, request);
    Route::new(POST, path, summary, hold)
        .brings::<Maybe<LeaseRequest>>()
        .example(r#"{"name": "my script"}"#)
        .gives::<Granted>(200, what)
}

/// Who wants control.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LeaseRequest {
    /// What the client calls itself.
    #[serde(default)]
    #[schemars(length(min = 1, max = 60))]
    name: Option<String>,
}

/// Control, or the hope for it.
#[derive(Debug, Serialize, JsonSchema)]
struct Granted {
    /// What to send as header `Dobot-Lease` with all requests that go with it.
    token: String,
    /// How long the token lasts without being used, in seconds.
    lasts_s: u64,
    /// Who has control now, if anybody has.
    lease: Option<LeaseView>,
}

/// Who is to get control.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct HandOver {
    /// One of those who ask.
    to: ClientId,
}

/// Asks for control, and keeps the client if that is granted.
async fn hold(
    asker: Asker,
    wanted: LeaseRequest,
    request: Request,
) -> Result<Json<Granted>, NotDone> {
    let name = called(wanted, &asker.caller)?;
    let client = match &asker.lease {
        Some(_) => asker.client().await?,
        None => asker.come(&name).await?,
    };
    let reply = client.request(request).await?;
    let app = &asker.app;
    let token = match &asker.lease {
        Some(token) => token.clone(),
        None => app
            .http_leases
            .keep(client, asker.caller.clone(), app.now())?
            .secret()
            .into(),
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

/// What a client wants to be called, or else what its token is called.
fn called(wanted: LeaseRequest, caller: &Caller) -> Result<String, Problem> {
    let Some(name) = wanted.name else {
        return Ok(caller.name.clone());
    };
    if is_name(&name) {
        return Ok(name);
    }
    Err(INVALID.problem("name: this takes 1 to 60 characters that can be printed"))
}

async fn slots(asker: Asker) -> Result<Json<Reply>, NotDone> {
    asker.ask(Request::ShowSlots).await
}

async fn release(asker: Asker, _: Maybe<Nothing>) -> Result<Json<Reply>, NotDone> {
    let Some(token) = asker.lease.clone() else {
        return Err(NO_LEASE
            .hinted(
                "this request comes without a lease token",
                "send it as header `Dobot-Lease`",
            )
            .into());
    };
    let reply = asker.ask(Request::ReleaseLease).await;
    asker.app.http_leases.end(&token);
    reply
}
