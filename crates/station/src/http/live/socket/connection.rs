//! The connection of one client; requests are received even while the client does not read.

use std::fmt::Display;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::{CloseFrame, Message, close_code};
use dobot_api::{ClientId, Notice, Problem, Reply, ToClient};
use dobot_host::Client;
use dobot_supervisor::Refusal;
use futures_util::{Sink, SinkExt, Stream, StreamExt};
use tokio::sync::{broadcast, mpsc, oneshot};
use tokio::time::timeout;

use super::SocketOptions;
use super::receive::receive;
use super::send::Subscriptions;
use super::state_stream::StateStream;
use crate::http::app::{App, Caller, ended};
use crate::http::exchange::messages;

/// The connection of one client.
#[derive(Debug)]
pub(crate) struct SocketConnection {
    app: Arc<App>,
    caller: Caller,
    client: Client,
    name: String,
    states: StateStream,
    notices: Option<broadcast::Receiver<Arc<Notice>>>,
}

/// The reason why a connection ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum CloseReason {
    /// The client closed it, or it broke.
    Closed,
    /// The client has sent nothing, not even a pong.
    Vanished,
    /// The client does not read the data that it requested.
    Slow,
    /// The client sends too many messages.
    Flood,
    /// The client's token was removed, or its role was reduced.
    Revoked,
    /// The client sent an invalid WebSocket message.
    Broken(String),
    /// The station ends.
    Ending,
}

/// A message to the client, other than states and notices.
#[derive(Debug)]
pub(crate) enum Outgoing {
    Answer(u64, oneshot::Receiver<Result<Reply, Refusal>>),
    Text(String),
}

/// The timeout of the closing handshake.
const FAREWELL: Duration = Duration::from_secs(1);
/// The maximum number of unsent responses; beyond it no requests are read.
const OWED: usize = 256;

impl SocketConnection {
    pub(crate) fn new(
        app: &Arc<App>,
        caller: Caller,
        client: Client,
        name: String,
        wants: &SocketOptions,
    ) -> Self {
        let notices = wants.notices.unwrap_or(true).then(|| app.handle.notices());
        Self {
            states: StateStream::new(app.handle.every_state(), wants.states),
            app: app.clone(),
            caller,
            client,
            name,
            notices,
        }
    }

    /// Runs until one side ends the connection.
    pub(crate) async fn run<I, O, E>(self, incoming: &mut I, outgoing: &mut O)
    where
        I: Stream<Item = Result<Message, E>> + Unpin,
        O: Sink<Message> + Unpin,
        E: Display,
    {
        let (owe, owed) = mpsc::channel(OWED);
        let (app, client) = (&*self.app, self.client);
        let subscriptions = Subscriptions {
            states: self.states,
            notices: self.notices,
            owed,
        };
        let end = tokio::select! {
            end = receive(app, &client, incoming, &owe) => end,
            end = subscriptions.run(app, &client, outgoing) => end,
            () = app.revoked(&self.caller) => CloseReason::Revoked,
            () = ended(app.ending.clone()) => CloseReason::Ending,
        };
        let id = client.id();
        // Ends its lease now, not after the closing handshake.
        drop(client);
        report(app, id, &self.name, &end).await;
        // It makes no difference whether the client receives the close frame.
        let _ = timeout(FAREWELL, farewell(&end, incoming, outgoing)).await;
    }
}

/// Reports a faulty client to the observers.
async fn report(app: &App, client: ClientId, name: &str, end: &CloseReason) {
    if matches!(
        end,
        CloseReason::Slow | CloseReason::Flood | CloseReason::Revoked | CloseReason::Broken(_)
    ) {
        let (number, why) = (client.0, words(end));
        app.handle
            .report_trouble(format!("client {number} ({name}) was dropped: {why}"))
            .await;
    }
}

impl Outgoing {
    pub(crate) fn problem(id: Option<u64>, problem: Problem) -> Self {
        Self::Text(messages::text(&ToClient::Problem { id, problem }))
    }
}

/// Sends the close frame with the reason, and lets pending data arrive.
async fn farewell<I, O>(end: &CloseReason, incoming: &mut I, outgoing: &mut O)
where
    I: Stream + Unpin,
    O: Sink<Message> + Unpin,
{
    if let Some(code) = code(end) {
        let reason = words(end).into();
        let close = Message::Close(Some(CloseFrame { code, reason }));
        if outgoing.send(close).await.is_err() {
            return;
        }
        while incoming.next().await.is_some() {}
    }
    // Data that cannot be flushed will not be read either.
    let _ = outgoing.flush().await;
}

fn code(end: &CloseReason) -> Option<u16> {
    match end {
        CloseReason::Closed => None,
        CloseReason::Vanished | CloseReason::Slow | CloseReason::Flood | CloseReason::Revoked => {
            Some(close_code::POLICY)
        }
        CloseReason::Broken(text) if text.contains("too long") => Some(close_code::SIZE),
        CloseReason::Broken(_) => Some(close_code::PROTOCOL),
        CloseReason::Ending => Some(close_code::AWAY),
    }
}

/// Returns the reason in at most 123 bytes, the limit of a close frame.
fn words(end: &CloseReason) -> String {
    match end {
        CloseReason::Closed => "closed".into(),
        CloseReason::Vanished => "it did not respond for 6 s".into(),
        CloseReason::Slow => "it reads too slowly".into(),
        CloseReason::Flood => "it sends more than 1000 messages per second".into(),
        CloseReason::Revoked => "its token was removed, or its role was reduced".into(),
        CloseReason::Broken(text) => text.chars().filter(char::is_ascii).take(100).collect(),
        CloseReason::Ending => "the station is shutting down".into(),
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
