//! The keeper and a virtual arm, in virtual time: the rules for people and arm.

mod crashes;
mod drawing;
mod jobs;
mod jogs;
mod lasers;
mod leases;
mod links;
mod stops;
