//! The daemon that owns an arm's port and keeps people and arm safe.

mod arms;
mod bridge;
mod config;
mod connect;
#[cfg(test)]
mod double;
mod finder;
mod folders;
mod handle;
mod http;
mod jobs;
mod keeper;
mod owner;
mod program;
mod raw;
mod recording;
mod rehearsal;
mod remote;
mod running;
mod start;
#[cfg(unix)]
mod virtual_port;
mod words;

pub use config::{Config, DEFAULT_HTTP, DEFAULT_RAW, TlsFiles};
pub use finder::{Finder, FinderNews, Found, Missed, NothingFound, Reconnect, Search, WhereFound};
pub use folders::Folders;
pub use handle::{Client, Handle, Snapshot};
pub use http::{ServeError, Served, TlsError, Token, Tokens, TokensError, Web, serve};
pub use keeper::{Begun, Effect, JobPlan, Keeper};
pub use program::{ProgramNews, Traffic};
pub use raw::{RawPort, RawPortError};
pub use rehearsal::Rehearsal;
pub use remote::{
    ConnectError, Heard, Hello, Remote, RemoteError, StationAddress, StationAddressError, Trust,
    TrustError, fetch, fingerprint,
};
pub use running::{Running, RunningError};
pub use start::{StartError, Station};
#[cfg(unix)]
pub use virtual_port::VirtualPort;
pub use words::*;
