//! Planning of strokes as vectors within the limits of arm and link.
//!
//! A [`Plan`] contains every vector with its speeds, including pen lifts and the run-up and run-out
//! of a laser. Speeds are planned with look-ahead, and each vector lasts as long as the link needs
//! for the next. Long vectors are divided. [`respeed`] replans the speeds of a chain when a job
//! resumes within it.
//!
//! ```
//! use dobot_geometry::{Point, Stroke};
//! use dobot_plan::{DrawingTool, ArmLimits, Paper, Pass, Pen, Plan};
//! use dobot_wire::Dialect;
//!
//! let line = Stroke::open(vec![Point::new(200.0, 0.0), Point::new(240.0, 0.0)]);
//! let pass = Pass::new(DrawingTool::Pen(Pen::default()), vec![line]);
//! let plan = Plan::new(&[pass], &Paper::level(-40.0), &ArmLimits::of(Dialect::SPECIFICATION))?;
//! assert_eq!(plan.summary().vectors, 7); // lower, draw in five pieces, lift
//! # Ok::<(), dobot_plan::PlanError>(())
//! ```

mod arm_limits;
mod error;
mod laser;
mod paper;
mod pass;
mod path;
mod plan;
mod speed;
mod summary;
mod ticks;
mod tool;

pub use arm_limits::{ArmLimits, LinkRate};
pub use error::PlanError;
pub use laser::laser_path::{DOT_MM, MIN_BURN_MM, burned_corners};
pub use laser::slow_burning::SlowBurning;
pub use paper::{Paper, PaperError};
pub use pass::{Break, Pass, PlannedPass};
pub use path::detour::detour;
pub use path::pieces::{LONGEST_BURN_S, LONGEST_DRAW_S};
pub use path::vector::{MoveKind, PlannedVector};
pub use plan::Plan;
pub use speed::acceleration::acceleration;
pub use speed::duration_estimate::DurationEstimator;
pub use speed::lookahead::{ChainVector, Cornering, Junction};
pub use speed::motion::Motion;
pub use speed::respeed::{RespeedStart, end_speed_mm_s, respeed};
pub use summary::Summary;
pub use ticks::stop_each::stop_each;
pub use ticks::tick_fit::MIN_BURN_MM_S;
pub use tool::{DrawingTool, Laser, Pen};
