//! What the API serves besides the arm itself.

pub(crate) mod drawings;
pub(crate) mod metrics;
pub(crate) mod page;
pub(crate) mod programs;
pub(crate) mod recordings;
