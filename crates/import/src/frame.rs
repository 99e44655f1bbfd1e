//! The transform from a part of a file to the page.

use dobot_geometry::{Affine, Vec2};

/// Transforms a vector, which has no position.
pub(crate) fn way(frame: Affine, way: Vec2) -> Vec2 {
    (frame.with_translation(Vec2::ZERO) * way.to_point()).to_vec2()
}
