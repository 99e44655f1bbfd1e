//! The progress of a preparation, and the files it reads.

pub(crate) mod program_files;
pub(crate) mod progress;
