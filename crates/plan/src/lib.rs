//! Strokes to vectors that arm and link can carry.
//!
//! A [`Plan`] has every vector with its speeds: the pen goes up and down, a laser runs up and out, the
//! speeds look ahead, and each vector lasts as long as the link needs for the next. A long vector comes in pieces. [`respeed`] makes
//! the speeds of a chain of vectors anew when a job goes on in its middle.
//!
//! ```
//! use dobot_geometry::{Point, Stroke};
//! use dobot_plan::{DrawingTool, Machine, Paper, Pass, Pen, Plan};
//! use dobot_wire::Dialect;
//!
//! let line = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(240.0, 0.0)]);
//! let pass = Pass::new(DrawingTool::Pen(Pen::default()), vec![line]);
//! let plan = Plan::new(&[pass], &Paper::level(-40.0), &Machine::of(Dialect::SPECIFICATION))?;
//! assert_eq!(plan.summary().vectors, 7); // lower, draw in five pieces, lift
//! # Ok::<(), dobot_plan::PlanError>(())
//! ```

mod acceleration;
mod aim;
mod around;
mod burn;
mod chain;
mod commands;
mod error;
mod in_ticks;
mod joints;
mod landing;
mod laser_path;
mod link;
mod lone;
mod lookahead;
mod machine;
mod motion;
mod pace;
mod paper;
mod pass;
mod pieces;
mod plan;
mod planner;
mod respeed;
mod rest_each;
mod seen;
mod slow_burning;
mod speeds;
mod summary;
mod tick;
mod tick_chain;
mod tick_fit;
mod ticker;
mod tool;
mod vector;

pub use acceleration::acceleration;
pub use around::around_axis;
pub use error::PlanError;
pub use laser_path::{DOT_MM, LEAST_BURN_MM, burned_corners};
pub use lookahead::{ChainVector, Cornering, Junction};
pub use machine::{LinkRate, Machine};
pub use motion::Motion;
pub use pace::Pace;
pub use paper::{Paper, PaperError};
pub use pass::{Break, Pass, PlannedPass};
pub use pieces::{LONGEST_BURN_S, LONGEST_DRAW_S};
pub use plan::Plan;
pub use respeed::{RespeedStart, end_speed_mm_s, respeed};
pub use rest_each::rest_each;
pub use slow_burning::SlowBurning;
pub use summary::Summary;
pub use tick_fit::LEAST_BURN_MM_S;
pub use tool::{DrawingTool, Laser, Pen};
pub use vector::{MoveKind, PlannedVector};
