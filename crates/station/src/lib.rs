//! The daemon that owns an arm's port and enforces its safety rules.
//!
//! ```text
//!   browsers, programs    legacy programs
//!    http, WebSocket     raw port, virtual port
//!          |                     |
//!          `--- StationHandle ---+----> dobot_host::Host ----> the arm
//! ```
//!
//! [`Station::start`] starts everything. The rules are those of `dobot_host`, and the messages over
//! HTTP and WebSocket are those of `dobot_api`:
//!
//! ```
//! use dobot_api::{Folders, Remote, Request, StationAddress};
//! use dobot_session::Address;
//! use dobot_station::{Config, Station};
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let folder = tempfile::tempdir()?;
//! let station = Station::start(Config {
//!     arm: Some(Address::Virtual),
//!     http: "127.0.0.1:0".parse()?,
//!     raw: None,
//!     ..Config::new(Folders::at(folder.path()))
//! })
//! .await?;
//!
//! let mut anna = Remote::connect(&StationAddress::new(station.url())?, "Anna").await?;
//! anna.request(Request::TakeLease).await?;
//! station.end().await?;
//! # Ok(())
//! # }
//! ```

mod bridge;
mod config;
mod extras;
#[cfg(test)]
mod fake;
mod fleet;
#[cfg(feature = "full")]
mod foxglove;
#[cfg(not(feature = "full"))]
#[path = "not_built/foxglove.rs"]
mod foxglove;
mod hooks;
mod http;
mod program;
mod raw;
#[cfg(test)]
mod sample;
mod start;
mod virtual_arms;
#[cfg(unix)]
mod virtual_port;

pub use config::{Config, DEFAULT_HTTP, DEFAULT_RAW, TlsFiles};
pub use extras::{EXTRAS, Extra, ExtraError, HANDS};
pub use fleet::{
    FleetAsk, FleetChannels, FleetCommand, FleetPort, Members, NewWork, OFFERS, UNSETTLED,
    WorkCommand, work_hurdle,
};
pub use foxglove::{FoxglovePort, FoxglovePortError};
pub use hooks::HooksError;
#[cfg(feature = "proofs")]
pub use http::{PROOF, prove};
pub use http::{ServeError, Served, StationApi, TlsError, Token, Tokens, TokensError, Web, serve};
pub use program::{ProgramNews, Traffic};
pub use raw::{RawPort, RawPortError};
pub use start::{Failed, StartError, Station};
pub use virtual_arms::{ArmCommand, ArmSelection, ArmsPort};
#[cfg(unix)]
pub use virtual_port::VirtualPort;
