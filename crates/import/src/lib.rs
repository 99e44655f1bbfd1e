//! Reading files, pictures and texts as lines and areas to draw.
//!
//! Every reader returns layers of strokes and areas in millimetres of a page. Unreadable input is
//! an error with place, found and allowed values; content that a pen cannot show is a warning.
//!
//! ```
//! use dobot_import::{ReadOptions, Source};
//!
//! let file = b"x,y\n0,0\n30,0\n30,40\n".to_vec();
//! let (artwork, warnings) = Source::of_file("lines.csv", file)?.read(&ReadOptions::default())?;
//! assert_eq!(artwork.layers[0].strokes[0].length_mm(), 70.0);
//! assert!(warnings.is_empty());
//! # Ok::<(), dobot_import::SourceError>(())
//! ```

mod arc;
mod artwork;
mod clip;
mod dash;
mod dxf;
mod encoding;
mod error;
mod fonts;
mod foreign;
mod formats;
mod frame;
mod gcode;
mod hidden;
mod hpgl;
mod lightburn;
mod limits;
mod number;
mod options;
mod packed;
mod picture;
mod place;
mod points;
mod sketch;
mod source;
mod stack;
mod svg;
mod text;
mod warning;
mod xml;

pub use artwork::{Artwork, Layer};
pub use dobot_shading::{Shading, ShadingStyle};
pub use error::{ImageError, SourceError, SvgError, TextError};
pub use fonts::system_fonts;
pub use formats::{Contents, FORMATS, Format};
pub use options::{GcodeTool, LayersBy, ReadOptions};
pub use place::Place;
pub use source::Source;
pub use text::{Align, Font, StrokeFont, Text, Wrap};
pub use usvg::fontdb;
pub use warning::{Warning, WarningKind};
