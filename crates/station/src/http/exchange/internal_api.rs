//! The API for callers inside the process: their requests pass the same checks as HTTP requests.

use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, Bytes, to_bytes};
use axum::extract::Request;
use axum::http::header::{AUTHORIZATION, CONTENT_TYPE, HOST};
use axum::http::{HeaderValue, Method};
use axum::response::Response;
use axum::{Extension, Router};
#[cfg(feature = "proofs")]
use dobot_api::problem_kinds::UNAUTHORISED;
use dobot_api::problem_kinds::{INVALID, MALFORMED, TIMEOUT, TOO_LARGE};
use dobot_api::{ApiAnswer, ApiRequest, Problem};
use dobot_host::StationHandle;
use serde_json::Value;
use tokio::time::timeout;
use tower::ServiceExt;

use crate::http::access::auth::Proved;
use crate::http::app::{App, Peer};
use crate::http::exchange::requester::{KEY, LEASE};
use crate::http::exchange::responses::JOB;
use crate::http::routes;
use crate::{ArmsPort, FleetPort};

/// A station's API for its fleet: the same routes, tokens and roles as over HTTP. A caller without
/// a token may watch and stop, wherever the station is served.
#[derive(Clone, Debug)]
pub struct StationApi {
    app: Arc<App>,
    router: Router,
    to: SocketAddr,
}

impl StationApi {
    pub(in crate::http) fn new(app: Arc<App>, to: SocketAddr) -> Self {
        let peer = Peer {
            from: (Ipv4Addr::UNSPECIFIED, 0).into(),
            to,
            secure: false,
            by_fleet: true,
            _slot: None,
        };
        let router = routes::router(app.clone()).layer(Extension(peer));
        Self { app, router, to }
    }

    /// Returns the states, notices and packets of the station.
    #[must_use]
    pub fn handle(&self) -> &StationHandle {
        &self.app.handle
    }

    /// Connects the station to its fleet.
    pub fn join(&self, fleet: FleetPort) {
        // A station joins once, before any request for its fleet.
        let _ = self.app.fleet.set(fleet);
    }

    /// Makes the station host virtual arms.
    pub fn give_arms(&self, arms: ArmsPort) {
        // Set once, at the start.
        let _ = self.app.arms.set(arms);
    }

    /// Sends a request to the station.
    pub async fn call(&self, request: &ApiRequest) -> ApiAnswer {
        self.call_as(request, None).await
    }

    /// Sends a request with a proof of a token for this statement.
    #[cfg(feature = "proofs")]
    pub async fn call_proved(
        &self,
        request: &ApiRequest,
        statement: &[u8],
        proof: &[u8],
    ) -> ApiAnswer {
        match self.app.proved(statement, proof) {
            Some(token) => self.call_as(request, Some(Proved(token))).await,
            None => ApiAnswer::of_problem(&UNAUTHORISED.hinted(
                "the station does not know this token",
                "on the receiving station, run `dobot token add ROLE NAME --same-as FILE`; first remove a token that an older version accepted",
            )),
        }
    }

    async fn call_as(&self, request: &ApiRequest, who: Option<Proved>) -> ApiAnswer {
        let answered = async {
            let mut request = read(request, self.to)?;
            if let Some(proved) = who {
                request.extensions_mut().insert(proved);
            }
            let Ok(response) = self.router.clone().oneshot(request).await;
            answer(response).await
        };
        answered
            .await
            .unwrap_or_else(|problem| ApiAnswer::of_problem(&problem))
    }
}

/// Converts a request to an HTTP request.
fn read(asked: &ApiRequest, to: SocketAddr) -> Result<Request, Problem> {
    let method = asked.method.parse::<Method>();
    let method = method.map_err(|_| INVALID.problem("method: not an HTTP method"))?;
    let mut request = Request::builder()
        .method(method)
        .uri(&asked.path)
        .header(HOST, to.to_string());
    if let Some(token) = &asked.token {
        request = request.header(AUTHORIZATION, header("token", &format!("Bearer {token}"))?);
    }
    if let Some(lease) = &asked.lease {
        request = request.header(LEASE, header("lease", lease)?);
    }
    if let Some(key) = &asked.key {
        request = request.header(KEY, header("key", key)?);
    }
    let body = match &asked.body {
        None => Body::empty(),
        Some(body) => {
            request = request.header(CONTENT_TYPE, "application/json");
            Body::from(body.to_string())
        }
    };
    let request = request.body(body);
    request.map_err(|_| MALFORMED.problem("path: not a valid path, as in /api/v1/state"))
}

fn header(field: &str, text: &str) -> Result<HeaderValue, Problem> {
    HeaderValue::from_str(text)
        .map_err(|_| INVALID.problem(format!("{field}: allowed are visible characters")))
}

/// Reads the whole response.
async fn answer(response: Response) -> Result<ApiAnswer, Problem> {
    let status = response.status();
    let kind = response.headers().get(CONTENT_TYPE);
    let kind = kind.and_then(|kind| kind.to_str().ok()).unwrap_or_default();
    if status.is_informational() || kind.starts_with("text/event-stream") {
        return Err(INVALID.hinted(
            "path: event streams are not available through a fleet",
            "the members' states are at `GET /api/v1/fleet/events`",
        ));
    }
    let is_json = kind.ends_with("json");
    let body = whole(response.into_body()).await?;
    let text = || Value::String(String::from_utf8_lossy(&body).into_owned());
    let read = is_json
        .then(|| serde_json::from_slice(&body).ok())
        .flatten();
    Ok(ApiAnswer {
        status: status.as_u16(),
        body: match read {
            Some(read) => read,
            None if body.is_empty() => Value::Null,
            None => text(),
        },
    })
}

async fn whole(body: Body) -> Result<Bytes, Problem> {
    let body = timeout(WITHIN, to_bytes(body, JOB)).await;
    let body = body.map_err(|_| {
        let within_s = WITHIN.as_secs();
        TIMEOUT.problem(format!("the response did not arrive within {within_s} s"))
    })?;
    body.map_err(|_| TOO_LARGE.problem(format!("the response has more than {JOB} bytes")))
}

/// The timeout for reading a response.
const WITHIN: Duration = Duration::from_secs(30);
