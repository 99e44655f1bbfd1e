//! Serving agents over HTTP, behind a server that authenticates them.

use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use axum::body::{Body, Bytes, HttpBody};
use axum::extract::Request;
use axum::http::Method;
use axum::http::request::Parts;
use axum::response::Response;
use dobot_api::StationAddress;
use http_body::{Frame, SizeHint};
use rmcp::model::Extensions;
use rmcp::transport::streamable_http_server::session::local::LocalSessionManager;
use rmcp::transport::{StreamableHttpServerConfig, StreamableHttpService};
use tokio::sync::watch;

use crate::{Agents, Settings};

/// The tools for agents over HTTP (the protocol's streamable transport). The server controls
/// access; the station checks each call by the token of its request.
pub struct HttpAgents {
    agents: Agents,
    sessions: Arc<LocalSessionManager>,
    service: StreamableHttpService<Agents, LocalSessionManager>,
}

/// The error returned when there are too many sessions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{MAX_SESSIONS} agents already have sessions")]
pub struct TooManyAgents;

impl HttpAgents {
    /// The maximum length of a request, in bytes.
    pub const MAX_BYTES: usize = 8 * 1024 * 1024;

    /// Returns tools for this station, each used with the token of its request.
    #[must_use]
    pub fn new(station: StationAddress) -> Self {
        let agents = Agents::new(Settings::at(station));
        let mut sessions = LocalSessionManager::default();
        sessions.session_config.keep_alive = Some(LONGEST_SILENCE);
        let sessions = Arc::new(sessions);
        let config = StreamableHttpServerConfig::default()
            // The server has checked the Host header, and knows the valid names.
            .disable_allowed_hosts()
            .with_sse_keep_alive(Some(ALIVE_EVERY))
            .with_max_request_body_bytes(Self::MAX_BYTES);
        let each = agents.clone();
        Self {
            service: StreamableHttpService::new(move || Ok(each.clone()), sessions.clone(), config),
            agents,
            sessions,
        }
    }

    /// Answers a request with this token, and keeps `place` until the response is sent. If the
    /// client closes the connection before that, the call is cancelled, and the arm is stopped if
    /// the call was moving it.
    ///
    /// # Errors
    ///
    /// [`TooManyAgents`] if it would open a session beyond the maximum.
    pub async fn answer<P>(
        &self,
        mut request: Request,
        token: Option<String>,
        place: P,
    ) -> Result<Response, TooManyAgents>
    where
        P: Send + Unpin + 'static,
    {
        if begins(&request) && self.sessions.sessions.read().await.len() >= MAX_SESSIONS {
            return Err(TooManyAgents);
        }
        let (waits, here) = watch::channel(());
        request.extensions_mut().insert(Visit { token, here });
        let response = self.handle(request).await;
        Ok(response.map(|body| {
            Body::new(Awaited {
                body,
                _waits: waits,
                _place: place,
            })
        }))
    }

    /// Returns the response of the protocol. The future is boxed so that the protocol is compiled
    /// in this crate, not in its users.
    fn handle(&self, request: Request) -> Pin<Box<dyn Future<Output = Response> + Send + '_>> {
        Box::pin(async { self.service.handle(request).await.map(Body::new) })
    }

    /// Ends all sessions; calls in progress stop the arm.
    pub fn end(&self) {
        self.agents.gone().send_replace(true);
        self.service.config.cancellation_token.cancel();
    }
}

impl std::fmt::Debug for HttpAgents {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HttpAgents").finish_non_exhaustive()
    }
}

/// The HTTP request of a call, and whether its client still waits for the response.
#[derive(Clone, Debug)]
pub(crate) struct Visit {
    pub(crate) token: Option<String>,
    here: watch::Receiver<()>,
}

impl Visit {
    /// Returns the request of a call; `None` over standard input.
    pub(crate) fn of(extensions: &Extensions) -> Option<&Self> {
        let parts = extensions.get::<Parts>()?;
        parts.extensions.get::<Self>()
    }

    /// Waits until no client waits for the response any more.
    pub(crate) async fn is_over(&self) {
        let mut here = self.here.clone();
        // No value is ever sent; only the end of the channel matters.
        let _ = here.changed().await;
    }
}

/// A response whose client waits for it, until it is sent or the connection is gone.
struct Awaited<P> {
    body: Body,
    _waits: watch::Sender<()>,
    _place: P,
}

impl<P: Unpin> HttpBody for Awaited<P> {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        Pin::new(&mut self.body).poll_frame(context)
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}

/// Whether a request may open a session.
fn begins(request: &Request) -> bool {
    request.method() == Method::POST && !request.headers().contains_key("mcp-session-id")
}

/// The maximum number of sessions.
const MAX_SESSIONS: usize = 256;
/// The idle time after which a session ends: longer than a call may wait for a job.
const LONGEST_SILENCE: Duration = Duration::from_secs(4000);
/// The interval of keep-alive comments, which reveal dead connections.
const ALIVE_EVERY: Duration = Duration::from_secs(5);
