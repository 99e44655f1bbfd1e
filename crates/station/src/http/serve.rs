//! The web server: it takes connections and lets them go.

pub(crate) mod listen;
pub(crate) mod server;
