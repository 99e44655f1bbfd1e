//! Program files: taught programs, and files of the vendor's software.

use std::fs;
use std::path::Path;

use anyhow::{Context, anyhow};
use dobot_draw::ProgramFiles;
use dobot_host::{DryRun, PlannedFor};
use dobot_teach::{Compiled, Files, Program, ProgramError, ProgramForm, Times};

use crate::failure::Failure;
use crate::output::{self, clock};

/// Reads a program or points of the vendor's software. Prints warnings on standard error.
pub(crate) fn read_program(file: &Path) -> Result<Program, Failure> {
    match Kind::of(file)? {
        Kind::Program(form) => read(file, form),
        Kind::Params => Err(Failure::new(
            anyhow!("{} contains speeds, not a program", named(file)),
            "convert it to a step: `dobot convert PlayBackParams.json speeds.toml`",
        )),
    }
}

/// Compiles a program that was read from a file, with another number of cycles unless it is `None`.
/// Returns the program with that number, too.
pub(crate) fn compile_times(
    file: &Path,
    program: &Program,
    times: Option<Times>,
    arm: &PlannedFor,
) -> Result<(Program, Compiled), Failure> {
    let mut program = program.clone();
    if program.title.is_empty() {
        let name = file.file_stem().unwrap_or_default();
        program.title = name.to_string_lossy().into_owned();
    }
    let compiled = program.compile_times(times, &arm.arm(), &mut files_beside(file, arm));
    Ok(compiled.with_context(|| named(file))?)
}

/// Describes a program and its durations in one line.
pub(crate) fn summary(program: &Compiled, dry_run: &DryRun) -> String {
    let mut parts = vec![output::counts(&[
        (program.steps.len(), "step", "steps"),
        (program.commands.len(), "command", "commands"),
        (
            program.pauses.len(),
            "pause for a person",
            "pauses for a person",
        ),
    ])];
    match dry_run.first_s {
        Some(first_s) => parts.push(format!("{} from the current position", clock(first_s))),
        None => parts.push("duration unknown".to_owned()),
    }
    if let Some(cycle_s) = dry_run.cycle_s {
        parts.push(format!("{} for each further cycle", clock(cycle_s)));
        parts.push(match dry_run.total_s {
            Some(total_s) => format!("{} in total", clock(total_s)),
            None => "until a person ends it".to_owned(),
        });
    }
    if dry_run.depends_on_answers {
        parts.push("with the first answer to each question".to_owned());
    }
    format!("{}: {}", program.title, parts.join(", "))
}

/// Reads a program of a format. Prints warnings on standard error.
pub(crate) fn read(file: &Path, form: ProgramForm) -> Result<Program, Failure> {
    let read = form.read(&bytes(file)?);
    let read = read.map_err(|error| mistakes(file, error))?;
    for warning in read.warnings {
        eprintln!("warning: {}: {warning}", named(file));
    }
    Ok(read.content)
}

/// The kind of a file, by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A program.
    Program(ProgramForm),
    /// `PlayBackParams.json` or `JogParams.json`.
    Params,
}

impl Kind {
    pub(crate) fn of(file: &Path) -> Result<Self, Failure> {
        if let Some(form) = ProgramForm::of_name(&named(file)) {
            return Ok(Self::Program(form));
        }
        let end = file.extension().unwrap_or_default().to_string_lossy();
        if end.eq_ignore_ascii_case("json") {
            return Ok(Self::Params);
        }
        Err(anyhow!(
            "{} has the extension {end:?}; expected .toml, .xml, .play or .playback for a program, or .json for speeds",
            named(file)
        )
        .into())
    }
}

pub(crate) fn bytes(file: &Path) -> Result<Vec<u8>, Failure> {
    Ok(fs::read(file).with_context(|| format!("cannot read {}", named(file)))?)
}

/// The files that a program refers to; drawings are prepared for an arm.
pub(crate) fn files_beside(program: &Path, arm: &PlannedFor) -> impl Files + use<> {
    let folder = program.parent().unwrap_or(Path::new("")).to_owned();
    let read = move |path: &str| {
        fs::read(folder.join(path)).map_err(|error| format!("cannot read {path}: {error}"))
    };
    ProgramFiles::new(read, arm.dialect(), arm.calibration.clone())
}

/// The mistakes of a file, each on its own line.
fn mistakes(file: &Path, mut error: ProgramError) -> anyhow::Error {
    let others = std::mem::take(&mut error.others);
    if others.is_empty() {
        return anyhow::Error::from(error).context(named(file));
    }
    let all = std::iter::once(&error).chain(&others);
    let lines: Vec<String> = all.map(|mistake| format!("  {mistake}")).collect();
    let count = output::count(lines.len(), "mistake");
    anyhow!("{} has {count}:\n{}", named(file), lines.join("\n"))
}

fn named(file: &Path) -> String {
    file.display().to_string()
}
