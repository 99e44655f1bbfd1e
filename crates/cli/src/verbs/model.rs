//! `dobot model`: the arm as a model for other programs.

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::ValueEnum;
use dobot_arm::Millimeters;
use dobot_model::{Model, MountedTool, ToolKind};
use dobot_safety::Policy;

use crate::failure::Failure;
use crate::output;

/// Print the arm as a model for other programs: URDF, MJCF (MuJoCo) or JSON
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot model > dobot_arm.urdf                    the arm with a suction cup, for ROS, RViz and MoveIt
  dobot model --format mjcf --tool gripper -o .   dobot_arm.xml for MuJoCo
  dobot model --format json --tool pen --length 62
  dobot model --tool none                         up to the wrist, for a tool of your own

URDF and MJCF are in metres and radians, JSON in mm and degrees. Nobody has measured masses and forces.")]
pub(crate) struct Args {
    /// The format
    #[arg(long, value_enum, default_value_t = Format::Urdf)]
    format: Format,
    /// What is mounted
    #[arg(long, value_enum, default_value_t = Mounted::Cup)]
    tool: Mounted,
    /// How far the tip of the tool hangs below the wrist, in mm: 20 to 200; else as in the default policy
    #[arg(long, value_name = "MM")]
    length: Option<f64>,
    /// Write to this file, or to `dobot_arm` with the ending of the format in this folder
    #[arg(short, long, value_name = "FILE|FOLDER")]
    out: Option<PathBuf>,
    /// Write over a file that is there
    #[arg(long, requires = "out")]
    force: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    Urdf,
    Mjcf,
    Json,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Mounted {
    None,
    Cup,
    Gripper,
    Pen,
    Laser,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let model = Model::new(args.mounted()?);
    let text = match args.format {
        Format::Urdf => model.to_urdf(),
        Format::Mjcf => model.to_mjcf(),
        Format::Json => model.to_json(),
    };
    match &args.out {
        None => Ok(output::bytes(text.as_bytes())?),
        Some(out) => output::file(&args.format.file(out), text.as_bytes(), args.force),
    }
}

impl Args {
    fn mounted(&self) -> Result<Option<MountedTool>, Failure> {
        let Some(kind) = self.tool.kind() else {
            return match self.length {
                None => Ok(None),
                Some(_) => Err(Failure::new(
                    anyhow!("--length is given without a tool; only a tool has a length"),
                    "`--tool pen` mounts one",
                )),
            };
        };
        let lengths = Policy::default().tool_length;
        let length = self.length.unwrap_or_else(|| lengths.of(kind.tool()));
        Ok(Some(MountedTool::new(kind, Millimeters(length))?))
    }
}

impl Format {
    /// The file that is meant.
    fn file(self, out: &Path) -> PathBuf {
        if !out.is_dir() {
            return out.to_owned();
        }
        out.join(match self {
            Self::Urdf => "dobot_arm.urdf",
            Self::Mjcf => "dobot_arm.xml",
            Self::Json => "dobot_arm.json",
        })
    }
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
