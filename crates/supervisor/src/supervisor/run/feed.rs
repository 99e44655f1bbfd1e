//! What a job sends next, and how far ahead of the journal it may be.

pub(crate) mod adjust;
pub(crate) mod cycles;
pub(crate) mod feeder;
pub(crate) mod permit;
pub(crate) mod speeds;
