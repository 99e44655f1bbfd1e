//! Tests of moves and their profiles (limits, continuity, ends), and of the motion model.

mod model;
mod moves;
mod profile;
