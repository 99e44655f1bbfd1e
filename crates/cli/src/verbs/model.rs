//! `dobot model`: prints a model of the arm for other programs.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use clap::ValueEnum;
use dobot_model::{Model, ToolOptions, ToolOptionsError};
use dobot_safety::Policy;

use crate::failure::Failure;
use crate::output;

/// Print a model of the arm: URDF, MJCF, JSON, or a MoveIt configuration
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot model > dobot_arm.urdf                    with a suction cup, for ROS
  dobot model --format mjcf --tool gripper -o .   dobot_arm.xml for MuJoCo
  dobot model --format json --tool pen --length 62
  dobot model --format moveit -o moveit           a folder with all files that MoveIt needs
  dobot model --tool none                         up to the wrist, for another tool

URDF and MJCF are in metres and radians, JSON in millimetres and degrees.
Masses and forces are estimates, not measurements.")]
pub(crate) struct Args {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Urdf)]
    format: Format,
    #[command(flatten)]
    tool: ToolOptions,
    /// Output file, or a folder for a file named `dobot_arm` (default: standard output). MoveIt needs a folder
    #[arg(
        short,
        long,
        value_name = "FILE|FOLDER",
        required_if_eq("format", "moveit")
    )]
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
    Moveit,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let lengths = Policy::default().tool_length;
    let mounted = args.tool.mounted(|tool| lengths.of(tool));
    let model = Model::new(mounted.map_err(tool_failure)?);
    let (name, text) = match args.format {
        Format::Urdf => ("dobot_arm.urdf", model.to_urdf()),
        Format::Mjcf => ("dobot_arm.xml", model.to_mjcf()),
        Format::Json => ("dobot_arm.json", model.to_json()),
        Format::Moveit => return write_folder(args, &model.to_moveit()),
    };
    match &args.out {
        None => Ok(output::bytes(text.as_bytes())?),
        Some(out) => {
            let file = if out.is_dir() { &out.join(name) } else { out };
            output::file(file, text.as_bytes(), args.force)
        }
    }
}

/// Writes files into the folder, which is created if it does not exist.
fn write_folder(args: &Args, files: &[(&str, String)]) -> Result<(), Failure> {
    let folder = args.out.as_deref().expect("clap requires it");
    fs::create_dir_all(folder)
        .with_context(|| format!("cannot create the folder {}", folder.display()))?;
    for (name, text) in files {
        output::file(&folder.join(name), text.as_bytes(), args.force)?;
    }
    Ok(())
}

fn tool_failure(error: ToolOptionsError) -> Failure {
    let hint = error.hint();
    let failure = Failure::usage(error);
    match hint {
        Some(hint) => failure.with_hint(hint),
        None => failure,
    }
}
