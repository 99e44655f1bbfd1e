//! Programs: their text, their effects in worlds, and the vendor's files.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod content;
mod decisions;
mod documents;
mod programs;
mod round_trip;
mod vendor;
mod worlds;
