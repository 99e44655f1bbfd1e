//! `dobot convert`: converts programs from and to the formats of the vendor's software.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_teach::vendor::PlaybackParams;
use dobot_teach::{Action, Program};

use crate::failure::Failure;
use crate::output;
use crate::program_file::{self, Kind};

/// Convert a program: .toml, PlayBackPoints.xml, .play, PlayBackParams.json
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot convert PlayBackPoints.xml job.toml       from the vendor's program
  dobot convert job.toml PlayBackPoints.xml       and back
  dobot convert PlayBackParams.json speeds.toml   its speeds, as one step

Warnings name what the other format cannot hold.")]
pub(crate) struct Args {
    /// Input file
    from: PathBuf,
    /// Output file
    to: PathBuf,
    /// Overwrite an existing file
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
            (written.content, written.warnings)
        }
    };
    for reason in lost {
        eprintln!("warning: {}: {reason}", args.from.display());
    }
    output::file(&args.to, text.as_bytes(), args.force)
}

/// Creates a program of one step that sets the speeds of `PlayBackParams.json`.
fn speeds(file: &Path) -> Result<Program, Failure> {
    let params = PlaybackParams::read(&program_file::bytes(file)?)
        .with_context(|| file.display().to_string())?;
    if params.pause_time != 0.0 {
        eprintln!(
            "warning: {}: pauseTime is {}; it is omitted, because each step of a program has its own pause",
            file.display(),
            params.pause_time
        );
    }
    Ok(Program::new(vec![Action::Speed(params.speed())]))
}

/// Converts the first speeds of a program to `PlayBackParams.json`.
fn params(program: &Program) -> Result<(String, Vec<String>), Failure> {
    let speeds = program
        .steps
        .0
        .iter()
        .find_map(|step| match step.get_ref() {
            Action::Speed(speed) => Some(speed),
            _ => None,
        });
    let speeds = speeds.ok_or_else(|| {
        anyhow!("the program has no step with speeds, which PlayBackParams.json needs")
    })?;
    let others = program.steps.0.len() - 1;
    let lost = (others > 0).then(|| {
        format!(
            "{} omitted: the file holds only speeds",
            output::many(others, "other step is", "other steps are")
        )
    });
    Ok((
        PlaybackParams::of_speed(speeds).write(),
        lost.into_iter().collect(),
    ))
}
