//! Points, strokes and areas in the plane, spatial indexes, and pseudo-random numbers.
//!
//! ```
//! use dobot_geometry::{Point, Stroke, deviation};
//!
//! let wanted = Stroke::open(vec![Point::new(0.0, 0.0), Point::new(10.0, 0.0)]);
//! let drawn = Stroke::open(vec![Point::new(0.0, 0.1), Point::new(10.0, 0.1)]);
//! assert!((deviation(&[wanted], &[drawn]).largest_mm() - 0.1).abs() < 1e-9);
//! ```

mod area;
mod bounds;
mod box_tree;
mod cancel;
mod chord;
mod curve;
mod deviation;
mod direction;
mod height_map;
mod linear;
#[cfg(feature = "polygons")]
mod polygons;
mod random;
mod segment_index;
mod stroke;

pub use area::{Area, FillRule, edges};
pub use bounds::{bounds, bounds_of_strokes, least_width};
pub use box_tree::BoxTree;
pub use cancel::{CancelToken, Cancelled};
pub use chord::distance_from_chord;
pub use curve::{chords, corners};
pub use deviation::{Deviation, PathDistance, WorstPoint, deviation};
pub use direction::direction;
pub use height_map::HeightMap;
pub use linear::{inverse, solve};
#[cfg(feature = "polygons")]
pub use polygons::Polygons;
pub use random::Random;
pub use segment_index::SegmentIndex;
pub use stroke::{Stroke, steps};

/// The basic types of all crates, in millimetres and radians. On the sheet, x points right and y
/// down, as in an SVG file; in the base frame, x points forward and y to the left (Figure 3.1).
pub use kurbo::{Affine, Point, Rect, Vec2};
/// Segments with nearest-point queries, and curves.
pub use kurbo::{CubicBez, Line, ParamCurve, ParamCurveNearest, QuadBez};
