//! Speed profiles, the motions of the original Dobot Arm, and the motion that a command causes.
//!
//! # Motions
//!
//! Every motion is planned once and is then a pure function of the time in seconds since its start:
//! before 0 it returns its start, after its duration exactly its end. There is one type per kind of
//! path.
//!
//! | type | in the protocol | path |
//! |---|---|---|
//! | [`JointMove`] | MOVJ (Table 3.7) | all joints start and stop together |
//! | [`LineMove`] | MOVL (Table 3.7) | a straight line |
//! | [`Jump`] | JUMP (Table 3.7) | up, across, down (Figure 3.2) |
//! | [`Stroke`] | writing and laser vector (Table 2.6) | a straight line with a speed at each end |
//! | [`TickStroke`] | a vector on a stock arm | a straight line in whole ticks |
//! | [`Ramp`] | jog (Tables 3.5 and 2.5) | one axis until its release |
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

//! # Commands
//!
//! A [`Model`] holds the estimated state of an arm. It predicts the [`Trajectory`] of a
//! [`Command`](dobot_wire::Command), and the model after the command. Controller, client and safety
//! share this prediction. The differences between arms are fields of
//! [`Dialect`](dobot_wire::Dialect). A stock arm executes motions in ticks of 20 ms: each of its
//! motions ends up to one tick later than its trajectory, and deviates from it by up to one tick's
//! travel.
//!
//! ```
//! use dobot_motion::Model;
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

mod joint_move;
mod jump;
mod line_move;
mod model;
mod plan_error;
mod profile;
mod ramp;
mod return_wait;
mod speeds;
mod stroke;
mod tick_progress;
mod tick_stroke;
mod timing_law;

pub use joint_move::JointMove;
pub use jump::Jump;
pub use line_move::LineMove;
pub use model::{
    ArmPlace, ArmSettings, Button, HandAxis, HandScale, Interpolation, JogAxis, JogTrajectory,
    LASER_OFF, LONGEST_S, Model, Segment, Stretching, Trajectory, TrajectoryError, TurnBounds,
    burns, to_raw,
};
pub use plan_error::PlanError;
pub use profile::Profile;
pub use ramp::Ramp;
pub use return_wait::{ReturnWait, SAME_PLACE_MM};
pub use speeds::Speeds;
pub use stroke::{Stroke, StrokeSpeeds};
pub use tick_progress::TickProgress;
pub use tick_stroke::TickStroke;
