//! Letters of single lines, and sheets on which lines, areas and words become an SVG picture that looks
//! the same with and without fonts.
//!
//! ```
//! use dobot_lettering::{Anchor, Frame, Look, Sheet, Type};
//!
//! let mut sheet = Sheet::new(Frame::between([0.0, 0.0], [60.0, 20.0]), "mm");
//! sheet.line([5.0, 15.0], [55.0, 15.0], &Look::line("#75838d", 0.3));
//! sheet.text([30.0, 12.0], Anchor::Middle, &Type::new(3.0, "#1b2a41"), "50 mm");
//! assert!(sheet.finish().contains("aria-label=\"50 mm\""));
//! ```

pub mod desk;
mod hershey;
mod letter;
mod look;
mod sheet;
mod smooth;
mod symbols;
mod words;

pub use self::hershey::{CAPITAL, Letter, StrokeFont};
pub use self::look::{Look, Type};
pub use self::sheet::{Frame, Sheet};
pub use self::words::{Anchor, strokes, width};
