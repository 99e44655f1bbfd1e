//! The files that a program uses.

use std::collections::BTreeMap;

use dobot_wire::Command;

use crate::program::Drawing;
use crate::{Action, Program, ProgramError, Steps};

/// Provides the files that a program names: other programs and drawings. Paths are relative to the
/// main program, with `/`.
pub trait Files {
    /// Returns the text of a called program.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be read, in one line.
    fn program(&mut self, path: &str) -> Result<String, String>;

    /// Returns the commands of a drawing; their first motion is a target.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be drawn, in one line.
    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String>;
}

/// No files, for programs that use none.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn program(&mut self, path: &str) -> Result<String, String> {
        Err(format!(
            "file {path} is not available; this program must not use other files"
        ))
    }

    fn drawing(&mut self, path: &str, _: &Drawing) -> Result<Vec<Command>, String> {
        Err(format!(
            "file {path} is not available; this program must not use other files"
        ))
    }
}

/// All called programs and their numbers of steps.
#[derive(Debug, Default)]
pub(crate) struct Called {
    programs: BTreeMap<String, Program>,
    counts: BTreeMap<String, u64>,
}

impl Called {
    /// Returns all called programs, with their paths.
    pub(crate) fn by_path(&self) -> impl Iterator<Item = (&str, &Program)> {
        self.programs
            .iter()
            .map(|(path, program)| (path.as_str(), program))
    }

    pub(crate) fn get(&self, path: &str) -> Option<&Program> {
        self.programs.get(path)
    }

    /// Loads all called programs and counts the steps; a repeat at the end of the program counts
    /// once.
    pub(crate) fn load(
        &mut self,
        program: &Program,
        files: &mut dyn Files,
        calling: &mut Vec<String>,
    ) -> Result<u64, ProgramError> {
        self.steps(program, &program.steps, files, calling, calling.is_empty())
    }

    fn steps(
        &mut self,
        program: &Program,
        steps: &Steps,
        files: &mut dyn Files,
        calling: &mut Vec<String>,
        is_main: bool,
    ) -> Result<u64, ProgramError> {
        let mut sum = 0_u64;
        for (index, step) in steps.0.iter().enumerate() {
            let is_last = is_main && index + 1 == steps.0.len();

            let count = match step.get_ref() {
                Action::Repeat(crate::Times::Forever, _) if !is_last => {
                    return Err(error(program, step, calling.last(), NOT_FOREVER.to_owned()));
                }
                Action::Repeat(times, inner) => {
                    let once = self.steps(program, inner, files, calling, false)?;
                    match times {
                        crate::Times::Count(count) if !is_last => once.saturating_mul(*count),
                        _ => once,
                    }
                }
                Action::Each(grids, inner) => {
                    let once = self.steps(program, inner, files, calling, false)?;
                    let grid = grids.first().and_then(|name| program.grids.get(name));
                    once.saturating_mul(grid.map_or(0, crate::Grid::cells))
                }
                Action::While(_, inner) => self.steps(program, inner, files, calling, false)?,
                Action::Choose(choose) => {
                    let mut most = 0;
                    for when in &choose.when {
                        let count = self.steps(program, &when.steps, files, calling, false)?;
                        most = count.max(most);
                    }
                    most
                }
                Action::Pick(transfer) => {
                    let missed = transfer.missed.as_ref();
                    let count = missed
                        .map(|missed| self.steps(program, &missed.steps, files, calling, false));
                    count
                        .transpose()?
                        .unwrap_or(0)
                        .saturating_add(PICK_COMMANDS)
                }
                Action::Place(_) => PICK_COMMANDS,
                Action::Set(_) | Action::Add(_) => 0,
                Action::Call(file) => {
                    let path = beside(calling.last().map(String::as_str), file);
                    let called = self.call(path, files, calling);
                    called.map_err(|call| {
                        call.or(|reason| error(program, step, calling.last(), reason))
                    })?
                }
                _ => 1,
            };
            sum = sum.saturating_add(count);
            if sum > MAX_COMMANDS {
                let reason = format!(
                    "the program expands to {sum} steps up to here; allowed are {MAX_COMMANDS}; a repeat that is the last step of the program counts once"
                );
                return Err(error(program, step, calling.last(), reason));
            }
        }
        Ok(sum)
    }

    fn call(
        &mut self,
        path: String,
        files: &mut dyn Files,
        calling: &mut Vec<String>,
    ) -> Result<u64, CallError> {
        if calling.contains(&path) {
            return Err(CallError::Here(format!(
                "the calls never end: {} calls {path} again; remove one of the calls",
                calling.join(" calls ")
            )));
        }
        if let Some(count) = self.counts.get(&path) {
            return Ok(*count);
        }
        if calling.len() >= MAX_CALL_DEPTH {
            return Err(CallError::Here(format!(
                "calls of programs are nested more than {MAX_CALL_DEPTH} deep; allowed are {MAX_CALL_DEPTH}"
            )));
        }
        let text = files.program(&path).map_err(CallError::Here)?;
        let named = |error: ProgramError| CallError::There(error.in_file(&path));
        let program = Program::from_toml(&text).map_err(named)?;
        calling.push(path.clone());
        let count = self
            .load(&program, files, calling)
            .map_err(CallError::There)?;
        calling.pop();
        self.programs.insert(path.clone(), program);
        self.counts.insert(path, count);
        Ok(count)
    }
}

/// The reason why a call fails: at the call, or in the called program.
enum CallError {
    Here(String),
    There(ProgramError),
}

impl CallError {
    fn or(self, here: impl FnOnce(String) -> ProgramError) -> ProgramError {
        match self {
            Self::Here(reason) => here(reason),
            Self::There(error) => error,
        }
    }
}

pub(crate) fn error(
    program: &Program,
    step: &toml::Spanned<Action>,
    file: Option<&String>,
    reason: String,
) -> ProgramError {
    ProgramError {
        file: file.cloned(),
        ..ProgramError::at(program.line_of(step), reason)
    }
}

/// The path of a file that a program names, relative to the main program.
pub(crate) fn beside(program: Option<&str>, file: &str) -> String {
    let folder = program
        .and_then(|path| path.rsplit_once('/'))
        .map_or("", |(folder, _)| folder);
    if folder.is_empty() || file.starts_with('/') {
        return tidy(file);
    }
    tidy(&format!("{folder}/{file}"))
}

/// Removes `.`, and `..` if possible: one file has one path.
fn tidy(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|part| !["..", ""].contains(part)) => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

const NOT_FOREVER: &str = "an endless repeat is not the last step of the main program; move it to the end, or give it a number";
/// The commands of a pick or place.
const PICK_COMMANDS: u64 = 3;
const MAX_CALL_DEPTH: usize = 32;
/// The largest number of commands of a job.
pub(crate) const MAX_COMMANDS: u64 = 1_000_000;
