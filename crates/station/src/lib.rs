//! The daemon that owns an arm's port and keeps people and arm safe.

mod handle;
mod words;

pub use handle::{Client, Handle, Snapshot};
pub use words::*;
