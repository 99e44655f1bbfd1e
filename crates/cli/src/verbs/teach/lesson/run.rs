//! The program as a job.

use dobot_api::NewJob;
use dobot_host::PlannedFor;
use dobot_teach::{Action, Compiled, CompiledStep, Files, Problem, Program, Steps, Times, check};

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
        let program = self.program();
        let compiled = match part {
            Part::Loop => compile(&looped(program.clone()), arm, files)?,
            Part::All => compile(&program, arm, files)?,
            Part::FromHere => {
                let line = self.line_of_cursor(&program);
                let compiled = compile(&program, arm, files)?;
                let here = |step: &CompiledStep| step.file.is_none() && Some(step.line) >= line;
                let step = compiled.steps.iter().position(here);
                let rest = step
                    .filter(|_| line.is_some())
                    .and_then(|index| compiled.from_step(index));
                rest.ok_or("the program does nothing from this step on")?
            }
        };
        let report = check(&compiled, &arm.rules.policy, arm.model());
        if let Some(first) = report.problems.first() {
            let rows = outline(&program);
            if first.file.is_none()
                && let Some(at) = rows.iter().rposition(|row| {
                    let line = row.step.map(|step| program.line_of(step));
                    row.kind != RowKind::End && line.is_some_and(|line| line <= first.line)
                })
            {
                self.cursor = at;
            }
            return Err(problem_text(first, report.problems.len() - 1));
        }
        let mut job = compiled.job();
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

fn compile(program: &Program, arm: &PlannedFor, files: &mut dyn Files) -> Result<Compiled, String> {
    let compiled = program.compile_for(&arm.arm(), files);
    compiled.map_err(|error| error.to_string())
}
