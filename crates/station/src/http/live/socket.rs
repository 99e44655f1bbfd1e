//! WebSockets: from the request to upgrade to the last word.

mod connection;
mod receive;
mod send;
mod state_stream;

use std::sync::Arc;

use axum::Extension;
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::ws::rejection::WebSocketUpgradeRejection;
use axum::extract::{Query as UrlQuery, State};
use axum::http::Uri;
use axum::response::Response;
use dobot_api::problem_kinds::{MALFORMED, UPGRADE};
use dobot_api::{Problem, Role};
use futures_util::StreamExt;
use schemars::SchemaGenerator;
use serde::Deserialize;

pub(crate) use self::state_stream::{StateStream, message as state_message};

use self::connection::SocketConnection;
use crate::http::app::{App, Caller, Peer};
use crate::http::exchange::answer::{BODY, JOB, NotDone};
use crate::http::exchange::requester::is_name;
use crate::http::route::Query;

/// What a client chooses when it connects.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Wants {
    states: Option<f64>,
    notices: Option<bool>,
    name: Option<String>,
}

/// The same for the document.
pub(crate) const QUERIES: &[Query] = &[
    Query {
        name: "states",
        what: "The most states in a second, 0 to 1000; without it every one comes (12.5 in a second, and those with events)",
        schema: SchemaGenerator::subschema_for::<f64>,
    },
    Query {
        name: "notices",
        what: "Whether notices come; true without it",
        schema: SchemaGenerator::subschema_for::<bool>,
    },
    Query {
        name: "name",
        what: "What the client calls itself, in 1 to 60 characters",
        schema: SchemaGenerator::subschema_for::<String>,
    },
];

/// Of these, what one chooses who only watches.
pub(crate) const WATCH_QUERIES: &[Query] = QUERIES.split_at(2).0;

impl Wants {
    /// What one chooses who only watches: it needs no name.
    pub(crate) fn of_one_who_watches(uri: &Uri) -> Result<Self, Problem> {
        let wants = Self::of(uri)?;
        if wants.name.is_some() {
            return Err(
                MALFORMED.problem("the query of the address: name; allowed are states and notices")
            );
        }
        Ok(wants)
    }

    /// The most states in a second; every one where it is not said.
    pub(crate) const fn states(&self) -> Option<f64> {
        self.states
    }

    /// Whether notices come.
    pub(crate) fn notices(&self) -> bool {
        self.notices.unwrap_or(true)
    }

    fn of(uri: &Uri) -> Result<Self, Problem> {
        let UrlQuery(wants) = UrlQuery::<Self>::try_from_uri(uri).map_err(|error| {
            MALFORMED.problem(format!("the query of the address: {}", error.body_text()))
        })?;
        wants.check()?;
        Ok(wants)
    }

    fn check(&self) -> Result<(), Problem> {
        if let Some(states) = self.states.filter(|per_s| !(0.0..=1000.0).contains(per_s)) {
            return Err(MALFORMED.problem(format!(
                "states is {states}; allowed is 0 to 1000 in a second"
            )));
        }
        if self.name.as_ref().is_some_and(|name| !is_name(name)) {
            return Err(
                MALFORMED.problem("name: this takes 1 to 60 characters that can be printed")
            );
        }
        Ok(())
    }
}

/// How many bytes are read at once. So many are cleared whenever a client's task is woken, be it to be
/// told something: with the 128 KiB of the library a third of the station's time went there.
const READ_AT_ONCE: usize = 4 * 1024;

/// Answers a request to speak WebSocket.
pub(crate) async fn upgrade(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Extension(peer): Extension<Peer>,
    uri: Uri,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Result<Response, NotDone> {
    let wants = Wants::of(&uri)?;
    let upgrade = upgrade.map_err(|error| UPGRADE.problem(error.body_text()))?;
    let place = app.place()?;
    let name = wants.name.clone().unwrap_or_else(|| caller.name.clone());
    let person = caller.person(&name);
    let client = app.handle.client_of(&name, caller.role, person).await?;
    let largest = if caller.role >= Role::Queue {
        JOB
    } else {
        BODY
    };
    let upgrade = upgrade
        .protocols(["dobot"])
        .read_buffer_size(READ_AT_ONCE)
        .max_message_size(largest)
        .max_frame_size(largest);
    Ok(upgrade.on_upgrade(move |socket| async move {
        let (mut outgoing, mut incoming) = socket.split();
        let connection = SocketConnection::new(&app, caller, client, name, &wants);
        connection.run(&mut incoming, &mut outgoing).await;
        drop((place, peer));
    }))
}
