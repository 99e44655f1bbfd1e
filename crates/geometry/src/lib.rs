//! Points, strokes and areas in the plane, and what lies near what.
//!
//! ```
//! use dobot_geometry::{Point, Stroke, deviation};
//!
//! let wanted = Stroke::open(vec![Point::new(0.0, 0.0), Point::new(10.0, 0.0)]);
//! let drawn = Stroke::open(vec![Point::new(0.0, 0.1), Point::new(10.0, 0.1)]);
//! assert!((deviation(&[wanted], &[drawn]).largest_mm() - 0.1).abs() < 1e-9);
//! ```

mod area;
mod deviation;
mod point;
mod segment_index;

pub use area::{Area, FillRule};
pub use deviation::{Deviation, Near, Worst, deviation};
pub use point::{Bounds, Point, Stroke};
pub use segment_index::SegmentIndex;
