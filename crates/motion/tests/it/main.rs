//! Moves and their profiles: limits, continuity, where they end.

mod moves;
mod profile;
