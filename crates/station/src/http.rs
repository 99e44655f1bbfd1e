//! The web side of the station: page, API, its document, WebSockets, and who may do what.
//!
//! A connection (`listen`) carries requests through authorisation (`auth`: is it meant for us, where does
//! it come from, who asks, how often) to its route (`routes`: a row a request), or becomes a WebSocket
//! (`socket`). Whatever is not done is answered with a problem document (`dobot_api::kinds`).

#[cfg(feature = "full")]
mod agents;
#[cfg(not(feature = "full"))]
#[path = "http/not_built/agents.rs"]
mod agents;
mod answer;
mod app;
mod arm_facts;
mod auth;
mod calls;
mod document;
mod drawings;
mod events;
#[cfg(test)]
mod fake;
mod fleet;
mod fleet_arms;
mod fleet_offers;
mod fleet_work;
mod http_leases;
mod learners;
mod listen;
mod messages;
mod metrics;
mod packets;
mod page;
mod paging;
mod programs;
#[cfg(feature = "proofs")]
mod proofs;
mod rate;
mod recordings;
mod route;
mod routes;
mod served;
mod socket;
mod station_api;
mod strict_json;
#[cfg(test)]
mod tests;
#[cfg(feature = "full")]
mod tls;
#[cfg(not(feature = "full"))]
#[path = "http/not_built/tls.rs"]
mod tls;
mod tokens;

#[cfg(feature = "proofs")]
pub use proofs::{PROOF, prove};
pub use served::{ServeError, Served, Web, serve};
pub use station_api::StationApi;
pub use tls::TlsError;
pub use tokens::{Token, Tokens, TokensError};
