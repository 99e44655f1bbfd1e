//! The keeper and a virtual arm, in virtual time: the rules for people and arm.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod arrivals;
mod bluetooth;
mod burns;
mod commands;
mod crashes;
mod drawing;
mod heights;
mod jobs;
mod jogs;
mod lasers;
mod leases;
mod links;
mod pauses;
mod people;
mod releases;
mod stalls;
mod stands;
mod stops;
mod strokes;
mod traps;
mod voices;
