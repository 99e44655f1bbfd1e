//! Drawings for the original Dobot Arm: SVG to strokes to vectors that arm and link can carry.

mod deviation;
mod index;
mod ink;
mod lookahead;
mod order;
mod place;
mod plan;
mod point;
mod prepare;
mod run;
mod simplify;
mod svg;

pub use deviation::{Deviation, Worst, deviation};
pub use ink::{ink, ink_seen};
pub use lookahead::{Cornering, Run};
pub use order::{order, travel_mm};
pub use place::{AREA, PlaceError, Placed, Placement, Size, check_reach};
pub use plan::{LinkRate, MoveKind, Pen, Plan, PlanError, PlannedVector, Summary};
pub use point::{Bounds, Point, Stroke};
pub use prepare::{PrepareError, Prepared, Settings, prepare};
pub use run::{Cause, Finished, Parting, Progress, Stopped, run};
pub use simplify::{MIN_VECTOR_MM, simplify};
pub use svg::{Drawing, Place, SvgError, SvgOptions, Warning, WarningKind};
pub use usvg::fontdb;
