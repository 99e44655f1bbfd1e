//! Coordinated programs: one program for several arms, with parts that wait for each other at
//! barriers.
//!
//! ```text
//!   document --> parts --> check ----> problems, before anything moves
//!                  |
//!                  +-----> rehearse    all arms in virtual time, on one clock    \
//!                  |                                                              engine: waiting and holding parts
//!                  '-----> run         the stations of a fleet, through their own API /
//! ```

mod barriers;
mod check;
mod document;
mod engine;
mod observation;
mod part;
mod rehearse;
mod run;
#[cfg(test)]
mod tests;

pub use check::check;
pub use document::{DocumentError, PartOf, Together};
pub use engine::EngineEvent;
pub use part::Part;
pub use rehearse::{BarrierTime, PartTime, Rehearsal, RehearseError, Wait, rehearse};
pub use run::{Home, Order, Outcome, RunError, RunEvent, run};
