//! Programs as jobs.

use dobot_api::NewJob;
use dobot_teach::{Files, Problem, Program, ProgramError, Times, check};
use thiserror::Error;

use crate::PlannedFor;

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
        /// The number of steps; of a program that asks, those of its first path (see [`Program::paths`]).
        steps: usize,
    },
}

/// Returns the job of a program, with another number of cycles unless it is `None`, from a step on,
/// counted from 1. The steps of every answer are checked with the motion model. The steps of a
/// program that asks are those of its first path: its earlier questions count as answered so.
///
/// # Errors
///
/// [`ProgramJobError`].
pub fn program_job(
    program: &Program,
    times: Option<Times>,
    from_step: usize,
    arm: &PlannedFor,
    files: &mut dyn Files,
) -> Result<NewJob, ProgramJobError> {
    let (program, compiled) = program.compile_times(times, &arm.arm(), files)?;
    let paths = program.paths(&arm.arm(), files)?;
    for path in &paths {
        let problems = check(path, &arm.rules.policy, arm.model()).problems;
        if !problems.is_empty() {
            return Err(ProgramJobError::Problems(problems));
        }
    }
    let asks = compiled.asks;
    let path = paths.into_iter().next().filter(|_| asks);
    let path = path.unwrap_or(compiled);
    let job = match from_step.checked_sub(1) {
        Some(from) => program.job(&path, from, &arm.arm(), files)?,
        None => None,
    };
    job.ok_or(ProgramJobError::NoStep {
        found: from_step,
        steps: path.steps.len(),
    })
}
