//! WebSockets, from the upgrade request to the close frame.

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
use dobot_api::{Device, Problem, Role};
use futures_util::StreamExt;
use schemars::SchemaGenerator;
use serde::Deserialize;

pub(crate) use self::state_stream::{StateStream, message as state_message};

use self::connection::SocketConnection;
use crate::http::app::{App, Caller, Peer};
use crate::http::exchange::requester::is_name;
use crate::http::exchange::responses::{BODY, JOB, RequestFailed};
use crate::http::route::Query;

/// The options of a connecting client.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SocketOptions {
    states: Option<f64>,
    notices: Option<bool>,
    name: Option<String>,
    device: Option<Device>,
}

/// The options as query parameters, for the document.
pub(crate) const QUERIES: &[Query] = &[
    Query {
        name: "states",
        what: "Maximum number of states per second, 0 to 1000 (default: every state, 12.5 per second and those with events)",
        schema: SchemaGenerator::subschema_for::<f64>,
    },
    Query {
        name: "notices",
        what: "Whether to send notices (default: true)",
        schema: SchemaGenerator::subschema_for::<bool>,
    },
    Query {
        name: "name",
        what: "Name of the client, 1 to 60 characters",
        schema: SchemaGenerator::subschema_for::<String>,
    },
    Query {
        name: "device",
        what: "Device of a page, shown with its name",
        schema: SchemaGenerator::subschema_for::<Device>,
    },
];

/// The parameters for clients that only watch.
pub(crate) const WATCH_QUERIES: &[Query] = QUERIES.split_at(2).0;

impl SocketOptions {
    /// Parses the options of a client that only watches, which needs no name.
    pub(crate) fn of_one_who_watches(uri: &Uri) -> Result<Self, Problem> {
        let wants = Self::of(uri)?;
        let unknown = wants.name.as_ref().map(|_| "name");
        if let Some(unknown) = unknown.or(wants.device.map(|_| "device")) {
            return Err(MALFORMED.problem(format!(
                "query: unknown parameter {unknown}; allowed are states and notices"
            )));
        }
        Ok(wants)
    }

    /// Returns the maximum number of states per second; `None` for every state.
    pub(crate) const fn states(&self) -> Option<f64> {
        self.states
    }

    /// Whether to send notices.
    pub(crate) fn notices(&self) -> bool {
        self.notices.unwrap_or(true)
    }

    fn of(uri: &Uri) -> Result<Self, Problem> {
        let UrlQuery(wants) = UrlQuery::<Self>::try_from_uri(uri)
            .map_err(|error| MALFORMED.problem(format!("query: {}", error.body_text())))?;
        wants.check()?;
        Ok(wants)
    }

    fn check(&self) -> Result<(), Problem> {
        if let Some(states) = self.states.filter(|per_s| !(0.0..=1000.0).contains(per_s)) {
            return Err(MALFORMED.problem(format!(
                "states is {states}; allowed are 0 to 1000 per second"
            )));
        }
        if self.name.as_ref().is_some_and(|name| !is_name(name)) {
            return Err(MALFORMED
                .problem("name: allowed are 1 to 60 printable characters, not only spaces"));
        }
        Ok(())
    }
}

/// The size of the read buffer. It is cleared whenever a client's task is woken, even to send: with
/// the library's default of 128 KiB a third of the station's time was spent on that.
const READ_AT_ONCE: usize = 4 * 1024;

/// Answers a request to upgrade to WebSocket.
pub(crate) async fn upgrade(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Extension(peer): Extension<Peer>,
    uri: Uri,
    upgrade: Result<WebSocketUpgrade, WebSocketUpgradeRejection>,
) -> Result<Response, RequestFailed> {
    let wants = SocketOptions::of(&uri)?;
    let upgrade = upgrade.map_err(|error| UPGRADE.problem(error.body_text()))?;
    let place = app.place()?;
    let name = caller.name_of(wants.name.as_deref(), wants.device);
    let person = caller.person(&name);
    let client = app.handle.page_of(&name, caller.role, person, wants.device);
    let client = client.await?;
    let largest = largest_message(caller.role);
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

/// Returns the length of the largest message of a client, in bytes.
fn largest_message(role: Role) -> usize {
    if role >= Role::Queue { JOB } else { BODY }
}
