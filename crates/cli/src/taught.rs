//! Taught programs and what they name, from the disk.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_draw::{DrawingRequest, Materials, Options, Subject};
use dobot_source::Source;
use dobot_teach::{Compiled, Drawing, Files, Problem, Program, Report};
use dobot_wire::{Command, Dialect};

use crate::failure::Failure;

/// Reads a program.
pub(crate) fn read(file: &Path) -> Result<Program, Failure> {
    let text =
        fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
    let mut program = Program::from_toml(&text).map_err(|error| in_file(file, &error))?;
    if program.title.is_empty() {
        program.title = name(file);
    }
    Ok(program)
}

/// Makes commands of a program, for an arm that speaks this dialect, if that is known.
pub(crate) fn compile(
    program: &Program,
    file: &Path,
    dialect: Option<Dialect>,
) -> Result<Compiled, Failure> {
    let mut files = Beside {
        folder: file.parent().map(Path::to_owned).unwrap_or_default(),
        dialect,
    };
    let compiled = program.compile(&mut files);
    compiled.map_err(|error| in_file(file, &error))
}

/// All that is wrong with a program, a line each: `pick.toml:12: step 3 (go to "tray"): ...`.
pub(crate) fn check_report(file: &Path, report: &Report) -> Result<(), Failure> {
    let lines: Vec<String> = report.problems.iter().map(|it| line(file, it)).collect();
    match lines.as_slice() {
        [] => Ok(()),
        [one] => Err(anyhow!("{one}").into()),
        all => Err(anyhow!("{}\n{} problems", all.join("\n"), all.len()).into()),
    }
}

fn line(file: &Path, problem: &Problem) -> String {
    let own = file.display().to_string();
    let Problem {
        step,
        line,
        label,
        message,
        remedy,
        ..
    } = problem;
    let file = problem.file.as_deref().unwrap_or(&own);
    format!("{file}:{line}: step {step} ({label}): {message}; {remedy}")
}

fn in_file(file: &Path, error: &dobot_teach::ProgramError) -> Failure {
    anyhow!("{}: {error}", file.display()).into()
}

fn name(file: &Path) -> String {
    let name = file.file_name().unwrap_or(file.as_os_str());
    name.to_string_lossy().into_owned()
}

/// The files in the folder of a program, and below.
struct Beside {
    folder: PathBuf,
    dialect: Option<Dialect>,
}

impl Files for Beside {
    fn program(&mut self, path: &str) -> Result<String, String> {
        let path = self.folder.join(path);
        fs::read_to_string(&path)
            .map_err(|error| format!("cannot read {}: {error}", path.display()))
    }

    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String> {
        self.draw(&self.folder.join(path), drawing)
            .map_err(|error| format!("{error:#}"))
    }
}

impl Beside {
    fn draw(&self, path: &Path, drawing: &Drawing) -> anyhow::Result<Vec<Command>> {
        let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        let title = name(path);
        let source = Some(Source::of_file(&title, bytes)?);
        let options = serde_json::to_value(&drawing.options)?;
        let options: Options = serde_json::from_value(options).context("in its options")?;
        let subject = Subject { title, source };
        let asked = DrawingRequest::new(options, subject, &Materials::built_in())?;
        let (prepared, _) = asked.prepare(self.dialect, drawing.pen_down)?;
        Ok(prepared.plan.commands().collect())
    }
}
