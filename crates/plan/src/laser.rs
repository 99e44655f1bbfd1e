//! Planning of strokes for a laser.

pub(crate) mod burn;
pub(crate) mod laser_path;
pub(crate) mod slow_burning;
