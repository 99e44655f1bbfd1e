//! The options by which a program is told what is mounted.

use dobot_arm::{Millimeters, Tool};

use crate::mounted_tool::{BadLength, MountedTool, ToolKind};

/// What is mounted, as the options of a program say it.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct ToolOptions {
    /// What is mounted
    #[arg(long, value_enum, default_value_t = Mounted::Cup)]
    tool: Mounted,
    /// How far the tip of the tool hangs below the wrist, in mm: 20 to 200; else as in the default policy
    #[arg(long, value_name = "MM")]
    length: Option<f64>,
}

/// Why nothing of the kind can be mounted.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ToolOptionsError {
    /// There is no tool that could be so long.
    #[error("--length is given without a tool; only a tool has a length")]
    NoTool,
    /// No tool is so long.
    #[error(transparent)]
    Length(#[from] BadLength),
}

impl ToolOptionsError {
    /// What to do about it.
    #[must_use]
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NoTool => Some("`--tool pen` mounts one"),
            Self::Length(_) => None,
        }
    }
}

impl ToolOptions {
    /// The tool, if one is mounted; where no length is told, it is as usual for that tool, in mm.
    ///
    /// # Errors
    ///
    /// [`ToolOptionsError`].
    pub fn mounted(
        &self,
        usual: impl FnOnce(Tool) -> f64,
    ) -> Result<Option<MountedTool>, ToolOptionsError> {
        let Some(kind) = self.tool.kind() else {
            return match self.length {
                None => Ok(None),
                Some(_) => Err(ToolOptionsError::NoTool),
            };
        };
        let length = self.length.unwrap_or_else(|| usual(kind.tool()));
        Ok(Some(MountedTool::new(kind, Millimeters(length))?))
    }
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Mounted {
    None,
    Cup,
    Gripper,
    Pen,
    Laser,
}

impl Mounted {
    const fn kind(self) -> Option<ToolKind> {
        match self {
            Self::None => None,
            Self::Cup => Some(ToolKind::SuctionCup),
            Self::Gripper => Some(ToolKind::Gripper),
            Self::Pen => Some(ToolKind::Pen),
            Self::Laser => Some(ToolKind::Laser),
        }
    }
}
