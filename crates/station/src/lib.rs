//! The daemon that owns an arm's port and keeps people and arm safe.
//!
//! ```text
//!   browsers, programs      old programs
//!    http, WebSocket     raw port, virtual port          recordings   journal
//!          |                     |                           ^           ^
//!          `------ Handle -------+----> owner ---------------+-----------'
//!                                         |   the one task that has the port
//!                                       Keeper          every rule, an engine: no port, no file, no clock
//!                                         |
//!                                      Session ----> the arm
//! ```
//!
//! [`Station::start`] puts all of it together. The [`Keeper`] decides; a [`Rehearsal`] lets it decide in
//! virtual time, with a virtual arm:
//!
//! ```
//! use std::time::Duration;
//! use dobot_controller::{Personality, PowerUp};
//! use dobot_safety::Policy;
//! use dobot_api::Request;
//! use dobot_rules::Rehearsal;
//! use dobot_wire::{MoveTo, MovingMode};
//!
//! let mut station = Rehearsal::new(PowerUp::new(Personality::Firmware11), Policy::default());
//! station.run_for(Duration::from_secs(1));
//! let anna = station.client("Anna");
//!
//! let command = MoveTo::to(220.0, 0.0, -90.0);
//! let into_the_table = Request::Command { command: command.into() };
//! assert_eq!(station.ask(anna, into_the_table.clone()).unwrap_err().kind(), "no-lease");
//!
//! station.ask(anna, Request::TakeLease)?;
//! let refused = station.ask(anna, into_the_table).unwrap_err();
//! assert!(refused.to_string().starts_with("z would be -90 mm; table allows -63 mm and more"));
//! # Ok::<(), dobot_rules::Refusal>(())
//! ```

mod bridge;
mod config;
#[cfg(test)]
mod double;
mod http;
mod program;
mod raw;
#[cfg(test)]
mod sample;
mod start;
#[cfg(unix)]
mod virtual_port;

pub use config::{Config, DEFAULT_HTTP, DEFAULT_RAW, TlsFiles};
pub use http::{ServeError, Served, TlsError, Token, Tokens, TokensError, Web, serve};
pub use program::{ProgramNews, Traffic};
pub use raw::{RawPort, RawPortError};
pub use start::{Failed, StartError, Station};
#[cfg(unix)]
pub use virtual_port::VirtualPort;
