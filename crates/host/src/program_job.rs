//! Programs as jobs.

use dobot_api::NewJob;
use dobot_teach::{Compiled, Files, Problem, Program, ProgramError, Times, check, first_step_at};
use thiserror::Error;

use crate::PlannedFor;

/// Where a program starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgramStart {
    /// At this step, counted from 1 in execution order. The steps of a program that asks are those
    /// of its first path (see [`Program::paths`]).
    Step(usize),
    /// At the first step on this line of its text, counted from 1, or after it. A program that asks
    /// follows the answers that lead there.
    Line(usize),
}

/// The error returned when a program cannot become a job.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProgramJobError {
    /// It cannot be compiled.
    #[error("{0}")]
    Program(#[from] ProgramError),
    /// Steps are not allowed, at least one.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Problems(Vec<Problem>),
    /// There is no such step.
    #[error("from_step is {found}; allowed are 1 to {steps}")]
    NoStep {
        /// The step, counted from 1.
        found: usize,
        /// The number of steps; of a program that asks, those of its first path.
        steps: usize,
    },
    /// There is no step on this line or after it.
    #[error(
        "from_line is {found}; allowed are 1 to {last}, the line of the last step that does something"
    )]
    NoStepAtLine {
        /// The line, counted from 1.
        found: usize,
        /// The line of the last step.
        last: usize,
    },
}

/// Returns the job of a program, with another number of cycles unless it is `None`. The steps of
/// every answer are checked with the motion model. If the program starts after a question, that
/// counts as answered.
///
/// # Errors
///
/// [`ProgramJobError`].
pub fn program_job(
    program: &Program,
    times: Option<Times>,
    start: ProgramStart,
    arm: &PlannedFor,
    files: &mut dyn Files,
) -> Result<NewJob, ProgramJobError> {
    let (program, compiled) = program.compile_times(times, &arm.arm(), files)?;
    let mut paths = program.paths(&arm.arm(), files)?;
    for path in &paths {
        let problems = check(path, &arm.rules.policy, arm.model()).problems;
        if !problems.is_empty() {
            return Err(ProgramJobError::Problems(problems));
        }
    }
    if !compiled.asks {
        paths = vec![compiled];
    }
    let (path, step) = start.find(&paths)?;
    let job = program.job(&paths[path], step, &arm.arm(), files)?;
    job.ok_or_else(|| no_step(step + 1, &paths[path]))
}

impl ProgramStart {
    /// Returns the path and its step, both counted from 0.
    fn find(self, paths: &[Compiled]) -> Result<(usize, usize), ProgramJobError> {
        match self {
            Self::Step(found) => {
                let step = found.checked_sub(1);
                Ok((0, step.ok_or_else(|| no_step(found, &paths[0]))?))
            }
            Self::Line(found) => {
                let start = (found > 0).then(|| first_step_at(paths, found));
                start.flatten().ok_or_else(|| {
                    let steps = paths.iter().flat_map(|path| &path.steps);
                    let last = steps.map(|step| step.main_line).max().unwrap_or(0);
                    ProgramJobError::NoStepAtLine { found, last }
                })
            }
        }
    }
}

fn no_step(found: usize, path: &Compiled) -> ProgramJobError {
    ProgramJobError::NoStep {
        found,
        steps: path.steps.len(),
    }
}
