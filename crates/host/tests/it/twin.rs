//! Plans carried out by a virtual arm in this process, in virtual time.

mod bench;
mod breaks;
mod calibrated;
mod durations;
mod lasers;
mod policy;
mod timed_jogs;
mod traces;
mod true_places;
