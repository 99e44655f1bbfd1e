//! One client's connection: what it says is heard even while it does not listen.

use std::fmt::Display;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::ws::{CloseFrame, Message, close_code};
use futures_util::stream::FuturesUnordered;
use futures_util::{Sink, SinkExt, Stream, StreamExt};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{broadcast, mpsc};
use tokio::time::{MissedTickBehavior, interval, timeout};

use super::super::answer;
use super::super::app::{App, ended};
use super::super::kinds::INVALID;
use super::super::messages::{FromClient, Hello, ToClient};
use super::super::rate::{Rate, Used};
use super::Wants;
use super::pace::Pace;
use crate::Client;
use crate::handle::Answer;
use crate::words::{Notice, Problem, Refusal, Reply};

/// One client's connection.
#[derive(Debug)]
pub(super) struct Talk {
    app: Arc<App>,
    client: Client,
    name: String,
    pace: Pace,
    notices: Option<broadcast::Receiver<Arc<Notice>>>,
}

/// Why a connection ends.
#[derive(Clone, Debug, PartialEq, Eq)]
enum End {
    /// The client closed it, or it broke.
    Closed,
    /// The client has said nothing, not even that it is there.
    Vanished,
    /// The client does not read what it wants to be sent.
    Slow,
    /// The client sends too much.
    Flood,
    /// What the client sends is no WebSocket message.
    Broken(String),
    /// The station ends.
    Ending,
}

/// What is to be sent to the client, apart from states and notices.
#[derive(Debug)]
enum Owed {
    Answer(u64, Answer),
    Text(String),
}

/// How often the client is asked whether it is there.
const PING_EVERY: Duration = Duration::from_secs(2);
/// After what silence it is not.
const SILENCE: Duration = Duration::from_secs(6);
/// How long the client may leave a message unread while its buffers are full.
const READ_WITHIN: Duration = Duration::from_secs(5);
/// How long a farewell may take.
const FAREWELL: Duration = Duration::from_secs(1);
/// How many messages a client may send.
const MESSAGES: Rate = Rate {
    per_s: 1000.0,
    burst: 2000.0,
};
/// How many answers may wait to be sent before the client is not heard any more.
const OWED: usize = 256;

impl Talk {
    pub(super) fn new(app: &Arc<App>, client: Client, name: String, wants: &Wants) -> Self {
        let notices = wants.notices.unwrap_or(true).then(|| app.handle.notices());
        Self {
            pace: Pace::new(app.handle.every_state(), wants.states),
            app: app.clone(),
            client,
            name,
            notices,
        }
    }

    /// Talks until one side ends it.
    pub(super) async fn run<I, O, E>(&mut self, incoming: &mut I, outgoing: &mut O)
    where
        I: Stream<Item = Result<Message, E>> + Unpin,
        O: Sink<Message> + Unpin,
        E: Display,
    {
        let (owe, owed) = mpsc::channel(OWED);
        let end = tokio::select! {
            end = hear(&self.app, &self.client, incoming, &owe) => end,
            end = tell(&self.app, &self.client, &mut self.pace, &mut self.notices, owed, outgoing) => end,
            () = ended(self.app.ending.clone()) => End::Ending,
        };
        self.report(&end).await;
        // Whether the client hears the last word makes no difference any more.
        let _ = timeout(FAREWELL, farewell(&end, incoming, outgoing)).await;
    }

    /// Lets those who watch know of a client that is not as it should be.
    async fn report(&self, end: &End) {
        if matches!(end, End::Slow | End::Flood | End::Broken(_)) {
            let (number, name) = (self.client.id().0, &self.name);
            let why = words(end);
            self.app
                .handle
                .trouble(format!("client {number} ({name}) was dropped: {why}"))
                .await;
        }
    }
}

/// Hears the client until it ends.
async fn hear<I, E>(app: &App, client: &Client, incoming: &mut I, owe: &mpsc::Sender<Owed>) -> End
where
    I: Stream<Item = Result<Message, E>> + Unpin,
    E: Display,
{
    let mut used = Used::default();
    loop {
        let message = match timeout(SILENCE, incoming.next()).await {
            Err(_) => return End::Vanished,
            Ok(None | Some(Ok(Message::Close(_)))) => return End::Closed,
            Ok(Some(Err(error))) => return broken(&error),
            Ok(Some(Ok(message))) => message,
        };
        if used.take(MESSAGES, app.now(), 1.0).is_err() {
            return End::Flood;
        }
        let Some(owed) = answer(client, message).await else {
            continue;
        };
        if owe.send(owed).await.is_err() {
            return End::Closed;
        }
    }
}

