//! From strokes to vectors: the paths of the tool, where they end, and how they are divided.

pub(crate) mod commands;
pub(crate) mod detour;
pub(crate) mod endpoint;
pub(crate) mod pieces;
pub(crate) mod planner;
pub(crate) mod travel;
pub(crate) mod vector;
