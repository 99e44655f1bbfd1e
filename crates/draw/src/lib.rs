//! Drawings for the original Dobot Arm: SVG to strokes to vectors that arm and link can carry.
