//! How a job begins and resumes.

pub(crate) mod approach;
pub(crate) mod started_job;
