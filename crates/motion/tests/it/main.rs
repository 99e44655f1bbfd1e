//! Moves and their profiles (limits, continuity, ends), and the motion model.

mod model;
mod moves;
mod profile;
