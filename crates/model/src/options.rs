//! The options for the mounted tool.

use std::iter;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use dobot_arm::{Millimeters, Tool};

use crate::mounted_tool::{BadLength, MountedTool};

/// The mounted tool, as command line options.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct ToolOptions {
    /// Mounted tool
    #[arg(long, value_parser = values(), default_value = Tool::SuctionCup.short())]
    tool: Mounted,
    /// Length of the tool below the wrist, 20 to 200 mm (default: as in the default policy)
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
    /// A hint for the user.
    #[must_use]
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NoTool => Some("`--tool pen` mounts one"),
            Self::Length(_) => None,
        }
    }
}

impl ToolOptions {
    /// The mounted tool; its default length is that of the kind of tool, in mm.
    ///
    /// # Errors
    ///
    /// [`ToolOptionsError`].
    pub fn mounted(
        &self,
        usual: impl FnOnce(Tool) -> f64,
    ) -> Result<Option<MountedTool>, ToolOptionsError> {
        let Some(kind) = self.tool.0 else {
            return match self.length {
                None => Ok(None),
                Some(_) => Err(ToolOptionsError::NoTool),
            };
        };
        let length = self.length.unwrap_or_else(|| usual(kind));
        Ok(Some(MountedTool::new(kind, Millimeters(length))?))
    }
}

/// A tool, or none.
#[derive(Clone, Copy, Debug)]
struct Mounted(Option<Tool>);

/// The values of `--tool`.
fn values() -> impl TypedValueParser<Value = Mounted> {
    let names = iter::once(NONE).chain(Tool::ALL.map(Tool::short));
    PossibleValuesParser::new(names).map(|name| Mounted(Tool::named(&name)))
}

const NONE: &str = "none";
