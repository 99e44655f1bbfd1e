//! Serving agents over HTTP, for a server that knows who asks.

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

/// The tools for agents that come over HTTP (the protocol's streamable transport). Who may come is for the server to
/// decide; what one may do is decided by the station, by the token that comes with each request.
pub struct HttpAgents {
    agents: Agents,
    sessions: Arc<LocalSessionManager>,
    service: StreamableHttpService<Agents, LocalSessionManager>,
}

/// No more agents have sessions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{MOST_SESSIONS} agents have sessions already")]
pub struct TooManyAgents;

impl HttpAgents {
    /// How long a request may be, in bytes.
    pub const MOST_BYTES: usize = 8 * 1024 * 1024;

    /// Tools that act at this station, each with the token of its request.
    #[must_use]
    pub fn new(station: StationAddress) -> Self {
        let agents = Agents::new(Settings::at(station));
        let mut sessions = LocalSessionManager::default();
        sessions.session_config.keep_alive = Some(LONGEST_SILENCE);
        let sessions = Arc::new(sessions);
        let config = StreamableHttpServerConfig::default()
            // The server has looked at it, and knows by which names it goes.
            .disable_allowed_hosts()
            .with_sse_keep_alive(Some(ALIVE_EVERY))
            .with_max_request_body_bytes(Self::MOST_BYTES);
        let each = agents.clone();
        Self {
            service: StreamableHttpService::new(move || Ok(each.clone()), sessions.clone(), config),
            agents,
            sessions,
        }
    }

    /// Answers a request that came with this token, and keeps `place` until the answer is told. One who does not wait
    /// for the answer has given up what was asked for, and the arm is stopped where it was moved for that.
    ///
    /// # Errors
    ///
    /// [`TooManyAgents`] where it would begin one more session than there may be.
    pub async fn answer<P>(
        &self,
        mut request: Request,
        token: Option<String>,
        place: P,
    ) -> Result<Response, TooManyAgents>
    where
        P: Send + Unpin + 'static,
    {
        if begins(&request) && self.sessions.sessions.read().await.len() >= MOST_SESSIONS {
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

    /// What the protocol answers. The future is boxed so that the protocol is compiled in this crate, and not in the one
    /// that awaits it.
    fn handle(&self, request: Request) -> Pin<Box<dyn Future<Output = Response> + Send + '_>> {
        Box::pin(async { self.service.handle(request).await.map(Body::new) })
    }

    /// Ends all sessions; what is under way stops the arm.
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

/// Who asks for a tool over HTTP, and whether he waits for the answer.
#[derive(Clone, Debug)]
pub(crate) struct Visit {
    pub(crate) token: Option<String>,
    here: watch::Receiver<()>,
}

impl Visit {
    /// The visit to which a call belongs; none over standard input.
    pub(crate) fn of(extensions: &Extensions) -> Option<&Self> {
        let parts = extensions.get::<Parts>()?;
        parts.extensions.get::<Self>()
    }

    /// Until nobody waits for the answer any more.
    pub(crate) async fn is_over(&self) {
        let mut here = self.here.clone();
        // Nothing is ever told, so that only the end is.
        let _ = here.changed().await;
    }
}

/// An answer that somebody waits for, until it is told or its connection is gone.
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

/// Whether a request may begin a session.
fn begins(request: &Request) -> bool {
    request.method() == Method::POST && !request.headers().contains_key("mcp-session-id")
}

/// How many agents may have sessions at once.
const MOST_SESSIONS: usize = 256;
/// After how long a session is over in which nothing happens: longer than a call may wait for a job.
const LONGEST_SILENCE: Duration = Duration::from_secs(4000);
/// So often something comes, so that a dead connection is found.
const ALIVE_EVERY: Duration = Duration::from_secs(5);
