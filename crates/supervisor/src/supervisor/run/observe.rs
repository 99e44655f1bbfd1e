//! What the statuses say of a job: progress, gripped parts, commands that were lost, and its end.

pub(crate) mod asking;
pub(crate) mod grip_check;
pub(crate) mod progress;
pub(crate) mod resend;
pub(crate) mod rest;