/// A connection that breaks off is as good as closed; one that carries no messages is told so.
fn broken(error: &impl Display) -> End {
    let text = error.to_string();
    if text.contains("closing handshake") || text.starts_with("IO error") || text.contains("closed")
    {
        End::Closed
    } else {
        End::Broken(text)
    }
}

/// What is owed to the client for a message.
async fn answer(client: &Client, message: Message) -> Option<Owed> {
    let text = match message {
        Message::Text(text) => text,
        Message::Binary(_) => {
            return Some(Owed::problem(
                None,
                INVALID.problem("messages are text, not binary"),
            ));
        }
        _ => return None,
    };
    Some(match read(text.into()).await {
        Err((id, problem)) => Owed::problem(id, problem),
        Ok(FromClient { id, request }) => match client.ask(request).await {
            Ok(answer) => Owed::Answer(id, answer),
            Err(refusal) => Owed::problem(Some(id), refusal.into()),
        },
    })
}

async fn read(text: axum::body::Bytes) -> Result<FromClient, (Option<u64>, Problem)> {
    answer::beside(text, FromClient::read).await
}

impl Owed {
    fn problem(id: Option<u64>, problem: Problem) -> Self {
        Self::Text(ToClient::Problem { id, problem }.text())
    }
}

/// Tells the client what it is owed until it ends.
async fn tell<O>(
    app: &App,
    client: &Client,
    pace: &mut Pace,
    notices: &mut Option<broadcast::Receiver<Arc<Notice>>>,
    mut owed: mpsc::Receiver<Owed>,
    outgoing: &mut O,
) -> End
where
    O: Sink<Message> + Unpin,
{
    let mut answers = FuturesUnordered::new();
    let mut pings = interval(PING_EVERY);
    pings.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut first = vec![hello(app, client)];
    if pace.is_wanted() {
        first.insert(0, Message::Text(app.handle.state().message()));
    }
    loop {
        let message = match first.pop() {
            Some(message) => message,
            None => tokio::select! {
                Some(owed) = owed.recv() => match owed {
                    Owed::Text(text) => text_message(text),
                    Owed::Answer(id, answer) => {
                        answers.push(async move { (id, answer.await) });
                        continue;
                    }
                },
                Some((id, answer)) = answers.next() => reply(id, answer.unwrap_or(Err(Refusal::Ending))),
                state = pace.next() => match state {
                    Ok(text) => Message::Text(text),
                    Err(RecvError::Lagged(_)) => return End::Slow,
                    Err(RecvError::Closed) => return End::Ending,
                },
                notice = next(notices) => match notice {
                    Ok(notice) => text_message(ToClient::Notice { notice: &notice }.text()),
                    Err(RecvError::Lagged(_)) => return End::Slow,
                    Err(RecvError::Closed) => return End::Ending,
                },
                _ = pings.tick() => Message::Ping(axum::body::Bytes::new()),
            },
        };
        match timeout(READ_WITHIN, outgoing.send(message)).await {
            Err(_) => return End::Slow,
            Ok(Err(_)) => return End::Closed,
            Ok(Ok(())) => {}
        }
    }
}

/// The next notice, if any are wanted.
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
        version: env!("CARGO_PKG_VERSION"),
        dead_man_s: app.handle.rules.dead_man_s,
    };
    text_message(ToClient::Hello { hello }.text())
}

fn reply(id: u64, answer: Result<Reply, Refusal>) -> Message {
    text_message(match answer {
        Ok(reply) => ToClient::Reply { id, reply }.text(),
        Err(refusal) => {
            let id = Some(id);
            let problem = refusal.into();
            ToClient::Problem { id, problem }.text()
        }
    })
}

fn text_message(text: String) -> Message {
    Message::Text(text.into())
}

/// Says why, and lets what is on its way arrive.
async fn farewell<I, O>(end: &End, incoming: &mut I, outgoing: &mut O)
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
    // What cannot be flushed will not be read either.
    let _ = outgoing.flush().await;
}

fn code(end: &End) -> Option<u16> {
    match end {
        End::Closed => None,
        End::Vanished | End::Slow | End::Flood => Some(close_code::POLICY),
        End::Broken(text) if text.contains("too long") => Some(close_code::SIZE),
        End::Broken(_) => Some(close_code::PROTOCOL),
        End::Ending => Some(close_code::AWAY),
    }
}

/// Up to 123 bytes: a close frame has no more.
fn words(end: &End) -> String {
    match end {
        End::Closed => "closed".into(),
        End::Vanished => "it did not answer for 6 s".into(),
        End::Slow => "it reads too slowly".into(),
        End::Flood => "it sends more than 1000 messages in a second".into(),
        End::Broken(text) => text.chars().filter(char::is_ascii).take(100).collect(),
        End::Ending => "the station is shutting down".into(),
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
