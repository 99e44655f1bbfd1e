//! A station client, used by the CLI.

mod address;
mod fetch;
mod find;
mod inbox;
#[cfg(feature = "options")]
mod options;
mod stream;
#[cfg(feature = "tls")]
mod tls;

use std::fmt;
use std::time::Duration;

use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::handshake::client::Request as Handshake;
use tokio_tungstenite::tungstenite::http::HeaderValue;
use tokio_tungstenite::tungstenite::{self, Message};
use tokio_tungstenite::{WebSocketStream, client_async};

use self::inbox::Inbox;
use self::stream::{Bytes, open, soon};
use crate::{FromClient, Hello, Notice, Problem, Reply, Request, State, ToClient};

pub use self::address::{CertificateTrust, StationAddress, StationAddressError, fingerprint};
pub use self::fetch::{delete, fetch, fetch_bytes, is_station, post};
pub use self::find::{SearchError, StationSearch, running};
#[cfg(feature = "options")]
pub use self::options::StationOptions;
pub use self::stream::{ConnectError, TrustError};

/// A station client over WebSocket.
///
/// A task reads from the station all the time, so a client that is planning or waiting for a person
/// stays connected. What the client holds (control of the arm, a jog button) is released when it is
/// dropped.
///
/// ```no_run
/// use dobot_api::{Remote, Request, StationAddress};
///
/// # async fn example() -> Result<(), Box<dyn std::error::Error>> {
/// let address = StationAddress::new("http://127.0.0.1:8642")?;
/// let mut station = Remote::connect(&address, "example").await?;
/// station.request(Request::Stop { reason: None }).await?;
/// # Ok(())
/// # }
/// ```
pub struct Remote {
    outgoing: SplitSink<Socket, Message>,
    inbox: Inbox,
    hello: Hello,
    next_id: u64,
}

/// The maximum number of states per second that the station sends. An arm in real time has 12.5 to 50; at a thousand times
/// that speed there are 12,500, more than a busy machine can read.
const STATES_PER_S: u32 = 200;

type Socket = WebSocketStream<Box<dyn Bytes>>;
type Incoming = SplitStream<Socket>;

/// An event sent by the station.
#[derive(Clone, Debug, PartialEq)]
pub enum StationEvent {
    /// The state.
    State(Box<State>),
    /// A notice.
    Notice(Notice),
}

/// The error returned when communication with a station fails.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RemoteError {
    /// The station refused the request; nothing has changed.
    #[error("{}", .0.detail)]
    Refused(Box<Problem>),
    /// A command failed.
    #[error("{0}")]
    Failed(String),
    /// No answer came.
    #[error("the station does not respond")]
    Silent,
    /// The station closed the connection.
    #[error("the station closed the connection{}", .0.as_ref().map(|reason| format!(": {reason}")).unwrap_or_default())]
    Closed(Option<String>),
    /// The connection broke.
    #[error("the connection to the station broke")]
    Broken(#[source] Box<tungstenite::Error>),
    /// The station sent something that could not be understood.
    #[error("the station sent an unknown message: {0}")]
    Garbled(String),
}

impl RemoteError {
    /// Returns a hint on how to fix it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Refused(problem) => problem.hint.clone(),
            Self::Failed(_) => Some("see where the arm is and what happened: `dobot watch`".into()),
            Self::Silent | Self::Closed(_) | Self::Broken(_) => {
                Some("check the station with `dobot watch`, or start one with `dobot up`".into())
            }
            Self::Garbled(_) => Some("use the same version of station and program".into()),
        }
    }

    /// Returns the name of the problem type of a refusal, as in `no-lease`.
    #[must_use]
    pub fn kind(&self) -> Option<&str> {
        match self {
            Self::Refused(problem) => Some(problem.name()),
            _ => None,
        }
    }
}

impl Remote {
    /// Connects with a name that other clients see.
    ///
    /// # Errors
    ///
    /// [`ConnectError`], with a hint.
    pub async fn connect(address: &StationAddress, name: &str) -> Result<Self, ConnectError> {
        soon(address, Self::shake_hands(address, name)).await
    }

    async fn shake_hands(address: &StationAddress, name: &str) -> Result<Self, ConnectError> {
        let handshake = handshake(address, name)?;
        let stream = open(address).await?;
        let (socket, _) = client_async(handshake, stream)
            .await
            .map_err(|error| no_handshake(address, error))?;
        let (outgoing, mut incoming) = socket.split();
        match receive(&mut incoming).await {
            Ok(ToClient::Hello { hello }) => Ok(Self {
                outgoing,
                inbox: Inbox::listening_to(incoming),
                hello,
                next_id: 1,
            }),
            Ok(ToClient::Problem { problem, .. }) => Err(ConnectError::Refused(problem.into())),
            Ok(_) => Err(ConnectError::no_station(address, "it does not say hello")),
            Err(error) => Err(ConnectError::no_station(address, error)),
        }
    }

