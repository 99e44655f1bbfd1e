//! `dobot convert`: programs and files of the vendor's programs, from one form to another.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_teach::vendor::PlaybackParams;
use dobot_teach::{Action, Program};

use crate::failure::Failure;
use crate::output;
use crate::program_file::{self, Kind};

/// Convert a program into another form: .toml, PlayBackPoints.xml, .play, PlayBackParams.json
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot convert PlayBackPoints.xml job.toml        an old file as a program
  dobot convert job.toml PlayBackPoints.xml        and back, for the vendor's program
  dobot convert PlayBackParams.json speeds.toml    its speeds, as a step

What the other form cannot carry is told as warnings.")]
pub(crate) struct Args {
    /// What is read
    from: PathBuf,
    /// What is written
    to: PathBuf,
    /// Write over a file that is there
    #[arg(long)]
    force: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let to = Kind::of(&args.to)?;
    let program = match Kind::of(&args.from)? {
        Kind::Params => speeds(&args.from)?,
        Kind::Program(form) => program_file::read(&args.from, form)?,
    };
    let (text, lost) = match to {
        Kind::Params => params(&program)?,
        Kind::Program(form) => {
            let written = form.write(&program)?;
            (written.it, written.warnings)
        }
    };
    for reason in lost {
        eprintln!("warning: {}: {reason}", args.from.display());
    }
    output::file(&args.to, text.as_bytes(), args.force)
}

/// A program with one step, which sets the speeds of `PlayBackParams.json`.
fn speeds(file: &Path) -> Result<Program, Failure> {
    let params = PlaybackParams::read(&program_file::bytes(file)?)
        .with_context(|| file.display().to_string())?;
    if params.pause_time != 0.0 {
        eprintln!(
            "warning: {}: pauseTime is {}; a program says each pause at its step, so it is left out",
            file.display(),
            params.pause_time
        );
    }
    Ok(Program::new(vec![Action::Speed(params.speed())]))
}

/// The first speeds of a program as `PlayBackParams.json`.
fn params(program: &Program) -> Result<(String, Vec<String>), Failure> {
    let speeds = program.steps.0.iter().find_map(|it| match it.get_ref() {
        Action::Speed(speed) => Some(speed),
        _ => None,
    });
    let speeds = speeds.ok_or_else(|| {
        anyhow!("the program has no step with speeds; a file of speeds needs one")
    })?;
    let others = program.steps.0.len() - 1;
    let lost = (others > 0).then(|| format!("{others} other steps: the file knows speeds alone"));
    Ok((
        PlaybackParams::of_speed(speeds).write(),
        lost.into_iter().collect(),
    ))
}
