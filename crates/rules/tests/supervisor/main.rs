//! The supervisor and a virtual arm, in virtual time: the rules for people and arm.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod arrivals;
mod bluetooth;
mod burns;
#[path = "../../examples/reliability/cases/carries.rs"]
#[expect(dead_code, reason = "the figures of reliability use all of it")]
mod carries;
#[path = "../../examples/reliability/cases/chance.rs"]
#[expect(dead_code, reason = "the figures of reliability use all of it")]
mod chance;
mod commands;
mod crashes;
mod cycles;
mod drawing;
mod hands;
mod heights;
mod jobs;
mod jogs;
mod lasers;
mod leases;
#[path = "../../../sim/tests/light/mod.rs"]
mod light;
mod links;
mod pauses;
mod people;
mod policies;
mod programs;
mod releases;
mod slots;
mod stalls;
mod stands;
mod stops;
mod strokes;
mod traps;
mod voices;
mod ways;
