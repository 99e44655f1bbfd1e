//! Connections in virtual time.

use std::convert::Infallible;
use std::pin::Pin;
use std::sync::Mutex;
use std::task::{Context, Poll};

use dobot_api::{News, Role, StationAddress};
use dobot_host::StationHandle;
use futures_util::stream;
use tokio::sync::watch;
use tokio::time::Instant;

use super::*;
use crate::http::access::tokens::Tokens;
use crate::http::app::{AppFiles, Reach};
use crate::http::fake::{Asked, FakeNews, driver};
use crate::sample::{notice, state};

/// A caller without a token.
fn caller() -> Caller {
    Caller {
        name: "test".into(),
        role: Role::Admin,
        is_person: false,
        token: None,
    }
}

/// The messages that a client receives; it may stop reading after some of them.
#[derive(Debug)]
struct TestSink {
    received: Arc<Mutex<Vec<Message>>>,
    reads: usize,
}

impl Sink<Message> for TestSink {
    type Error = Infallible;

    fn poll_ready(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        if self.received.lock().unwrap().len() < self.reads {
            Poll::Ready(Ok(()))
        } else {
            Poll::Pending
        }
    }

    fn start_send(self: Pin<&mut Self>, message: Message) -> Result<(), Infallible> {
        self.received.lock().unwrap().push(message);
        Ok(())
    }

    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn poll_close(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }
}

struct Harness {
    app: Arc<App>,
    publisher: Arc<FakeNews>,
    asked: Asked,
    received: Arc<Mutex<Vec<Message>>>,
    _end: watch::Sender<bool>,
}

impl Harness {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let tokens = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        let (handle, publisher, asked) = driver();
        let (end, ending) = watch::channel(false);
        Self {
            app: App::new(
                handle,
                tokens,
                Some(Role::Admin),
                Reach {
                    own: StationAddress::new("http://127.0.0.1:8642").unwrap(),
                    names: Vec::new(),
                    listens: ("127.0.0.1:8642".parse().unwrap(), false),
                },
                AppFiles {
                    policy: "policy.toml".into(),
                    recordings: "recordings".into(),
                    buttons: "buttons.json".into(),
                    stored: "files".into(),
                    extras: "extras".into(),
                },
                None,
                ending,
            ),
            publisher,
            asked,
            received: Arc::default(),
            _end: end,
        }
    }

    /// Runs a connection with a client that reads this many messages; returns how long it lasts.
    async fn connection<I>(&self, reads: usize, incoming: I) -> Duration
    where
        I: Stream<Item = Result<Message, String>> + Unpin,
    {
        let began = Instant::now();
        let client = self.app.handle.client("test", Role::Admin).await.unwrap();
        let connection = SocketConnection::new(
            &self.app,
            caller(),
            client,
            "test".into(),
            &SocketOptions::default(),
        );
        let received = self.received.clone();
        let mut incoming = incoming;
        connection
            .run(&mut incoming, &mut TestSink { received, reads })
            .await;
        began.elapsed()
    }

    fn close_code(&self) -> Option<u16> {
        match self.received.lock().unwrap().last() {
            Some(Message::Close(Some(frame))) => Some(frame.code),
            _ => None,
        }
    }

    async fn trouble(&self) -> Vec<String> {
        self.app.handle.jobs().await.unwrap();
        self.publisher.trouble.lock().unwrap().clone()
    }
}

/// A client that sends a pong each second.
fn pongs() -> impl Stream<Item = Result<Message, String>> + Unpin {
    Box::pin(stream::unfold((), |()| async {
        tokio::time::sleep(Duration::from_secs(1)).await;
        Some((Ok(Message::Pong(axum::body::Bytes::new())), ()))
    }))
}

#[expect(clippy::unnecessary_wraps, reason = "the type of a socket's stream")]
fn text(text: &str) -> Result<Message, String> {
    Ok(Message::Text(text.into()))
}

