//! Programs: their text, what they do in their worlds, and files of the vendor.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod documents;
mod programs;
mod round_trip;
mod vendor;
mod worlds;
