//! The original Dobot Arm as a model for other programs: URDF, a configuration of MoveIt, MJCF (MuJoCo) and JSON.
//!
//! The model has the arm's links with both of its parallelograms and the crank that turns the forearm, and a tool. Its
//! lengths, limits and speeds are those of `dobot-arm` and `dobot-motion`, without the roundings of a stock arm. Its
//! frame `base` is the base frame (`docs/kinematics.md`), and its frame `tool` is at the reported pose, at the
//! height of the wrist. `docs/models.md` describes each format.
//!
//! ```
//! use dobot_arm::{Millimeters, Tool};
//! use dobot_model::{Model, MountedTool};
//!
//! let pen = MountedTool::new(Tool::Pen, Millimeters(62.0))?;
//! let model = Model::new(Some(pen));
//! assert!(model.to_urdf().contains(r#"<link name="tool">"#));
//! # Ok::<(), dobot_model::BadLength>(())
//! ```

mod collisions;
mod dimensions;
mod inertia;
mod joint;
mod json;
mod mjcf;
mod model;
mod mounted_tool;
mod moveit;
#[cfg(feature = "options")]
mod options;
mod part;
mod shape;
mod tree;
mod urdf;
mod xml;

pub use dimensions::Dimensions;
pub use model::Model;
pub use mounted_tool::{BadLength, MountedTool};
#[cfg(feature = "options")]
pub use options::{ToolOptions, ToolOptionsError};
pub use tree::LinkFrame;
