//! The daemon that owns an arm's port and keeps people and arm safe.

mod arms;
mod config;
mod folders;
mod handle;
mod jobs;
mod keeper;
mod rehearsal;
mod remote;
mod http;
mod running;
mod words;

pub use config::{Config, DEFAULT_HTTP, DEFAULT_RAW, TlsFiles};
pub use folders::Folders;
pub use handle::{Client, Handle, Snapshot};
pub use keeper::{Begun, Effect, JobPlan, Keeper};
pub use rehearsal::Rehearsal;
pub use remote::{
    ConnectError, Heard, Hello, Remote, RemoteError, StationAddress, StationAddressError, Trust,
    TrustError, fetch, fingerprint,
};
pub use http::{ServeError, Served, TlsError, Token, Tokens, TokensError, Web, serve};
pub use running::{Running, RunningError};
mod bridge;
#[cfg(test)]
mod double;
mod finder;
mod handle;
mod program;
mod raw;
#[cfg(unix)]
mod virtual_port;
mod words;

pub use finder::{Finder, FinderNews, Found, Missed, NothingFound, Reconnect, Search, WhereFound};
pub use handle::{Client, Handle, Snapshot};
pub use program::{ProgramNews, Traffic};
pub use raw::{DEFAULT_RAW, RawPort, RawPortError};
#[cfg(unix)]
pub use virtual_port::VirtualPort;
pub use words::*;
