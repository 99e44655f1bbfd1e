//! The rules, with virtual arms in virtual time.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod cases;
mod faults;
mod running;
mod supervisor;
mod twin;
