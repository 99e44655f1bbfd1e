//! `dobot teach`: teaches a program with the keyboard.

mod keys;
mod lesson;
mod outline;
mod prompt;
mod screen;
mod teacher;

use crate::control;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use dobot_host::StationClient;

use self::lesson::Lesson;
use self::teacher::{Settings, Teacher};
use crate::connect::To;
use crate::failure::Failure;
use crate::pendant::{Drive, PadArgs, check_terminal};
use crate::verbs::jog::with_keys;
use crate::{output, values};

/// Teach a program with the keyboard, try it, and save it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot teach cubes.toml                   a new program, or an existing one
  dobot teach cubes.toml --to virtual:     on a virtual arm in this process
  dobot teach glue.toml --tolerance 0.2    record paths to 0.2 mm

Jog with the keys of `dobot jog`, while they are held; Space, Esc or s stops
the arm.
  /       steps of 1 and 0.1 mm or degrees
  Enter   add the current point as a step; m sets its path: jump, movl or movj
  u j     pump on or off, also in the program; t adds a pause of 0.5 s
  v       record the jogged path until v is pressed again, as straight lines
  a       add, with a second key:
            n   name of the point to which the selected step goes
            r   repeat of the following steps: a count, or 0: forever
            t   tool: c cup, g gripper, p pen, l laser; its length
            g   grid: touch its first cell, the end of the first row and of the
                first column with Enter; then its size, 3x4
            f   frame of the next points: touch its origin, a place on its x
                axis and one on the side of its y axis with Enter
            c   call of another program
  e       end the repeat, or the steps of a grid, after the selected step
  , .     select the previous or next step; < > move it, also into and out of a
          repeat; Del removes it; z undoes, Z redoes
  g l     run once, or repeatedly; h from this step on; n one step;
          p pauses, x ends
  w q     save, quit

In a question, Space stops the arm, Esc stops it and leaves the question, and
Backspace goes back. Text can be pasted there, and nowhere else.

The button on the arm releases the motors, and the arm does not report that:
what is turned by hand is not counted, and points taught afterwards are wrong.
After using the button, point the arm straight ahead and switch it off and on.
A reset is detected: nothing moves and nothing is taught until r and y confirm
that the arm has the pose that the screen shows.")]
pub(crate) struct Args {
    /// Program, a TOML file; created if it does not exist
    program: PathBuf,
    /// Maximum deviation of a recorded path, 0.05 to 20 mm
    #[arg(long, value_name = "MM", default_value = "0.5", value_parser = values::number(0.05..=20.0, "mm"))]
    tolerance: f64,
    /// Arm the laser for this many seconds, 1 to 3600, when a program that burns is run; everyone present must
    /// wear goggles
    #[arg(long, value_name = "SECONDS", value_parser = values::laser_seconds)]
    arm_laser: Option<Duration>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    check_terminal(
        "`dobot teach`",
        "write the program in an editor, and check it with `dobot check`",
    )?;
    let lesson = read(&args.program)?;
    let file = args.program.clone();
    let teach = async |station: &mut StationClient| {
        let settings = Settings {
            tolerance_mm: args.tolerance,
            rules: control::planned_for(station).await?.rules,
            arm_laser: args.arm_laser,
        };
        let panel = |pendant| Teacher::new(pendant, lesson, file, settings);
        with_keys(station, &args.to, &args.pad, Drive::Jog, panel).await
    };
    let status = args.to.with_arm("teach", teach).await?;
    Ok(output::status(&status, false)?)
}

/// Reads the program in a file, or creates a new one.
fn read(file: &Path) -> Result<Lesson, Failure> {
    match std::fs::read_to_string(file) {
        Ok(text) if text.trim().is_empty() => Ok(Lesson::new(title(file))),
        Ok(text) => Lesson::of_text(&text).map_err(|error| {
            Failure::new(
                anyhow!("{}: {error}", file.display()),
                "correct it in an editor, or name another file",
            )
        }),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Lesson::new(title(file))),
        Err(error) => {
            let read = Err(error);
            Ok(read.with_context(|| format!("cannot read {}", file.display()))?)
        }
    }
}

/// The title of a new program: the name of its file without the extension.
fn title(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    stem.to_string_lossy().into_owned()
}
