//! The control of a preparation from another thread, and the files that it reads.

pub(crate) mod cancel;
pub(crate) mod program_files;
pub(crate) mod progress;
