//! Results of a drawing: trace, statistics, pictures, previews and files for other programs.

pub(crate) mod estimate;
pub(crate) mod export;
pub(crate) mod ink;
pub(crate) mod picture;
pub(crate) mod preview;
pub(crate) mod timeline;
pub(crate) mod trace;
