//! `dobot convert`: converts programs from and to the formats of the vendor's software.

use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_host::{PlannedFor, Rules};
use dobot_safety::Policy;
use dobot_teach::vendor::{JogParams, Params, PlaybackParams};
use dobot_teach::{Action, Program};

use crate::failure::Failure;
use crate::output;
use crate::program_file::{self, Kind};

/// Convert a program between .toml and the formats of the vendor
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot convert PlayBackPoints.xml job.toml       from the vendor's program
  dobot convert job.toml PlayBackPoints.xml       and back
  dobot convert later.playback job.toml           from its later program
  dobot convert PlayBackParams.json speeds.toml   its speeds, as one step

The vendor's formats hold joint angles: those of positions are computed.
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
        Kind::Params => {
            check_no_jog(&args.to)?;
            params(&program)?
        }
        Kind::Program(form) => {
            let arm = PlannedFor::any(Rules::of(&Policy::default()).into(), None);
            let mut files = program_file::files_beside(&args.from, &arm);
            let written = form.write(&program, &mut files)?;
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
    let read = Params::read(&program_file::bytes(file)?);
    let params = match read.with_context(|| file.display().to_string())? {
        Params::Playback(params) => params,
        Params::Jog(params) => return Err(jog_speeds(file, &params)),
    };
    if params.pause_time != 0.0 {
        eprintln!(
            "warning: {}: pauseTime is {}; it is omitted, because each step of a program has its own pause",
            file.display(),
            params.pause_time
        );
    }
    Ok(Program::new(vec![Action::Speed(params.speed())]))
}

/// The failure for a file with speeds of jogs, which must not become those of moves.
fn jog_speeds(file: &Path, params: &JogParams) -> Failure {
    let error = anyhow!(
        "{} contains the speeds of jogs; the steps of a program set those of moves",
        file.display()
    );
    Failure::new(
        error,
        format!(
            "set them with `dobot set jog --joint-speed {} --joint-acceleration {} --servo-speed {} \
             --servo-acceleration {} --linear-speed {} --linear-acceleration {}`, and jog with \
             `dobot jog BUTTON --percent {}`",
            params.joint_velocity,
            params.joint_acceleration,
            params.servo_velocity,
            params.servo_acceleration,
            params.linear_velocity,
            params.linear_acceleration,
            params.velocity_ratio,
        ),
    )
}

/// Refuses the vendor's name of a file with the speeds of jogs.
fn check_no_jog(to: &Path) -> Result<(), Failure> {
    let name = to.file_name().unwrap_or_default();
    if name.eq_ignore_ascii_case("JogParams.json") {
        return Err(Failure::new(
            anyhow!("JogParams.json contains the speeds of jogs; a program sets those of moves"),
            "write PlayBackParams.json",
        ));
    }
    Ok(())
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
