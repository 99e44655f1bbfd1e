//! Programs in files: taught ones, and those of the vendor's programs.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_draw::draw_step;
use dobot_rules::PlannedFor;
use dobot_teach::vendor::{self, VendorPoint};
use dobot_teach::{Compiled, Drawing, Files, Problem, Program, ProgramError, Report};
use dobot_wire::Command;

use crate::failure::Failure;

/// Reads a program, or points of a vendor's program, and makes commands of it; what was surprising goes to standard
/// error.
pub(crate) fn compile(file: &Path, arm: &PlannedFor) -> Result<Compiled, Failure> {
    let program = read(file)?;
    let mut files = FilesBeside::new(file, arm.clone());
    let mut compiled = program
        .compile_for(&arm.arm(), &mut files)
        .with_context(|| named(file))?;
    if compiled.title.is_empty() {
        compiled.title = file
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
    }
    Ok(compiled)
}

/// Reads a program: by the end of its name a TOML file, `PlayBackPoints.xml` or a `.play` file.
pub(crate) fn read(file: &Path) -> Result<Program, Failure> {
    match Kind::of(file)? {
        Kind::Program => {
            let bytes = bytes(file)?;
            let text = String::from_utf8(bytes).map_err(|_| {
                anyhow!("{} is not text in UTF-8, so it is no program", named(file))
            })?;
            Ok(Program::from_toml(&text).with_context(|| named(file))?)
        }
        Kind::Points => of_points(file, vendor::read_points(&bytes(file)?)),
        Kind::Play => of_points(file, vendor::read_play(&bytes(file)?)),
        Kind::Params => Err(Failure::new(
            anyhow!("{} holds speeds, no program", named(file)),
            "`dobot convert PlayBackParams.json speeds.toml` makes a step of it",
        )),
    }
}

/// What is wrong with a program, a line each: `step 3 (line 12, go to tray): what; what helps`.
pub(crate) fn problems(report: &Report) -> Vec<String> {
    report.problems.iter().map(problem).collect()
}

fn problem(it: &Problem) -> String {
    let file = it
        .file
        .as_ref()
        .map_or_else(String::new, |file| format!("{file}, "));
    format!(
        "step {} ({file}line {}, {}): {}; {}",
        it.step, it.line, it.label, it.message, it.remedy
    )
}

/// What a file is, by the end of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A taught program.
    Program,
    /// `PlayBackPoints.xml`.
    Points,
    /// A `.play` file.
    Play,
    /// `PlayBackParams.json` or `JogParams.json`.
    Params,
}

impl Kind {
    pub(crate) fn of(file: &Path) -> Result<Self, Failure> {
        let end = file
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_ascii_lowercase();
        match end.as_str() {
            "toml" => Ok(Self::Program),
            "xml" => Ok(Self::Points),
            "play" => Ok(Self::Play),
            "json" => Ok(Self::Params),
            _ => Err(anyhow!(
                "{} ends in {end:?}; programs end in .toml, .xml or .play, and speeds in .json",
                named(file)
            )
            .into()),
        }
    }
}

pub(crate) fn bytes(file: &Path) -> Result<Vec<u8>, Failure> {
    Ok(fs::read(file).with_context(|| format!("cannot read {}", named(file)))?)
}

/// The program of points that were read; what was surprising in them is told.
fn of_points(
    file: &Path,
    read: Result<vendor::Read<Vec<VendorPoint>>, ProgramError>,
) -> Result<Program, Failure> {
    let read = read.with_context(|| named(file))?;
    for warning in read.warnings {
        eprintln!("warning: {}: {warning}", named(file));
    }
    Ok(vendor::program_of(&read.it))
}

fn named(file: &Path) -> String {
    file.display().to_string()
}

/// The files beside a program.
pub(crate) struct FilesBeside {
    folder: PathBuf,
    arm: PlannedFor,
}

impl FilesBeside {
    /// Those beside this program; drawings are prepared for this arm.
    pub(crate) fn new(program: &Path, arm: PlannedFor) -> Self {
        Self {
            folder: program.parent().unwrap_or(Path::new("")).to_owned(),
            arm,
        }
    }
}

impl Files for FilesBeside {
    fn program(&mut self, path: &str) -> Result<String, String> {
        fs::read_to_string(self.folder.join(path))
            .map_err(|error| format!("cannot read {path}: {error}"))
    }

    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String> {
        let bytes = fs::read(self.folder.join(path))
            .map_err(|error| format!("cannot read {path}: {error}"))?;
        let options = drawing.options.clone();
        let options = options
            .try_into()
            .map_err(|error| format!("{path}: {error}"))?;
        let calibration = self.arm.calibration.clone();
        let dialect = self.arm.dialect();
        draw_step(path, bytes, options, drawing.pen_down, dialect, calibration)
    }
}
