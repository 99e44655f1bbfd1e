//! The safety policy: what no command of any client may do, and the check of every command over its
//! whole path before it is sent.
//!
//! A [`Policy`] is a TOML file, shipped with its default. [`Policy::check`] says where a command
//! leads, or which rule forbids it, where on the way, and what would be allowed. `docs/safety.md`
//! explains each rule, how the check works and what it does not promise.
//!
//! ```
//! use dobot_course::{Model, Place};
//! use dobot_safety::Policy;
//! use dobot_wire::{Command, Dialect, Status, WriteMode, WriteVector};
//!
//! let policy = Policy::from_toml("[table]\nz_mm = -103\n[tool_length]\nsuction_cup_mm = 90")?;
//! let status = Status {
//!     x_mm: 215.07, y_mm: 0.0, z_mm: 135.0, rotation_deg: 0.0, base_deg: 0.0, rear_deg: 0.0,
//!     fore_deg: 0.0, servo_deg: 0.0, suction: false, gripper_deg: 0.0,
//! };
//! let model = Model::new(Dialect::SPECIFICATION, &status);
//! let down = |z_mm| Command::from(WriteVector {
//!     mode: WriteMode::Writing, x_mm: 0.0, y_mm: 0.0, z_mm, laser: false,
//!     start_speed_mm_s: 0.0, end_speed_mm_s: 0.0, max_speed_mm_s: 40.0, stop: false,
//! });
//! assert!(policy.check(&model, &down(-100.0)).is_ok());
//!
//! let violation = policy.check(&model, &down(-160.0)).unwrap_err();
//! assert_eq!(violation.rule, "table");
//! # Ok::<(), dobot_safety::PolicyError>(())
//! ```

mod body;
mod bounds;
mod check;
mod fence;
mod jog;
mod laser;
mod limits;
mod path;
mod place;
mod policy;
mod policy_error;
mod sections;
mod settings;
mod sweep;
mod validate;
mod violation;
mod walk;
mod zone;

pub use bounds::Bounds;
pub use policy::Policy;
pub use policy_error::PolicyError;
pub use sections::{
    AccelerationCeilings, ArmBody, JogRules, JointLimits, JumpRules, LaserRules, QueueRules,
    SpeedCeilings, Table, ToolLengths, Workspace,
};
pub use violation::{Judged, Spot, Violation};
pub use zone::{Area, Cylinder, KeepOut};
