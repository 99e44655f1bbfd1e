//! The program as a job.

use dobot_api::NewJob;
use dobot_host::PlannedFor;
use dobot_teach::{
    Action, Files, Problem, Program, ProgramError, Steps, Times, check, first_step_at,
};

use super::Lesson;
use crate::verbs::teach::outline::{RowKind, is_endless, outline};

/// The part of a program to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// The whole program, with its own repetitions.
    All,
    /// The whole program, until a person ends it.
    Loop,
    /// From the selected step on.
    FromHere,
}

impl Lesson {
    /// Creates the job of a part of the program; `files` provides called programs and drawings. Selects a step that
    /// cannot be executed.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be run, in one line.
    pub(crate) fn job(
        &mut self,
        part: Part,
        files: &mut dyn Files,
        arm: &PlannedFor,
    ) -> Result<NewJob, String> {
        if self.document.is_none() {
            return Err("the program has no step yet".to_owned());
        }
        let mut program = self.program();
        if part == Part::Loop {
            program = looped(program);
        }
        let plain = |error: ProgramError| error.to_string();
        let mut paths = program.paths(&arm.arm(), files).map_err(plain)?;
        let (path, step) = match part {
            Part::All | Part::Loop => (0, 0),
            Part::FromHere => {
                let line = self.line_of_cursor(&program);
                let start = line.and_then(|line| first_step_at(&paths, line));
                start.ok_or("the program does nothing from this step on")?
            }
        };
        let job = program.job(&paths[path], step, &arm.arm(), files);
        let job = job.map_err(plain)?;
        let mut job = job.ok_or("the program does nothing")?;
        paths[path] = paths[path].from_step(step).unwrap_or_default();
        let mut problems = paths
            .iter()
            .flat_map(|path| check(path, &arm.rules.policy, arm.model()).problems);
        if let Some(first) = problems.next() {
            let shown = self.program();
            let rows = outline(&shown);
            if first.file.is_none()
                && let Some(at) = rows.iter().rposition(|row| {
                    let line = row.step.map(|step| program.line_of(step));
                    row.kind != RowKind::End && line.is_some_and(|line| line <= first.line)
                })
            {
                self.cursor = at;
            }
            return Err(problem_text(&first, problems.count()));
        }
        if job.title.is_empty() {
            job.title.push_str("a taught program");
        }
        Ok(job)
    }

    /// The line of the selected step, or of the next one.
    fn line_of_cursor(&self, program: &Program) -> Option<usize> {
        let rows = outline(program);
        let mut rest = rows.iter().skip(self.cursor);
        let row = rest.find(|row| matches!(row.kind, RowKind::Step | RowKind::Head))?;
        row.step.map(|step| program.line_of(step))
    }
}

/// Repeats a whole program forever.
fn looped(mut program: Program) -> Program {
    let last = program.steps.0.last();
    if !last.is_some_and(|step| is_endless(step.get_ref())) {
        let steps = std::mem::take(&mut program.steps);
        program.steps = Steps::new(vec![Action::Repeat(Times::Forever, steps)]);
    }
    program
}

/// Formats the first problem and the number of others.
fn problem_text(first: &Problem, more: usize) -> String {
    let Problem {
        step,
        message,
        remedy,
        ..
    } = first;
    let text = format!("step {step}: {message}; {remedy}");
    match more {
        0 => text,
        more => format!("{text} (and {more} more: `dobot check` lists them)"),
    }
}
