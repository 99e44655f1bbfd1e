//! Joins stations: each knows who else is there and what it does, and asks the others by the requests of their own API.
//!
//! ```text
//!   board, programs                     other stations
//!        |                                    |
//!   station's API ---- FleetPort ---- Fleet --+-- Zenoh: who is there, what each tells, requests and answers
//!        ^                              |
//!        `--------- StationApi ---------'         what others ask passes the same tokens, roles and rules
//! ```
//!
//! A station stays what it is without a fleet: its rules, its stop, its page. What joins them only carries.
//!
//! The keys of Zenoh, for peers of others:
//!
//! | key | what |
//! |---|---|
//! | `dobot/alive/1/VERSION/NAME/ID` | a liveliness token for as long as the station is there |
//! | `dobot/1/NAME/ID/told` | published, and answered when asked: `{"about": MemberAbout, "state": State}` |
//! | `dobot/1/NAME/ID/api` | answers an [`ApiRequest`](dobot_api::ApiRequest) with an [`ApiAnswer`](dobot_api::ApiAnswer) |
//!
//! `1` is the version of these messages ([`MESSAGES`]), `VERSION` that of the program.

mod asking;
mod config;
mod credentials;
mod id;
mod join;
mod keys;
mod network;
mod roster;
mod router;
mod telling;
pub mod together;
mod work;

pub use config::{FleetConfig, FleetConfigError};
pub use credentials::{Credentials, CredentialsError, Holder};
pub use id::{IdError, own_id};
pub use join::{Fleet, FleetError};
pub use keys::MESSAGES;
pub use router::Router;
