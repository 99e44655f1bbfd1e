//! Messages to a client.

use std::borrow::Cow;
use std::sync::Arc;
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::ws::Message;
use dobot_api::{Hello, Notice, Reply, ToClient};
use dobot_host::Client;
use dobot_supervisor::Refusal;
use futures_util::stream::FuturesUnordered;
use futures_util::{Sink, SinkExt, StreamExt};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{broadcast, mpsc, oneshot};
use tokio::time::{Interval, MissedTickBehavior, interval, timeout};

use super::connection::{CloseReason, Outgoing};
use super::state_stream::{StateStream, message};
use crate::http::app::App;
use crate::http::exchange::messages;

/// The interval of pings.
const PING_EVERY: Duration = Duration::from_secs(2);
/// The time that a client may leave a message unread while its buffers are full.
const READ_WITHIN: Duration = Duration::from_secs(5);

/// The subscriptions of a client.
#[derive(Debug)]
pub(crate) struct Subscriptions {
    pub(crate) states: StateStream,
    pub(crate) notices: Option<broadcast::Receiver<Arc<Notice>>>,
    pub(crate) owed: mpsc::Receiver<Outgoing>,
}

impl Subscriptions {
    /// Sends messages until the connection ends.
    pub(crate) async fn run<O>(
        mut self,
        app: &App,
        client: &Client,
        outgoing: &mut O,
    ) -> CloseReason
    where
        O: Sink<Message> + Unpin,
    {
        let mut sent = send(outgoing, hello(app, client)).await;
        if self.states.is_wanted() && sent.is_ok() {
            sent = send(outgoing, Message::Text(message(&app.handle.state()))).await;
        }
        let mut answers = FuturesUnordered::new();
        let mut pings = pings();
        while sent.is_ok() {
            sent = tokio::select! {
                Some(owed) = self.owed.recv() => match owed {
                    Outgoing::Text(text) => send(outgoing, Message::Text(text.into())).await,
                    Outgoing::Answer(id, answer) => {
                        answers.push(numbered(id, answer));
                        Ok(())
                    }
                },
                Some(answer) = answers.next() => send(outgoing, answer).await,
                state = self.states.next() => match state {
                    Ok(state) => send(outgoing, Message::Text(state)).await,
                    Err(error) => Err(missed(&error)),
                },
                notice = next(&mut self.notices) => match notice {
                    Ok(notice) => send(outgoing, text_message(&ToClient::Notice { notice: Cow::Borrowed(&notice) })).await,
                    Err(error) => Err(missed(&error)),
                },
                _ = pings.tick() => send(outgoing, Message::Ping(Bytes::new())).await,
            };
        }
        sent.err().unwrap_or(CloseReason::Closed)
    }
}

async fn send<O>(outgoing: &mut O, message: Message) -> Result<(), CloseReason>
where
    O: Sink<Message> + Unpin,
{
    match timeout(READ_WITHIN, outgoing.send(message)).await {
        Err(_) => Err(CloseReason::Slow),
        Ok(sent) => sent.map_err(|_| CloseReason::Closed),
    }
}

fn pings() -> Interval {
    let mut pings = interval(PING_EVERY);
    pings.set_missed_tick_behavior(MissedTickBehavior::Delay);
    pings
}

/// Returns the response to a request when it is available.
async fn numbered(id: u64, answer: oneshot::Receiver<Result<Reply, Refusal>>) -> Message {
    reply(id, answer.await.unwrap_or(Err(Refusal::Ending)))
}

/// Returns the reason why a message was missed.
fn missed(error: &RecvError) -> CloseReason {
    match error {
        RecvError::Lagged(_) => CloseReason::Slow,
        RecvError::Closed => CloseReason::Ending,
    }
}

/// Returns the next notice; never, if none are requested.
async fn next(
    notices: &mut Option<broadcast::Receiver<Arc<Notice>>>,
) -> Result<Arc<Notice>, RecvError> {
    match notices {
        Some(notices) => notices.recv().await,
        None => std::future::pending().await,
    }
}

fn hello(app: &App, client: &Client) -> Message {
    let hello = Hello {
        client: client.id(),
        role: client.role(),
        person: client.person().to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        page: dobot_page::VERSION.to_owned(),
        dead_man_s: app.handle.rules().dead_man_s,
    };
    text_message(&ToClient::Hello { hello })
}

fn reply(id: u64, answer: Result<Reply, Refusal>) -> Message {
    text_message(&match answer {
        Ok(reply) => ToClient::Reply { id, reply },
        Err(refusal) => {
            let id = Some(id);
            let problem = refusal.into();
            ToClient::Problem { id, problem }
        }
    })
}

fn text_message(message: &ToClient<'_>) -> Message {
    Message::Text(messages::text(message).into())
}