    /// Returns the station's greeting.
    #[must_use]
    pub const fn hello(&self) -> &Hello {
        &self.hello
    }

    /// Sends a request. Events that arrive in the meantime are kept for [`next`](Self::next): every
    /// notice, and the latest state.
    ///
    /// # Errors
    ///
    /// [`RemoteError::Refused`] if the station refuses, other variants if no answer comes.
    pub async fn request(&mut self, request: Request) -> Result<Reply, RemoteError> {
        let answered = timeout(patience(&request), self.ask(request)).await;
        answered.unwrap_or(Err(RemoteError::Silent))
    }

    /// The next event from the station. It sends at most 200 states per second; a caller that is more than a second behind
    /// gets only the latest state. Cancelling this loses nothing.
    ///
    /// # Errors
    ///
    /// [`RemoteError`] if the connection is lost.
    pub async fn next(&mut self) -> Result<StationEvent, RemoteError> {
        self.inbox.next().await
    }

    async fn ask(&mut self, request: Request) -> Result<Reply, RemoteError> {
        let id = self.next_id;
        self.next_id += 1;
        let text = serde_json::to_string(&FromClient { id, request })
            .map_err(|error| RemoteError::Garbled(error.to_string()))?;
        self.inbox.expect(id);
        if let Err(error) = self.outgoing.send(Message::text(text)).await {
            return Err(self.inbox.ended().unwrap_or_else(|| broken(error)));
        }
        self.inbox.answer().await
    }
}

impl fmt::Debug for Remote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Remote")
            .field("hello", &self.hello)
            .finish_non_exhaustive()
    }
}

/// Receives the next message.
async fn receive(incoming: &mut Incoming) -> Result<ToClient<'static>, RemoteError> {
    loop {
        match incoming.next().await {
            Some(Ok(Message::Text(text))) => {
                return serde_json::from_str(&text)
                    .map_err(|error| RemoteError::Garbled(error.to_string()));
            }
            Some(Ok(Message::Close(frame))) => {
                let why = frame.map(|frame| frame.reason.to_string());
                return Err(RemoteError::Closed(why.filter(|why| !why.is_empty())));
            }
            // The library answers pings.
            Some(Ok(_)) => {}
            Some(Err(error)) => return Err(broken(error)),
            None => return Err(RemoteError::Closed(None)),
        }
    }
}

fn handshake(address: &StationAddress, name: &str) -> Result<Handshake, ConnectError> {
    let scheme = if address.is_encrypted() { "wss" } else { "ws" };
    let (authority, name) = (address.authority(), percent(name));
    let url = format!("{scheme}://{authority}/api/v1/ws?states={STATES_PER_S}&name={name}");
    let mut handshake = url
        .into_client_request()
        .map_err(|error| ConnectError::no_station(address, error))?;
    if let Some(token) = &address.token {
        let bearer = HeaderValue::from_str(&format!("Bearer {token}"));
        let bearer = bearer.map_err(|_| ConnectError::Token)?;
        handshake.headers_mut().insert("Authorization", bearer);
    }
    Ok(handshake)
}

fn no_handshake(address: &StationAddress, error: tungstenite::Error) -> ConnectError {
    match error {
        tungstenite::Error::Http(answer) => {
            let body = answer.body().as_deref().unwrap_or_default();
            fetch::refused(address, answer.status().as_u16(), body)
        }
        error => ConnectError::no_station(address, error),
    }
}

fn refused(problem: Problem) -> RemoteError {
    RemoteError::Refused(Box::new(problem))
}

fn broken(error: tungstenite::Error) -> RemoteError {
    use tungstenite::Error::{AlreadyClosed, ConnectionClosed};
    match error {
        AlreadyClosed | ConnectionClosed => RemoteError::Closed(None),
        error => RemoteError::Broken(Box::new(error)),
    }
}

/// The timeout for an answer.
const fn patience(request: &Request) -> Duration {
    match request {
        // Small slow motions.
        Request::Detect => Duration::from_secs(180),
        // The whole path of a job is checked when it is queued and again when it starts.
        Request::SubmitJob { .. }
        | Request::QueueAgain { .. }
        | Request::StartJob { .. }
        | Request::AnswerJob { .. }
        | Request::StepJob { .. } => Duration::from_secs(60),
        _ => PATIENCE,
    }
}

/// Percent-encodes a text for an address.
fn percent(text: &str) -> String {
    let encoded = |byte: u8| {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            char::from(byte).to_string()
        } else {
            format!("%{byte:02X}")
        }
    };
    text.bytes().map(encoded).collect()
}

const PATIENCE: Duration = Duration::from_secs(5);
