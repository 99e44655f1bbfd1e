//! What can go wrong, in virtual time: each case gives its figures.

pub mod cables;
pub mod chance;
pub mod clients;
pub mod disks;
pub mod floods;
pub mod jobs;
pub mod kills;
pub mod lines;
pub mod paper;
pub mod scene;
pub mod spread;
pub mod stops;
