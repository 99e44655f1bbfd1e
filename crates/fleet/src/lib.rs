//! Joins stations: each knows the members and their states, and sends requests to them through
//! their own HTTP API.
//!
//! ```no_run
//! use dobot_api::{Folders, MemberAbout};
//! use dobot_fleet::{Credentials, Fleet, FleetConfig, FleetSession, own_id};
//! use dobot_station::{Config, Station};
//!
//! # async fn join() -> Result<(), Box<dyn std::error::Error>> {
//! let folders = Folders::at("desk-3");
//! let id = own_id(&folders.fleet_id())?;
//! let station = Station::start(Config::new(folders)).await?;
//! let config = FleetConfig {
//!     name: "desk-3".into(),
//!     about: MemberAbout::default(),
//!     work: None,
//! };
//! let session = FleetSession::open(&[], &Credentials::of_person("desk-3")?).await?;
//! let fleet = Fleet::join(&session, &config, &id, station.api()).await?;
//! fleet.leave().await;
//! session.close().await;
//! station.end().await?;
//! # Ok(())
//! # }
//! ```
//!
//! ```text
//!   board, programs                     other stations
//!        |                                    |
//!   station's API ---- FleetPort ---- Fleet --+-- Zenoh: presence, states, requests and responses
//!        ^                              |
//!        `--------- StationApi ---------'         requests of others pass the same tokens, roles and rules
//! ```
//!
//! A station works without a fleet: its rules, its stop and its page stay the same. This crate only
//! transports.
//!
//! The key expressions of Zenoh, for other implementations:
//!
//! | key | contents |
//! |---|---|
//! | `dobot/alive/2/VERSION/NAME/ID/START/PROOF` | the liveliness token of a station; `PROOF` is a signature of the preceding parts and the signer's certificate |
//! | `dobot/2/NAME/ID/state` | published, and returned to queries: `{"about": MemberAbout, "state": State}`, with its number and a signature attached |
//! | `dobot/2/NAME/ID/api` | takes an [`ApiRequest`](dobot_api::ApiRequest) to GET or to stop, without a token, and returns an [`ApiAnswer`](dobot_api::ApiAnswer) with a signature attached |
//! | `dobot/2/NAME/ID/sealed` | takes all other requests, which only this station can read |
//! | `dobot/2/NAME/ID/stops` | takes the fleet's stops known to the sender, and returns its own: lists of [`FleetWideStop`](dobot_api::FleetWideStop), with a signature attached |
//!
//! `2` is the version of these messages ([`MESSAGES`]), `VERSION` that of the program.

mod config;
mod credentials;
mod id;
mod identity;
mod join;
mod key_expressions;
mod network;
mod publisher;
mod requests;
mod roster;
mod router;
mod sealing;
mod session;
mod stops;
pub mod together;
mod virtual_arms;
mod work;

pub use config::{FleetConfig, FleetConfigError};
pub use credentials::{Credentials, CredentialsError, Holder};
pub use id::{IdError, own_id};
pub use join::{Fleet, FleetError};
pub use key_expressions::MESSAGES;
pub use router::Router;
pub use session::FleetSession;
pub use virtual_arms::{VirtualArms, VirtualArmsConfig, page_of};
