//! The web server.

pub(crate) mod listen;
pub(crate) mod server;
