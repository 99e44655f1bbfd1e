//! Speed profiles and the ways in which the original Dobot Arm moves.
//!
//! Every motion is planned once and is then a pure function of the time in seconds since its
//! start: before 0 it stands at its start, after its duration exactly at its end. Which way to
//! move is the caller's choice; there is one type for each.
//!
//! | type | the protocol calls it | moves along |
//! |---|---|---|
//! | [`JointMove`] | MOVJ (Table 3.7) | all joints start and stop together |
//! | [`LineMove`] | MOVL (Table 3.7) | a straight line |
//! | [`Jump`] | JUMP (Table 3.7) | up, across, down (Figure 3.2) |
//! | [`Stroke`] | writing and laser vector (Table 2.6) | a straight line with a speed at each end |
//! | [`Cut`] | the same on a stock arm | the same, in whole ticks |
//! | [`Ramp`] | jog (Tables 3.5 and 2.5) | one axis, until told otherwise |
//!
//! ```
//! use dobot_arm::{Degrees, Pose, Position};
//! use dobot_motion::{LineMove, Speeds};
//!
//! let from = Pose { position: Position::new(200.0, -50.0, 0.0), rotation: Degrees(0.0) };
//! let to = Pose { position: Position::new(200.0, 50.0, 0.0), rotation: Degrees(30.0) };
//! let line = LineMove::new(from, to, &Speeds::STOCK)?;
//!
//! assert_eq!(line.duration_s(), 1.5); // 100 mm at 100 mm/s, and half a second more for the ramps
//! assert_eq!(line.pose_at(0.75).position, Position::new(200.0, 0.0, 0.0));
//! assert_eq!(line.pose_at(9.0), to);
//! # Ok::<(), dobot_motion::PlanError>(())
//! ```

#![no_std]

mod cut;
mod gait;
mod joint_move;
mod jump;
mod line_move;
mod pace;
mod plan_error;
mod profile;
mod ramp;
mod speeds;
mod stroke;

pub use cut::Cut;
pub use gait::Gait;
pub use joint_move::JointMove;
pub use jump::Jump;
pub use line_move::LineMove;
pub use plan_error::PlanError;
pub use profile::Profile;
pub use ramp::Ramp;
pub use speeds::Speeds;
pub use stroke::{Stroke, StrokeSpeeds};
