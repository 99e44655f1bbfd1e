//! A Dobot Arm in ROS 2, without a ROS installation: the station's arm as a DDS node.
//!
//! It is a client of a station and has no direct connection to the arm: lease, policy, stop and
//! trust are the station's. It publishes joint states, transforms, diagnostics and the robot's
//! description, and accepts targets, jogs, a stop, and the actions `FollowJointTrajectory` and
//! `ParallelGripperCommand`.
//! `docs/ros2.md` has the list.
//!
//! A trajectory has more points than the arm's link can carry, so it is [`thinned`], and the
//! largest deviation is reported with its result:
//!
//! ```
//! use dobot_ros2::thinned;
//!
//! let points: Vec<[f64; 2]> = (0..=100).map(|n| [f64::from(n), (f64::from(n) / 50.0).powi(2)]).collect();
//! let thin = thinned(&points, &[], 0.1, 12, |_, _| 0.0);
//! assert!(thin.kept.len() <= 13 && thin.deviation <= 0.1);
//! ```

mod actions;
mod bridge;
mod buttons;
mod diagnostics;
mod follow_action;
mod follow_plan;
mod frames;
mod goal;
mod goals;
mod gripper_action;
mod jog;
mod joints;
mod log;
mod messages;
mod node;
mod parameters;
mod settings;
mod station;
mod target;
mod thin;
mod watch;

pub use bridge::run;
pub use node::NodeError;
pub use settings::{BadNamespace, Middleware, Settings, UnknownMiddleware, check_namespace};
pub use thin::{Thinned, thinned};
