//! From artwork to a drawing: artwork read by `dobot-import` is placed, hatched, clipped, merged,
//! ordered and simplified, planned by `dobot-plan`, and then estimated or shown as a picture.
//!
//! ```text
//!   source -> Artwork -> place -> hatch -> clip -> merge -> order -> simplify -> plan
//!
//!   wanted strokes + what the arm drew -> Trace, Picture
//! ```
//!
//! All functions are pure: no files, no clock, no arm. [`prepare()`] runs all steps:
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
//! A tenth of the tolerance is used for reading curves and the rest for merging vectors, so that
//! both together keep it. The SVG reader converts arcs to cubic curves within 0.03 % of their
//! radius; that deviation is part of the wanted path, as in a browser.

mod arm;
mod layout;
mod material;
mod options;
mod output;
mod preparation;
mod prepare;
mod strokes;

pub use arm::calibrated::known_paper;
pub use arm::resume_point::{ResumePoint, ResumePointError};
pub use dobot_geometry::CancelToken;
pub use dobot_import::{Contents, FORMATS, Format};
pub use layout::clip::{Clipped, clip_to_reach};
pub use layout::copies::Grid;
pub use layout::frame::{FrameShape, frame};
pub use layout::marks::Marks;
pub use layout::place::{AREA, PlaceError, Placed, Placement, Size, check_reach};
pub use layout::sheet::{PaperSize, SheetPlace};
pub use layout::test_card::{Card, CardError};
pub use material::{Material, MaterialError, Materials, UnknownMaterial};
pub use options::{
    Auto, ContentOptions, DrawingRequest, LayerTool, OPTION_RANGES, OptionRange, Options,
    OptionsError, PassesBy, PathOptions, PlaceOptions, Spacing, Subject, ToolOptions,
    WITHOUT_ARM_Z_MM,
};
pub use output::estimate::{Estimate, PassFigures};
pub use output::export::{ExportFormat, export};
pub use output::ink::{InkLine, ink_seen};
pub use output::picture::{Colors, Picture, PictureError, View};
pub use output::timeline::{Moves, Path, Timeline};
pub use output::trace::{Sample, StartNotReached, Trace};
pub use preparation::program_files::ProgramFiles;
pub use preparation::progress::{PrepareStep, Progress};
pub use prepare::{
    NamedSource, PrepareError, Prepared, Settings, prepare, prepare_multi_file, prepare_passes,
};
pub use strokes::cutting::Cutting;
pub use strokes::hatch::{Hatch, HatchError, HatchStyle, hatch};
pub use strokes::merge::merge;
pub use strokes::order::{Search, Travel, order};
pub use strokes::simplify::{MIN_VECTOR_MM, simplify, simplify_at};
