//! Recordings: written, damaged, repaired, read and replayed.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod recorder;
mod recordings;
mod repairs;
mod repeats;
mod replays;
