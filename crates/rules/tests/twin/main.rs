//! Plans carried out by a virtual arm in this process, in virtual time.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod bench;
mod breaks;
mod calibrated;
mod lasers;
mod policy;
mod traces;
mod true_places;
