//! Packets: what they mean, and what damage costs.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod commands;
mod damage;
#[cfg(feature = "serde")]
mod vectors;
