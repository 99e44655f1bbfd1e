//! From areas and lines to strokes: filled, joined, without duplicates, in order, and with few
//! vectors.

pub(crate) mod cutting;
pub(crate) mod duplicate_lines;
pub(crate) mod hatch;
pub(crate) mod merge;
pub(crate) mod offset;
pub(crate) mod order;
pub(crate) mod simplify;
