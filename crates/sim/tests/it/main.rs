//! Virtual arms: alone, with a client, with faults, in their worlds; all in virtual time.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

#[cfg(feature = "world")]
mod burns;
#[path = "../common/mod.rs"]
mod common;
mod damage;
mod detection;
mod done;
mod faults;
mod laser;
mod light;
mod mixtures;
mod model;
mod pair;
mod recorder;
mod recordings;
mod report;
mod resets;
#[cfg(feature = "world")]
mod scenes;
mod scripts;
mod session;
mod traces;
#[cfg(feature = "world")]
mod world;
