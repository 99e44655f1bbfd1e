//! The safety policy: what no client's command may do, and the check of every command over its
//! whole path before it is sent.
//!
//! A [`Policy`] is a TOML file with built-in defaults. [`Policy::check`] returns where a command
//! leads, or which rule forbids it, where on the path, and what is allowed. `docs/policy.md`
//! explains each rule, the check, and its limits.
//!
//! ```
//! use dobot_motion::{ArmPlace, Model};
//! use dobot_safety::Policy;
//! use dobot_wire::{Command, Dialect, Status, WriteVector};
//!
//! let policy = Policy::from_toml("[table]\nz_mm = -103\n[tool_length]\nsuction_cup_mm = 90")?;
//! let status = Status::AT_ZERO;
//! let model = Model::new(Dialect::SPECIFICATION, &status);
//! let down = |z_mm| Command::from(WriteVector::by(0.0, 0.0, z_mm, 40.0));
//! assert!(policy.check(&model, &down(-100.0)).is_ok());
//!
//! let violation = policy.check(&model, &down(-160.0)).unwrap_err();
//! assert_eq!(violation.rule, "table");
//! # Ok::<(), dobot_safety::PolicyError>(())
//! ```

mod body;
mod bounds;
mod check;
mod distance;
mod effective_rules;
mod jog;
mod keep_out;
mod keep_out_edit;
mod laser;
mod limits;
mod path;
mod path_check;
mod place;
mod policy;
mod policy_error;
mod sections;
mod settings;
mod swept_path;
mod text_lines;
mod validate;
mod violation;

pub use bounds::Bounds;
pub use keep_out::{Area, Cylinder, KeepOut};
pub use keep_out_edit::KeepOutEdit;
pub use policy::Policy;
pub use policy_error::PolicyError;
pub use sections::{
    AccelerationCeilings, ArmBody, JogRules, JointLimits, JumpRules, LaserRules, QueueRules,
    SpeedCeilings, Table, ToolLengths, VoiceRules, Workspace,
};
pub use text_lines::{line_at, line_of};
pub use violation::{Location, RejectedValue, Violation};
