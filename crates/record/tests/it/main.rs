//! Recordings: writing, damage, repair, reading and replay.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

#[cfg(feature = "parquet")]
mod export;
#[cfg(feature = "protobuf")]
mod protobuf;
mod recorder;
mod recordings;
mod repairs;
mod repeats;
mod replays;
