//! Server-sent events: states and notices, for programs that only watch.

use std::borrow::Cow;
use std::convert::Infallible;
use std::sync::Arc;
use std::time::Duration;

use axum::Extension;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, Uri};
use axum::response::sse::{Event, KeepAlive, Sse};
use dobot_api::problem_kinds::MALFORMED;
use dobot_api::{Notice, Problem, ToClient};
use futures_util::Stream;
use schemars::JsonSchema;
use tokio::sync::{OwnedSemaphorePermit, broadcast};

use crate::http::app::{App, Caller, Stay};
use crate::http::exchange::messages;
use crate::http::exchange::responses::RequestFailed;
use crate::http::live::socket::{SocketOptions, StateStream, state_message};

/// The interval of keep-alive comments, which reveal dead connections.
pub(crate) const ALIVE_EVERY: Duration = Duration::from_secs(5);
const LAST_EVENT_ID: HeaderName = HeaderName::from_static("last-event-id");

/// One event, for the document only.
#[derive(JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
pub(crate) struct ServerSentEvent {
    /// The type: `state` or `notice`; `packet` or `lost`; `member` or `gone`.
    event: String,
    /// The number of a notice; absent for other events.
    id: Option<String>,
    /// As JSON text: a message as in `ToClient`, a packet as in `PacketView`, or a member of the
    /// fleet as in `Member`.
    data: String,
}

/// An event stream, until its client leaves or the station ends.
struct Watching {
    states: StateStream,
    notices: Option<broadcast::Receiver<Arc<Notice>>>,
    /// Events to send before the live ones, in reverse order.
    first: Vec<Event>,
    stay: Stay,
    _place: OwnedSemaphorePermit,
}

/// Streams states and notices.
pub(crate) async fn events(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    uri: Uri,
    headers: HeaderMap,
) -> Result<Sse<impl Stream<Item = Result<Event, Infallible>>>, RequestFailed> {
    let wants = SocketOptions::of_one_who_watches(&uri)?;
    let seen = last_seen(&headers)?;
    let place = app.place()?;
    let notices = wants.notices().then(|| app.handle.notices());
    let states = StateStream::new(app.handle.every_state(), wants.states());
    let first = first_events(&app, seen.filter(|_| wants.notices()), states.is_wanted());
    let watching = Watching {
        states,
        notices,
        first,
        stay: Stay { app, caller },
        _place: place,
    };
    let stream = futures_util::stream::unfold(watching, |mut notice| async move {
        let event = notice.next().await?;
        Some((Ok(event), notice))
    });
    Ok(Sse::new(stream).keep_alive(KeepAlive::new().interval(ALIVE_EVERY)))
}

/// Returns the current state, if wanted, and the notices after the one with the number `seen`, in reverse
/// order.
fn first_events(app: &App, seen: Option<u64>, with_state: bool) -> Vec<Event> {
    let mut first = Vec::new();
    if with_state {
        first.push(state_event(&state_message(&app.handle.state())));
    }
    if let Some(seen) = seen {
        let recent = app.handle.recent();
        let missed = recent.iter().filter(|recent| recent.number > seen);
        first.extend(missed.map(|notice| notice_event(notice)));
    }
    first.reverse();
    first
}

impl Watching {
    /// Returns the next event. The stream also ends for a slow client, which can reconnect with the
    /// last number that it received without missing a notice.
    async fn next(&mut self) -> Option<Event> {
        if let Some(event) = self.first.pop() {
            return Some(event);
        }
        tokio::select! {
            state = self.states.next() => state.ok().map(|state| state_event(&state)),
            notice = next(&mut self.notices) => notice.ok().map(|notice| notice_event(&notice)),
            () = self.stay.is_over() => None,
        }
    }
}

/// Returns the next notice; never, if none are requested.
async fn next(
    notices: &mut Option<broadcast::Receiver<Arc<Notice>>>,
) -> Result<Arc<Notice>, broadcast::error::RecvError> {
    match notices {
        Some(notices) => notices.recv().await,
        None => std::future::pending().await,
    }
}

/// Returns the number of the last notice that a reconnecting client has received.
fn last_seen(headers: &HeaderMap) -> Result<Option<u64>, Problem> {
    let Some(value) = headers.get(LAST_EVENT_ID) else {
        return Ok(None);
    };
    let number = value.to_str().ok().and_then(|str| str.parse().ok());
    let Some(number) = number else {
        return Err(MALFORMED.problem(format!(
            "Last-Event-ID is {value:?}; expected is the number of a notice"
        )));
    };
    Ok(Some(number))
}

fn state_event(message: &str) -> Event {
    Event::default().event("state").data(message)
}

fn notice_event(notice: &Notice) -> Event {
    let event = Event::default().event("notice");
    event
        .id(notice.number.to_string())
        .data(messages::text(&ToClient::Notice {
            notice: Cow::Borrowed(notice),
        }))
}
