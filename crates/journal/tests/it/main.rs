//! The journal on disks that fail, fill up and lose their power.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod damage;
mod full_disk;
mod kill;
mod lab;
mod offers;
mod power_cut;
mod recovery;
mod resume;
mod store;
