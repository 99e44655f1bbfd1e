//! The supervisor and a virtual arm, in virtual time: the rules for people and arm.

mod arrivals;
mod bluetooth;
mod burns;
mod crashes;
mod cycles;
mod drawing;
mod hands;
mod heights;
mod jobs;
mod jogs;
mod lasers;
mod leases;
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
