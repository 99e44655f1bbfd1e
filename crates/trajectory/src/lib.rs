//! Where a command leads the arm: the motion model that client, safety and controller share.
//!
//! A [`Model`] is what is believed of an arm. It says where a [`Command`](dobot_wire::Command) leads
//! from there, as a [`Trajectory`], and what is to be believed when the command is over. Nothing here
//! moves or waits: a trajectory is a pure function of the time in seconds since the command began.
//!
//! What differs between arms are fields of [`Dialect`](dobot_wire::Dialect). The motions are those
//! of the room `motion`; a stock arm, which goes tick by tick, is up to a tick of 20 ms for each
//! motion later, and on the way up to a tick's travel apart.
//!
//! ```
//! use dobot_trajectory::Model;
//! use dobot_wire::{Command, Dialect, MoveTo, MovingMode, Status};
//!
//! let status = Status::AT_ZERO;
//! let model = Model::new(Dialect::SPECIFICATION, &status);
//! let line = MoveTo::to(215.07, 0.0, 35.0).with_mode(MovingMode::MovL);
//! let down = Command::from(MoveTo { suction: true, pause_s: 0.5, ..line });
//! let trajectory = model.trajectory(&down)?;
//! // 100 mm at 50 mm/s with ramps of half a second, and the pause.
//! assert!((trajectory.duration_s().unwrap() - 3.0).abs() < 1e-9);
//! let half_way = trajectory.place_at(1.25)?;
//! assert!((half_way.pose.position.z.0 - 85.0).abs() < 1e-9);
//! assert!(model.after(&down, &trajectory).suction);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![no_std]

mod button;
mod calibrated;
mod error;
mod follow;
mod followed;
mod jog;
mod laser;
mod left_speed;
mod lifts;
mod model;
mod motion;
mod place;
mod plan;
mod segment;
mod settings;
mod status;
mod trajectory;
mod vector;

pub use button::{Button, JogAxis};
pub use calibrated::told;
pub use error::{LONGEST_S, TrajectoryError};
pub use jog::JogTrajectory;
pub use laser::{LASER_OFF, burns};
pub use model::Model;
pub use place::ArmPlace;
pub use segment::{Bend, Segment};
pub use settings::ArmSettings;
pub use trajectory::Trajectory;
