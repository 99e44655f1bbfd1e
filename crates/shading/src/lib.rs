//! Pictures as lines or dots.
//!
//! ```text
//!   grey pixels -> tones on a grid -> full range -> outline, lines, stipple or hatch
//!                  (resample, tone)   (levels)      (contour)(waves)          (rows)
//! ```
//!
//! ```
//! use dobot_geometry::{CancelToken, Point};
//! use dobot_shading::{GreyPicture, Orientation, Shading, ShadingStyle};
//!
//! let pixels: Vec<u8> = (0..100).map(|i| if i % 10 < 5 { 0 } else { 255 }).collect();
//! let picture = GreyPicture {
//!     pixels: &pixels,
//!     width: 10,
//!     height: 10,
//!     page: Point::new(40.0, 40.0),
//!     orientation: Orientation::default(),
//! };
//! let shading = Shading::new(ShadingStyle::Lines);
//! let lines = shading.strokes(&picture, 1.0, &CancelToken::default())?;
//! assert!(lines.iter().all(|line| line.points.iter().all(|p| p.x < 21.0)));
//! # Ok::<(), dobot_geometry::Cancelled>(())
//! ```

mod contour;
mod flow;
mod hatch;
mod levels;
mod outline;
mod picture;
mod resample;
mod rows;
mod shading;
mod smooth;
mod spiral;
mod stipple;
mod tone;
mod waves;

pub use picture::{GreyPicture, Orientation};
pub use shading::{Shading, ShadingError, ShadingStyle};

#[cfg(test)]
mod tests;
