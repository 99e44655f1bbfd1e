//! The original Dobot Arm: units, poses, tools, limits, kinematics, and the tick of its controller.
//!
//! Angles are degrees and lengths millimetres everywhere; radians stay inside. `docs/kinematics.md`
//! shows the frames, the signs and the formulas with pictures.
//!
//! ```
//! use dobot_arm::{Joints, Limits, Tool, forward, inverse};
//!
//! let joints = Joints::new(30.0, 20.0, 25.0, -10.0);
//! let pose = forward(&joints, Tool::SuctionCup);
//! assert!((pose.rotation.0 - 20.0).abs() < 1e-9);
//!
//! let again = inverse(&pose, Tool::SuctionCup)?;
//! assert!((again.rear.0 - 20.0).abs() < 1e-9);
//!
//! Limits::STOCK.check(&again, Tool::SuctionCup)?;
//! # Ok::<(), dobot_arm::Unreachable>(())
//! ```

#![no_std]

mod agreement;
mod calibration;
mod joints;
mod kinematics;
mod limits;
mod plane;
mod pose;
mod position;
pub mod stock;
mod tick;
mod tool;
mod units;
mod unreachable;

pub use agreement::agrees;
pub use calibration::Calibration;
pub use joints::Joints;
pub use kinematics::{FOREARM, REAR_ARM, forward, inverse};
pub use limits::{Limits, Span};
pub use plane::Plane;
pub use pose::Pose;
pub use position::Position;
pub use tick::{TICK, TICK_S};
pub use tool::Tool;
pub use units::{Degrees, Millimeters};
pub use unreachable::{Quantity, Unreachable};
