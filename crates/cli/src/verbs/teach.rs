//! `dobot teach`: show the arm a program.

mod keys;
mod lesson;
mod screen;
mod teacher;

use crate::control;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow, bail};
use dobot_host::StationClient;

use self::lesson::Lesson;
use self::teacher::{Settings, Teacher};
use crate::connect::To;
use crate::failure::Failure;
use crate::output;
use crate::pendant::{Drive, PadArgs, check_terminal};
use crate::verbs::jog::{laser_seconds, with_keys};

/// Show the arm a program with keys, try it, and save it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot teach cubes.toml                       a new program, or one that is there
  dobot teach cubes.toml --to virtual:         on a virtual arm in this process
  dobot teach glue.toml --tolerance 0.2        recorded paths to a fifth of a millimetre

Jog with the keys of `dobot jog`, for as long as they are held; Space, Esc or s stops the arm.
  Enter   teaches the point where the arm rests, and a step that goes there; m: its way, jump, movl or movj
  u j     the pump on or off, in the program too; t a pause of 0.5 s
  v       records the path that is jogged until v again: straight lines within the tolerance
  , .     the step before or behind; < > move it; Del removes it; z undoes, Z redoes
  g l     run once, or again and again; h from this step on; n one step; p pauses, x ends
  w q     save, leave

The button on the arm frees the motors, and the arm does not tell that. Its counters know nothing of what it was
turned by hand, and points would be taught elsewhere. After the button: point the arm straight ahead, and switch
it off and on. A reset is noticed: from then on nothing is moved and nothing is taught until r and y confirm
that the arm stands and points as the screen says.")]
pub(crate) struct Args {
    /// The program, a TOML file; it may be new
    program: PathBuf,
    /// How far the steps of a recorded path may be from it, in millimetres from 0.05 to 20
    #[arg(long, value_name = "MM", default_value = "0.5", value_parser = tolerance)]
    tolerance: f64,
    /// Let the laser be switched on for so many seconds when a program is run that burns: everybody's goggles are on
    #[arg(long, value_name = "SECONDS", value_parser = laser_seconds)]
    arm_laser: Option<Duration>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    check_terminal(
        "`dobot teach`",
        "write the program in an editor: `dobot check` tells what is wrong with it",
    )?;
    let lesson = read(&args.program)?;
    let file = args.program.clone();
    let policy = args.to.policy()?;
    let teach = async |station: &mut StationClient| {
        let settings = Settings {
            tolerance_mm: args.tolerance,
            rules: control::planned_for(station, &policy).await?.rules,
            arm_laser: args.arm_laser,
        };
        let panel = |pendant| Teacher::new(pendant, lesson, file, settings);
        with_keys(station, &args.to, &args.pad, Drive::Jog, panel).await
    };
    let status = args.to.with_arm("teach", teach).await?;
    Ok(output::status(&status, false)?)
}

/// The program in a file; a new one where there is none.
fn read(file: &Path) -> Result<Lesson, Failure> {
    match std::fs::read_to_string(file) {
        Ok(text) if text.trim().is_empty() => Ok(Lesson::new(title(file))),
        Ok(text) => Lesson::of_text(&text).map_err(|error| {
            Failure::new(
                anyhow!("{}: {error}", file.display()),
                "change it in an editor first, or teach another file",
            )
        }),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Lesson::new(title(file))),
        Err(error) => {
            let read = Err(error);
            Ok(read.with_context(|| format!("{} cannot be read", file.display()))?)
        }
    }
}

/// What a new program is called: its file without folder and ending.
fn title(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    stem.to_string_lossy().into_owned()
}

fn tolerance(text: &str) -> anyhow::Result<f64> {
    match text.parse() {
        Ok(mm) if (0.05..=20.0).contains(&mm) => Ok(mm),
        _ => bail!("allowed are 0.05 to 20 mm"),
    }
}
