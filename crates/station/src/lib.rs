//! The daemon that owns an arm's port and keeps people and arm safe.

mod config;
mod folders;
mod arms;
mod handle;
pub mod keeper;
mod jobs;
mod rehearsal;
mod remote;
mod running;
mod words;

pub use config::{Config, DEFAULT_HTTP, DEFAULT_RAW, TlsFiles};
pub use folders::Folders;
pub use handle::{Client, Handle, Snapshot};
pub use remote::{
    ConnectError, Heard, Hello, Remote, RemoteError, StationAddress, StationAddressError, Trust,
    TrustError, fetch, fingerprint,
};
pub use running::{Running, RunningError};
pub use words::*;
