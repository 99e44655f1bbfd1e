//! The web side of the station: page, API, OpenAPI document, WebSockets and access control.
//!
//! A connection (`listen`) carries requests through authorisation (`auth`: host, origin, caller and
//! rate) to its route (`routes`: a row per request), or becomes a WebSocket (`socket`). A failed
//! request is answered with a problem document (`dobot_api::kinds`).

mod access;
#[cfg(feature = "full")]
mod agents;
#[cfg(not(feature = "full"))]
#[path = "http/not_built/agents.rs"]
mod agents;
mod app;
mod arm_facts;
mod exchange;
#[cfg(test)]
mod fake;
mod fleet_routes;
mod live;
#[cfg(feature = "proofs")]
mod proofs;
mod resources;
mod route;
mod routes;
mod serve;
#[cfg(test)]
mod tests;
#[cfg(feature = "full")]
mod tls;
#[cfg(not(feature = "full"))]
#[path = "http/not_built/tls.rs"]
mod tls;

pub use access::tokens::{Token, Tokens, TokensError};
pub use exchange::internal_api::StationApi;
#[cfg(feature = "proofs")]
pub use proofs::{PROOF, prove};
pub use serve::server::{ServeError, Served, Web, serve};
#[cfg(all(test, feature = "full"))]
pub(crate) use tls::Certificate;
pub use tls::TlsError;
