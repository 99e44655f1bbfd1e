//! The API for those who come by another way than a connection: what they ask passes all that a request of HTTP
//! passes.

use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

use axum::body::{Body, to_bytes};
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
use crate::http::exchange::answer::JOB;
use crate::http::exchange::requester::{KEY, LEASE};
use crate::http::routes;
use crate::{ArmsPort, FleetPort};

/// A station's API, for its fleet: the same routes, tokens and roles as over HTTP. One who comes without a token
/// may watch and stop, wherever the station is served.
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

    /// The states, notices and packets of the station.
    #[must_use]
    pub fn handle(&self) -> &StationHandle {
        &self.app.handle
    }

    /// Lets the station know the others.
    pub fn join(&self, fleet: FleetPort) {
        // A station joins once, before anybody asks for its fleet.
        let _ = self.app.fleet.set(fleet);
    }

    /// Lets the station give virtual arms to those without one.
    pub fn give_arms(&self, arms: ArmsPort) {
        // There is one that gives them, from the start on.
        let _ = self.app.arms.set(arms);
    }

    /// Asks the station.
    pub async fn call(&self, request: &ApiRequest) -> ApiAnswer {
        self.call_as(request, None).await
    }

    /// Asks the station with a proof of a token, which is one about this statement.
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
                "the station does not know the token of this proof",
                "on the asked station: `dobot token add ROLE NAME --same-as FILE`; one that an older program accepted has to be removed first",
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

/// The request of HTTP.
fn read(asked: &ApiRequest, to: SocketAddr) -> Result<Request, Problem> {
    let method = asked.method.parse::<Method>();
    let method = method.map_err(|_| INVALID.problem("method: this is no method of HTTP"))?;
    let header = |name: &str, text: String| {
        let value = HeaderValue::from_str(&text);
        value.map_err(|_| INVALID.problem(format!("{name}: this takes visible characters")))
    };
    let mut request = Request::builder()
        .method(method)
        .uri(&asked.path)
        .header(HOST, to.to_string());
    if let Some(token) = &asked.token {
        request = request.header(AUTHORIZATION, header("token", format!("Bearer {token}"))?);
    }
    if let Some(lease) = &asked.lease {
        request = request.header(LEASE, header("lease", lease.clone())?);
    }
    if let Some(key) = &asked.key {
        request = request.header(KEY, header("key", key.clone())?);
    }
    let body = match &asked.body {
        None => Body::empty(),
        Some(body) => {
            request = request.header(CONTENT_TYPE, "application/json");
            Body::from(body.to_string())
        }
    };
    let request = request.body(body);
    request.map_err(|_| MALFORMED.problem("path: this is no path, as in /api/v1/state"))
}

/// The answer, as far as it ends.
async fn answer(response: Response) -> Result<ApiAnswer, Problem> {
    let status = response.status();
    let kind = response.headers().get(CONTENT_TYPE);
    let kind = kind.and_then(|kind| kind.to_str().ok()).unwrap_or_default();
    if status.is_informational() || kind.starts_with("text/event-stream") {
        return Err(INVALID.hinted(
            "path: this does not end, and a fleet carries only answers",
            "the members' states are at `GET /api/v1/fleet/events`",
        ));
    }
    let is_json = kind.ends_with("json");
    let body = timeout(WITHIN, to_bytes(response.into_body(), JOB)).await;
    let body = body.map_err(|_| {
        let within_s = WITHIN.as_secs();
        TIMEOUT.problem(format!("the answer was not there within {within_s} s"))
    })?;
    let body =
        body.map_err(|_| TOO_LARGE.problem(format!("the answer has more than {JOB} bytes")))?;
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

/// How long an answer may take to be told.
const WITHIN: Duration = Duration::from_secs(30);
