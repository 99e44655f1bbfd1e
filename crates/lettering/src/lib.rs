//! Single-stroke lettering, and sheets that draw lines, areas and words as SVG without relying on
//! fonts.
//!
//! ```
//! use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};
//!
//! let mut sheet = Sheet::new(Rectangle::between([0.0, 0.0], [60.0, 20.0]), "mm");
//! sheet.line([5.0, 15.0], [55.0, 15.0], &ShapeStyle::line("#75838d", 0.3));
//! sheet.text([30.0, 12.0], Anchor::Middle, &TextStyle::new(3.0, "#1b2a41"), "50 mm");
//! assert!(sheet.finish().contains("aria-label=\"50 mm\""));
//! ```

mod hershey;
mod letter;
pub mod paper_style;
mod sheet;
mod smooth;
mod style;
mod symbols;
mod words;

pub use self::hershey::{CAPITAL, Letter, StrokeFont};
pub use self::sheet::{Rectangle, Sheet};
pub use self::style::{ShapeStyle, TextStyle};
pub use self::words::{Anchor, strokes, width};
