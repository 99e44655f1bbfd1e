//! Recordings as tables.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod export;
