//! Authorisation: each request passes through here before it reaches its route.

use std::net::IpAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::{MatchedPath, Request, State};
use axum::http::header::{AUTHORIZATION, HOST, ORIGIN, SEC_WEBSOCKET_PROTOCOL};
use axum::http::uri::Authority;
use axum::http::{HeaderMap, HeaderName, Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::{FORBIDDEN_HOST, FORBIDDEN_ORIGIN, MALFORMED, UNAUTHORISED};
use dobot_api::{Problem, Role};

use crate::http::access::tokens::digest;
use crate::http::app::{App, Caller, Peer};
use crate::http::exchange::responses::{self, RateLimited, RequestFailed};
use crate::http::resources::page;
use crate::http::routes;

/// The prefix of the subprotocol that carries the token of a browser's WebSocket.
pub(crate) const TOKEN_PROTOCOL: &str = "dobot.token.";

/// Passes a request on, or answers it with a problem.
pub(crate) async fn pass(
    State(app): State<Arc<App>>,
    mut request: Request,
    next: Next,
) -> Response {
    let peer = request.extensions().get::<Peer>().cloned();
    let peer = peer.expect("every connection comes with its ends");
    let began = app.now();
    let (method, path) = (request.method().clone(), request.uri().path().to_owned());
    let answer = match look(&app, &peer, &request) {
        Ok(caller) => {
            request.extensions_mut().insert(caller);
            next.run(request).await
        }
        Err(response) => response,
    };
    let took = app.now().saturating_sub(began);
    log(&peer, &method, &path, answer.status(), took);
    responses::guarded(answer)
}

/// Logs a request: a server error as a warning, a refused one at level info, others at level debug.
/// Bodies and tokens are not logged.
fn log(peer: &Peer, method: &Method, path: &str, status: StatusCode, took: Duration) {
    let (from, status) = (peer.from, status.as_u16());
    let took_ms = took.as_secs_f64() * 1e3;
    match status {
        500.. => tracing::warn!(%from, %method, path, status, took_ms, "request"),
        401 | 403 => tracing::info!(%from, %method, path, status, took_ms, "request"),
        _ => tracing::debug!(%from, %method, path, status, took_ms, "request"),
    }
}

fn look(app: &App, peer: &Peer, request: &Request) -> Result<Caller, Response> {
    let host = host(request).map_err(refused)?;
    check_host(app, peer, &host).map_err(refused)?;
    check_origin(peer, &host, request.headers()).map_err(refused)?;
    let caller = identify(app, peer, request);
    let cost = match &caller {
        Err(_) => WRONG_TOKEN,
        Ok(_) if page::has(request.uri().path()) => FILE,
        Ok(_) => 1.0,
    };
    match app.addresses.take(peer.from.ip(), app.now(), cost) {
        // A caller who may stop the arm may always stop it.
        Err(wait) if caller.is_err() || !is_stop(request) => Err(RateLimited(wait).into_response()),
        _ => caller.map_err(refused),
    }
}

fn refused(problem: Problem) -> Response {
    RequestFailed(problem).into_response()
}

/// The cost of a file of the page, in requests: a visit requests all of them together.
const FILE: f64 = 0.05;
/// The cost of a wrong token, in requests, against guessing.
const WRONG_TOKEN: f64 = 20.0;

/// Returns the host that the client addresses.
fn host(request: &Request) -> Result<Authority, Problem> {
    let mut hosts = request.headers().get_all(HOST).iter();
    let (Some(host), None) = (hosts.next(), hosts.next()) else {
        return Err(MALFORMED.problem("a request must have exactly one Host header"));
    };
    let text = host.to_str().unwrap_or_default();
    let parsed = text
        .parse::<Authority>()
        .ok()
        .filter(|authority| !authority.as_str().contains('@'));
    let Some(host) = parsed else {
        return Err(MALFORMED.problem("the Host header is not a name or address with a port"));
    };
    match request.uri().authority() {
        Some(other) if *other != host => {
            Err(MALFORMED.problem("the Host header and the address of the request differ"))
        }
        _ => Ok(host),
    }
}

/// Protects against DNS rebinding: pages whose own name resolves to this station.
fn check_host(app: &App, peer: &Peer, host: &Authority) -> Result<(), Problem> {
    let default = if peer.secure { 443 } else { 80 };
    let port = host.port_u16().unwrap_or(default);
    if port == peer.to.port() && is_ours(app, peer, host.host()) {
        return Ok(());
    }
    Err(FORBIDDEN_HOST.hinted(
        format!("this station does not have the name {host}"),
        format!("use its address, {}", peer.to),
    ))
}

fn is_ours(app: &App, peer: &Peer, name: &str) -> bool {
    let to = peer.to.ip().to_canonical();
    let bare = name.trim_start_matches('[').trim_end_matches(']');
    match bare.parse::<IpAddr>() {
        Ok(address) => address.to_canonical() == to,
        Err(_) if name.eq_ignore_ascii_case("localhost") => to.is_loopback(),
        Err(_) => app.names.iter().any(|own| own.eq_ignore_ascii_case(name)),
    }
}

/// Protects against pages of other sites.
fn check_origin(peer: &Peer, host: &Authority, headers: &HeaderMap) -> Result<(), Problem> {
    let scheme = if peer.secure { "https" } else { "http" };
    let own = format!("{scheme}://{host}");
    let strange =
        |origin: &&axum::http::HeaderValue| !origin.as_bytes().eq_ignore_ascii_case(own.as_bytes());
    if headers
        .get_all(ORIGIN)
        .iter()
        .any(|origin| strange(&origin))
    {
        return Err(FORBIDDEN_ORIGIN.problem("the request comes from a page of another site"));
    }
    match headers
        .get(FETCH_SITE)
        .map(axum::http::HeaderValue::as_bytes)
    {
        Some(b"cross-site" | b"same-site")
            if headers
                .get(FETCH_MODE)
                .is_none_or(|mode| mode != "navigate") =>
        {
            Err(FORBIDDEN_ORIGIN.problem("the request comes from a page of another site"))
        }
        _ => Ok(()),
    }
}

const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");
const FETCH_MODE: HeaderName = HeaderName::from_static("sec-fetch-mode");

/// Returns the caller, by its token or by the default role.
fn identify(app: &App, peer: &Peer, request: &Request) -> Result<Caller, Problem> {
    let anyone = |role| Caller {
        name: nameless(peer, request),
        role,
        is_person: false,
        token: None,
    };
    let token = match request.extensions().get() {
        Some(Proved(token)) => Some(*token),
        None => presented(request.headers())?.as_deref().map(digest),
    };
    match token {
        Some(token) => match app.holder(&token) {
            Some((name, role)) => Ok(Caller {
                is_person: !app.tokens().is_local(&token) && !app.tokens().is_shared(&name),
                token: Some(token),
                name,
                role,
            }),
            None => Err(UNAUTHORISED.problem("the station does not know this token")),
        },
        None if is_open(request) || peer.by_fleet => Ok(anyone(Role::Watch)),
        None => app.without_token.map(anyone).ok_or_else(no_token),
    }
}

/// Returns the name of a caller without a token.
fn nameless(peer: &Peer, request: &Request) -> String {
    if peer.by_fleet {
        return "fleet".to_owned();
    }
    client_from(peer.from.ip(), request.headers().contains_key(FETCH_SITE))
}

/// Returns the name of a client that gives none: a page, if a browser sends for it, or a program.
fn client_from(address: IpAddr, is_browser: bool) -> String {
    let what = if is_browser { "a page" } else { "a program" };
    match address.to_canonical() {
        address if address.is_loopback() => format!("{what} on this computer"),
        address => format!("{what} from {address}"),
    }
}

/// The digest of a token that was proved with the request.
#[derive(Clone, Copy)]
pub(crate) struct Proved(pub(crate) [u8; 32]);

/// Returns the token of a request.
pub(crate) fn presented(headers: &HeaderMap) -> Result<Option<String>, Problem> {
    if let Some(value) = headers.get(AUTHORIZATION) {
        let text = value.to_str().unwrap_or_default();
        return match text.split_once(' ') {
            Some((scheme, token)) if scheme.eq_ignore_ascii_case("bearer") => {
                Ok(Some(token.trim().into()))
            }
            _ => Err(UNAUTHORISED.problem("the Authorization header is not `Bearer <token>`")),
        };
    }
    Ok(protocols(headers)
        .find_map(|protocol| protocol.strip_prefix(TOKEN_PROTOCOL).map(Into::into)))
}

/// Returns the subprotocols that a WebSocket offers.
pub(crate) fn protocols(headers: &HeaderMap) -> impl Iterator<Item = &str> {
    let lines = headers.get_all(SEC_WEBSOCKET_PROTOCOL).iter();
    lines
        .filter_map(|line| line.to_str().ok())
        .flat_map(|text| text.split(','))
        .map(str::trim)
}

fn no_token() -> Problem {
    UNAUTHORISED.hinted(
        "this request requires a token",
        "send it as `Authorization: Bearer <token>`",
    )
}

/// Whether the route is public.
fn is_open(request: &Request) -> bool {
    let path = request.extensions().get::<MatchedPath>();
    path.is_some_and(|path| routes::is_open(request.method(), path.as_str()))
}

fn is_stop(request: &Request) -> bool {
    request.method() == Method::POST && routes::STOPS.contains(&request.uri().path())
}
