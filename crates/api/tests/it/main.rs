//! The client of a station, from without.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod remote;
#[cfg(feature = "tls")]
mod tls;
#[cfg(not(feature = "tls"))]
mod without_tls;
