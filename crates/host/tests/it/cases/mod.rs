//! Failure cases in virtual time, each with its figures.

pub(crate) mod cables;
#[allow(
    dead_code,
    reason = "tests ask less of it than the example of its name"
)]
pub(crate) mod carries;
pub(crate) mod chance;
pub(crate) mod clients;
pub(crate) mod commands;
pub(crate) mod disks;
pub(crate) mod floods;
#[allow(
    dead_code,
    reason = "tests ask less of it than the example of its name"
)]
pub(crate) mod fuzz;
pub(crate) mod jobs;
pub(crate) mod kills;
#[path = "../../../../sim/tests/it/light.rs"]
pub(crate) mod light;
pub(crate) mod lines;
pub(crate) mod long_lines;
pub(crate) mod paper;
pub(crate) mod scene;
pub(crate) mod sessions;
pub(crate) mod spread;
pub(crate) mod standing_laser;
pub(crate) mod stops;
pub(crate) mod watchdogs;
