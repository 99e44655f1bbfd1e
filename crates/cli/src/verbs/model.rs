//! `dobot model`: the arm as a model for other programs.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use dobot_model::{Model, ToolOptions, ToolOptionsError};
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
    #[command(flatten)]
    tool: ToolOptions,
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

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let lengths = Policy::default().tool_length;
    let mounted = args.tool.mounted(|tool| lengths.of(tool));
    let model = Model::new(mounted.map_err(no_such_tool)?);
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

fn no_such_tool(error: ToolOptionsError) -> Failure {
    match error.hint() {
        Some(hint) => Failure::new(error, hint),
        None => error.into(),
    }
}
