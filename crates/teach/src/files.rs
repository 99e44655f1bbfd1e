//! What a program needs beside itself.

use std::collections::BTreeMap;

use dobot_wire::Command;

use crate::program::Drawing;
use crate::{Action, Program, ProgramError, Steps};

/// Gives what a program names: other programs and drawings. Paths are as seen from the program itself, with `/`.
pub trait Files {
    /// The text of a called program.
    ///
    /// # Errors
    ///
    /// Why it cannot be read, in one line.
    fn program(&mut self, path: &str) -> Result<String, String>;

    /// The commands of a drawing whose file has this path; the first motion in them is a target.
    ///
    /// # Errors
    ///
    /// Why it cannot be drawn, in one line.
    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String>;
}

/// For programs that stand alone: no other file is there.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn program(&mut self, path: &str) -> Result<String, String> {
        Err(format!("there is no file {path} here"))
    }

    fn drawing(&mut self, path: &str, _: &Drawing) -> Result<Vec<Command>, String> {
        Err(format!("there is no file {path} here"))
    }
}

/// All programs that are called, and how many steps each does.
#[derive(Debug, Default)]
pub(crate) struct Called {
    programs: BTreeMap<String, Program>,
    counts: BTreeMap<String, u64>,
}

impl Called {
    pub(crate) fn get(&self, path: &str) -> Option<&Program> {
        self.programs.get(path)
    }

    /// Reads all that a program calls, and counts the steps that it does; a repeat at its end counts once.
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
                    let grid = grids.first().and_then(|it| program.grids.get(it));
                    once.saturating_mul(grid.map_or(0, crate::Grid::cells))
                }
                Action::Call(file) => {
                    let path = beside(calling.last().map(String::as_str), file);
                    {
                        let called = self.call(path, files, calling);
                        called.map_err(|it| {
                            it.or(|reason| error(program, step, calling.last(), reason))
                        })?
                    }
                }
                _ => 1,
            };
            sum = sum.saturating_add(count);
            if sum > MOST_COMMANDS {
                let reason = format!(
                    "up to here the program has {sum} steps when it is written out; allowed are {MOST_COMMANDS}; a repeat that is the program's last step counts once"
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
                "the calls never end: {} calls {path} again",
                calling.join(" calls ")
            )));
        }
        if let Some(count) = self.counts.get(&path) {
            return Ok(*count);
        }
        if calling.len() >= DEEPEST_CALL {
            return Err(CallError::Here(format!(
                "programs call each other {DEEPEST_CALL} deep; that is as deep as allowed"
            )));
        }
        let text = files.program(&path).map_err(CallError::Here)?;
        let named = |it: ProgramError| {
            CallError::There(ProgramError {
                file: Some(path.clone()),
                ..it
            })
        };
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

/// Why a call is not possible: at the call, or in the program that is called.
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
        line: Some(program.line_of(step)),
        reason,
    }
}

/// The path of a file that a program names, as seen from the first program.
pub(crate) fn beside(program: Option<&str>, file: &str) -> String {
    let folder = program
        .and_then(|it| it.rsplit_once('/'))
        .map_or("", |it| it.0);
    if folder.is_empty() || file.starts_with('/') {
        return tidy(file);
    }
    tidy(&format!("{folder}/{file}"))
}

/// Without `.`, and without `..` where that is possible: one file has one path.
fn tidy(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|it| !["..", ""].contains(it)) => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

const NOT_FOREVER: &str =
    "a repeat for ever is the last step of the program itself; nothing behind it would be done";
const DEEPEST_CALL: usize = 32;
/// What a job may have.
pub(crate) const MOST_COMMANDS: u64 = 1_000_000;
