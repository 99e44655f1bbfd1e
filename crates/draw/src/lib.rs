//! Strokes on the paper: what the readers of `dobot-source` give is placed, hatched, clipped, merged,
//! ordered and simplified, and planned by `dobot-plan`; then it is estimated, or shown as a picture.
//!
//! ```text
//!   source -> Artwork -> place -> hatch -> clip -> merge -> order -> simplify -> plan
//!
//!   wanted strokes + what the arm drew -> Trace, Picture
//! ```
//!
//! Everything here is pure: no files, no clock, no arm. [`prepare()`] goes the whole way:
//!
//! ```
//! use dobot_draw::{Settings, prepare};
//!
//! let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">
//!     <rect x="5" y="5" width="30" height="30" fill="none" stroke="black"/>
//! </svg>"#;
//! let anywhere = |_| Ok::<(), String>(());
//! let prepared = prepare(&svg.into(), &Settings::default(), anywhere)?;
//!
//! let summary = prepared.plan.summary();
//! assert_eq!(summary.strokes, 1);
//! assert_eq!(summary.drawn_mm.round(), 120.0);
//! # Ok::<(), dobot_draw::PrepareError>(())
//! ```
//!
//! # Tolerance
//!
//! Of the tolerance asked for, a tenth goes into reading curves and the rest into merging vectors,
//! so that together they keep it. Arcs come from the SVG reader as cubic curves, which lie within
//! 0.03 % of their radius; that share is part of the path wanted, as it is in a browser.

mod backlash;
mod calibrated;
mod card;
mod clip;
mod copies;
mod cutting;
mod doubles;
mod estimate;
mod export;
mod frame;
mod give_up;
mod hatch;
mod ink;
mod material;
mod merge;
mod offset;
mod options;
mod order;
mod picture;
mod place;
mod prepare;
mod preview;
mod program_files;
mod progress;
mod sheet;
mod simplify;
mod start;
mod timeline;
mod together;
mod trace;

pub use calibrated::known_paper;
pub use card::{Card, CardError};
pub use clip::{Clipped, clip_to_reach};
pub use copies::Grid;
pub use cutting::Cutting;
pub use dobot_source::{FORMATS, Format};
pub use estimate::{Estimate, PassFigures, ToolKind};
pub use export::{ExportFormat, export};
pub use frame::{FrameShape, frame};
pub use give_up::GiveUp;
pub use hatch::{Hatch, HatchError, HatchStyle, hatch};
pub use ink::{InkLine, ink_seen};
pub use material::{Material, MaterialError, Materials, UnknownMaterial};
pub use merge::merge;
pub use options::{
    Auto, ContentOptions, DrawingRequest, LayerTool, OPTION_RANGES, OptionRange, Options,
    OptionsError, PassesBy, PathOptions, PlaceOptions, Spacing, Subject, ToolOptions,
    WITHOUT_ARM_Z_MM,
};
pub use order::{Search, Travel, order};
pub use picture::{Colors, Picture, PictureError, View};
pub use place::{AREA, PlaceError, Placed, Placement, Size, check_reach};
pub use prepare::{
    NamedSource, PrepareError, Prepared, Settings, prepare, prepare_passes, prepare_together,
};
pub use program_files::ProgramFiles;
pub use progress::{PrepareStep, Progress};
pub use sheet::{PaperSize, SheetPlace};
pub use simplify::{MIN_VECTOR_MM, simplify, simplify_at};
pub use start::{StartError, StartFrom};
pub use timeline::{Moves, Path, Timeline};
pub use trace::{Sample, StartNotReached, Trace};
