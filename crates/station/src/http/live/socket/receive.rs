//! Messages from a client.

use std::fmt::Display;
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::ws::Message;
use dobot_api::{FromClient, Problem, Role};
use dobot_host::Client;
use dobot_supervisor::Refusal;
use futures_util::{Stream, StreamExt};
use tokio::sync::mpsc;
use tokio::time::timeout;

use super::connection::{CloseReason, Outgoing};
use crate::http::access::rate::{Rate, Used};
use crate::http::app::App;
use crate::http::exchange::messages;
use crate::http::exchange::responses;

/// The time of silence after which a client is considered gone.
const SILENCE: Duration = Duration::from_secs(6);
/// The rate limit of a client's messages.
const MESSAGES: Rate = Rate {
    per_s: 1000.0,
    burst: 2000.0,
};

/// Receives messages until the connection ends.
pub(crate) async fn receive<I, E>(
    app: &App,
    client: &Client,
    incoming: &mut I,
    owe: &mpsc::Sender<Outgoing>,
) -> CloseReason
where
    I: Stream<Item = Result<Message, E>> + Unpin,
    E: Display,
{
    let mut used = Used::default();
    loop {
        let message = match timeout(SILENCE, incoming.next()).await {
            Err(_) => return CloseReason::Vanished,
            Ok(None | Some(Ok(Message::Close(_)))) => return CloseReason::Closed,
            Ok(Some(Err(error))) => return broken(&error),
            Ok(Some(Ok(message))) => message,
        };
        if used.take(MESSAGES, app.now(), 1.0).is_err() {
            return CloseReason::Flood;
        }
        let Some(owed) = answer(app, client, message).await else {
            continue;
        };
        if owe.send(owed).await.is_err() {
            return CloseReason::Closed;
        }
    }
}

/// A broken connection counts as closed; one with invalid messages gets a reason.
fn broken(error: &impl Display) -> CloseReason {
    let text = error.to_string();
    if text.contains("closing handshake") || text.starts_with("IO error") || text.contains("closed")
    {
        CloseReason::Closed
    } else {
        CloseReason::Broken(text)
    }
}

/// Returns the response to a message.
async fn answer(app: &App, client: &Client, message: Message) -> Option<Outgoing> {
    let text = match message {
        Message::Text(text) => text,
        Message::Binary(pcm) => {
            let problem = talk(app, client, pcm).err()?;
            return Some(Outgoing::problem(None, problem));
        }
        _ => return None,
    };
    Some(
        match responses::read_beside(Bytes::from(text), messages::read).await {
            Err(problem) => Outgoing::problem(None, problem),
            Ok(Err((id, problem))) => Outgoing::problem(id, problem),
            Ok(Ok(FromClient { id, request })) => match client.ask(request).await {
                Ok(answer) => Outgoing::Answer(id, answer),
                Err(refusal) => Outgoing::problem(Some(id), refusal.into()),
            },
        },
    )
}

/// Passes audio to the listener. This needs the role `control`, because spoken orders move the arm.
fn talk(app: &App, client: &Client, pcm: Bytes) -> Result<(), Problem> {
    let (needed, found) = (Role::Control, client.role());
    if found < needed {
        return Err(Refusal::Role { needed, found }.into());
    }
    app.talk.add(app.now(), client.id(), pcm)
}
