//! What the tests of the program have in common.

#![allow(dead_code, reason = "each test target uses its part")]

pub(crate) mod api;
pub(crate) mod arm;
pub(crate) mod bench;
#[cfg(unix)]
pub(crate) mod full_pipe;
#[cfg(target_os = "linux")]
pub(crate) mod keys;
pub(crate) mod program;
pub(crate) mod running_process;
pub(crate) mod spiral;
#[cfg(target_os = "linux")]
pub(crate) mod terminal;
#[cfg(unix)]
pub(crate) mod trouble;
pub(crate) mod up;
pub(crate) mod wire;

/// How long anything may take on a busy machine.
pub(crate) const PATIENCE: std::time::Duration = std::time::Duration::from_secs(120);
