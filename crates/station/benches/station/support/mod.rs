//! What the station's benchmarks share: an arm at a serial port that notes when packets arrive, a
//! station in a process of its own, clients.

mod arm;
mod client;
mod commands;
mod crowd;
mod station;
mod times;

pub(crate) use arm::{Arm, CountingArm, Port};
pub(crate) use client::WebSocket;
pub(crate) use commands::{START, vector};
pub(crate) use crowd::{Crowd, Watched};
pub(crate) use station::{StationProcess, serve};
pub(crate) use times::{Times, cpu_time, load};

/// Whether numbers are wanted: `cargo test` runs benchmarks without the word, to see that they
/// work.
pub(crate) fn is_measuring() -> bool {
    std::env::args().any(|word| word == "--bench")
}
