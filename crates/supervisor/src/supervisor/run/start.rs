//! How a job starts and resumes.

pub(crate) mod approach;
pub(crate) mod started_job;
