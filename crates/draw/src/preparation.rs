//! Cancellation and progress of a preparation, and the files it reads.

pub(crate) mod cancel;
pub(crate) mod program_files;
pub(crate) mod progress;
