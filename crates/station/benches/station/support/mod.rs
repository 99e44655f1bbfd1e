//! Shared parts of the station's benchmarks: an arm at a serial port that records arrival times, a
//! station in a separate process, clients.

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

/// Whether to measure: `cargo test` runs benchmarks without the argument, as smoke tests.
pub(crate) fn is_measuring() -> bool {
    std::env::args().any(|word| word == "--bench")
}
