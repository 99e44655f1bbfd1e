//! `dobot model`: prints a model of the arm for other programs.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use dobot_model::{Model, ToolOptions, ToolOptionsError};
use dobot_safety::Policy;

use crate::failure::Failure;
use crate::output;

/// Print a model of the arm: URDF, MJCF (MuJoCo) or JSON
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot model > dobot_arm.urdf                    with a suction cup, for ROS and MoveIt
  dobot model --format mjcf --tool gripper -o .   dobot_arm.xml for MuJoCo
  dobot model --format json --tool pen --length 62
  dobot model --tool none                         up to the wrist, for another tool

URDF and MJCF are in metres and radians, JSON in millimetres and degrees.
Masses and forces are estimates, not measurements.")]
pub(crate) struct Args {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Urdf)]
    format: Format,
    #[command(flatten)]
    tool: ToolOptions,
    /// Output file, or a folder for a file named `dobot_arm` (default: standard output)
    #[arg(short, long, value_name = "FILE|FOLDER")]
    out: Option<PathBuf>,
    /// Overwrite an existing file
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
    let model = Model::new(mounted.map_err(tool_failure)?);
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
    /// The output file.
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

fn tool_failure(error: ToolOptionsError) -> Failure {
    let hint = error.hint();
    let failure = Failure::usage(error);
    match hint {
        Some(hint) => failure.with_hint(hint),
        None => failure,
    }
}