#[tokio::test(start_paused = true)]
async fn a_client_that_vanishes_is_noticed_within_seconds() {
    let harness = Harness::new();
    let lasted = harness.connection(usize::MAX, stream::pending()).await;
    assert!((6.0..8.0).contains(&lasted.as_secs_f64()), "{lasted:?}");
    assert_eq!(harness.close_code(), Some(1008));
    let pings = harness
        .received
        .lock()
        .unwrap()
        .iter()
        .filter(|message| matches!(message, Message::Ping(_)))
        .count();
    assert!(pings >= 3, "{pings}");
}

#[tokio::test(start_paused = true)]
async fn a_connected_client_that_sends_nothing_stays() {
    let harness = Harness::new();
    let talking = harness.connection(usize::MAX, pongs());
    assert!(timeout(Duration::from_hours(1), talking).await.is_err());
}

#[tokio::test(start_paused = true)]
async fn a_client_that_does_not_read_is_dropped_and_watchers_are_notified() {
    let harness = Harness::new();
    let lasted = harness.connection(3, pongs()).await;
    assert!(lasted < Duration::from_secs(15), "{lasted:?}");
    assert_eq!(
        harness.trouble().await,
        ["client 1 (test) was dropped: it reads too slowly"]
    );
}

#[tokio::test(start_paused = true)]
async fn a_client_that_lags_too_many_states_is_dropped() {
    let harness = Harness::new();
    let publisher = harness.publisher.clone();
    let incoming = Box::pin(stream::once(async move {
        for _ in 0..2 * StationHandle::STATES {
            publisher.ends.publish_state(state(0.0));
        }
        text(r#"{"id": 1, "request": {"type": "release"}}"#)
    }));
    let talking = harness.connection(usize::MAX, incoming.chain(pongs()));
    let _ = timeout(Duration::from_mins(1), talking).await;
    assert_eq!(harness.close_code(), Some(1008));
}

#[tokio::test(start_paused = true)]
async fn a_stop_of_a_client_that_does_not_read_is_still_handled() {
    let harness = Harness::new();
    let stop = text(r#"{"id": 1, "request": {"type": "stop"}}"#);
    let after = Box::pin(stream::once(async {
        tokio::time::sleep(Duration::from_secs(4)).await;
        stop
    }));
    harness.connection(0, after.chain(pongs())).await;
    assert_eq!(
        harness.asked.requests(),
        [dobot_api::Request::Stop { reason: None }]
    );
}

#[tokio::test(start_paused = true)]
async fn an_invalid_websocket_message_closes_the_connection_with_the_reason() {
    for (error, code) in [
        (
            "Space limit exceeded: Message too long: 70000 > 65536",
            1009,
        ),
        ("WebSocket protocol error: Reserved bits are non-zero", 1002),
    ] {
        let harness = Harness::new();
        harness
            .connection(usize::MAX, stream::iter([Err(error.to_owned())]))
            .await;
        assert_eq!(harness.close_code(), Some(code), "{error}");
        assert_eq!(harness.trouble().await.len(), 1);
    }
}

#[tokio::test(start_paused = true)]
async fn an_aborted_connection_is_not_reported_as_an_error() {
    for error in [
        "WebSocket protocol error: Connection reset without closing handshake",
        "IO error: Connection reset by peer (os error 104)",
    ] {
        let harness = Harness::new();
        harness
            .connection(usize::MAX, stream::iter([Err(error.to_owned())]))
            .await;
        assert_eq!(harness.trouble().await, [""; 0]);
    }
}

#[tokio::test(start_paused = true)]
async fn hello_is_sent_first_and_earlier_events_after_it() {
    let harness = Harness::new();
    let publisher = harness.publisher.clone();
    let incoming = Box::pin(stream::once(async move {
        publisher.ends.publish_notice(notice(1, News::LinkUp, "up"));
        text("")
    }));
    let _ = timeout(
        Duration::from_secs(5),
        harness.connection(usize::MAX, incoming.chain(pongs())),
    )
    .await;
    let received = harness.received.lock().unwrap();
    let starts = |at: usize, start: &str| matches!(&received[at], Message::Text(text) if text.starts_with(start));
    assert!(
        starts(0, "{\"hello\":") && starts(1, "{\"state\":"),
        "{received:?}"
    );
    assert!(
        received.iter().any(
            |message| matches!(message, Message::Text(text) if text.starts_with("{\"notice\":"))
        )
    );
}
