//! The web side with a fake driver of the arm.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

#[cfg(feature = "full")]
mod agents;
mod arm_facts;
mod attacks;
mod bad_input;
mod calibrating;
mod custom_buttons;
mod document;
mod drawings;
mod files;
mod fleet;
mod fleet_work;
mod learners;
mod leases;
mod observing;
mod policies;
mod programs;
mod recordings;
mod routes;
mod schema;
mod served;
mod slots;
mod sockets;
mod test_arms;
mod token_routes;
mod virtual_arms;
#[cfg(not(feature = "full"))]
mod without_agents;

use std::net::SocketAddr;
use std::sync::Arc;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::request::Builder;
use axum::http::{HeaderMap, Request, StatusCode};
use dobot_api::{Request as Wish, Role, StationAddress};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::OwnVirtualArm;
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use futures_util::{FutureExt, StreamExt};
use serde_json::Value;
use tokio::sync::watch;
use tower::ServiceExt;

use crate::http::access::tokens::{Token, Tokens};
use crate::http::app::{App, AppFiles, Peer, Reach};
use crate::http::fake::{Asked, FakeNews, driver};
use crate::http::serve::listen::ConnectionSlots;

/// A station without a network.
struct Harness {
    router: Router,
    app: Arc<App>,
    publisher: Arc<FakeNews>,
    asked: Asked,
    peer: Peer,
    _end: watch::Sender<bool>,
    tokens: Vec<Token>,
    folder: tempfile::TempDir,
}

/// Returns the available part of an endless body.
fn what_is_there(body: Body) -> Vec<u8> {
    let mut frames = body.into_data_stream();
    let mut found = Vec::new();
    while let Some(Some(frame)) = frames.next().now_or_never() {
        found.extend(frame.unwrap());
    }
    found
}

/// A response.
#[derive(Debug)]
struct Answer {
    status: u16,
    headers: HeaderMap,
    body: String,
}

impl Harness {
    /// On loopback, where everyone has all rights.
    fn near() -> Self {
        Self::with("127.0.0.1:8642", false, Some(Role::Admin))
    }

    /// On a network, with TLS and a token for each role.
    fn far() -> Self {
        Self::with("192.168.7.5:8642", true, None)
    }

    fn with(to: &str, secure: bool, without_token: Option<Role>) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut tokens = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        let made = Role::ALL.map(|role| tokens.add(role, role.name()).unwrap());
        let (handle, publisher, asked) = driver();
        let (end, ending) = watch::channel(false);
        let app = App::new(
            handle,
            tokens,
            without_token,
            Reach {
                own: StationAddress::new(&format!("http://{to}")).unwrap(),
                names: vec!["arm.local".into()],
                listens: (to.parse().unwrap(), false),
            },
            AppFiles {
                policy: folder.path().join("policy.toml"),
                recordings: folder.path().join("recordings"),
                buttons: folder.path().join("buttons.json"),
                stored: folder.path().join("files"),
                extras: folder.path().join("extras"),
            },
            Some(own_virtual_arm()),
            ending,
        );
        let to: SocketAddr = to.parse().unwrap();
        let from = SocketAddr::new(to.ip(), 50_000);
        let slot = Arc::new(ConnectionSlots::default())
            .take(from.ip())
            .unwrap();
        Self {
            router: super::routes::router(app.clone()),
            app,
            publisher,
            asked,
            peer: Peer {
                from,
                to,
                secure,
                by_fleet: false,
                _slot: Some(Arc::new(slot)),
            },
            _end: end,
            tokens: made.into(),
            folder,
        }
    }

    /// Returns the start of a well-formed request.
    fn request(&self, method: &str, path: &str) -> Builder {
        Request::builder()
            .method(method)
            .uri(path)
            .header("host", self.peer.to.to_string())
    }

    /// Returns the Authorization header of a role.
    fn bearer(&self, role: Role) -> String {
        format!("Bearer {}", self.tokens[role as usize].secret())
    }

    /// Sends a request, and checks that the document lists the status of the response.
    async fn send(&self, mut request: Request<Body>) -> Answer {
        let route = format!("{} {}", request.method(), request.uri().path());
        request.extensions_mut().insert(self.peer.clone());
        let response = self.router.clone().oneshot(request).await.unwrap();
        let (parts, body) = response.into_parts();
        let is_endless = parts
            .headers
            .get("content-type")
            .is_some_and(|header| header == "text/event-stream");
        let body = if is_endless {
            what_is_there(body)
        } else {
            to_bytes(body, usize::MAX).await.unwrap().to_vec()
        };
        let answer = Answer {
            status: parts.status.as_u16(),
            headers: parts.headers,
            body: String::from_utf8(body).unwrap(),
        };
        if let Some(statuses) = document::statuses(&route) {
            assert!(
                statuses.contains(&answer.status),
                "{route} is not documented to answer {answer:?}"
            );
        }
        answer
    }

    async fn get(&self, path: &str) -> Answer {
        self.send(self.request("GET", path).body(Body::empty()).unwrap())
            .await
    }

    async fn json(&self, method: &str, path: &str, body: impl Into<Body>) -> Answer {
        let request = self
            .request(method, path)
            .header("content-type", "application/json");
        self.send(request.body(body.into()).unwrap()).await
    }

    async fn bare(&self, method: &str, path: &str) -> Answer {
        self.send(self.request(method, path).body(Body::empty()).unwrap())
            .await
    }

    fn asked(&self) -> Vec<Wish> {
        self.asked.requests()
    }
}

fn own_virtual_arm() -> OwnVirtualArm {
    let power_up = PowerUp::new(Personality::Specification);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    OwnVirtualArm {
        arm: InProcess::new(arm),
        power_up,
    }
}

impl Answer {
    fn value(&self) -> Value {
        serde_json::from_str(&self.body).unwrap()
    }

    /// Returns kind and detail of a problem, and checks that the problem document is complete.
    #[track_caller]
    fn problem(&self) -> (String, String) {
        assert_eq!(
            self.headers["content-type"], "application/problem+json",
            "{self:?}"
        );
        let problem: dobot_api::Problem = serde_json::from_str(&self.body).unwrap();
        assert_eq!(problem.status, self.status);
        let kind = problem.kind.strip_prefix("/api/v1/problems/").unwrap();
        let known = dobot_api::problem_kinds::named(kind)
            .unwrap_or_else(|| panic!("{kind} is not explained"));
        assert_eq!(
            (known.title, known.status),
            (&*problem.title, problem.status)
        );
        (kind.into(), problem.detail)
    }

    #[track_caller]
    fn is(&self, status: u16) -> &Self {
        assert_eq!(self.status, status, "{self:?}");
        assert!(StatusCode::from_u16(status).is_ok());
        self
    }

    #[track_caller]
    fn is_problem(&self, kind: &str) {
        assert_eq!(self.problem().0, kind, "{self:?}");
    }
}
