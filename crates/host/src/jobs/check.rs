//! Checks of a new job, apart from its commands.

use dobot_api::NewJob;
use dobot_wire::Command;

use dobot_supervisor::{Refusal, is_plain};

/// Checks title, lift and pauses of a new job.
pub(super) fn check_new(job: &NewJob) -> Result<(), Refusal> {
    let title = job.title.chars().count();
    if title == 0 || title > TITLE_LEN {
        return Err(Refusal::Malformed(format!(
            "title has {title} characters; allowed are 1 to {TITLE_LEN}"
        )));
    }
    if !(0.0..=LIFT_MM).contains(&job.lift_mm) {
        return Err(Refusal::OutOfRange {
            name: "lift_mm",
            found: job.lift_mm.into(),
            allowed: format!("0 to {LIFT_MM} mm"),
        });
    }
    check_pauses(job)
}

fn check_pauses(job: &NewJob) -> Result<(), Refusal> {
    let count = job.pauses.len();
    if count > PAUSES {
        return Err(Refusal::Malformed(format!(
            "the job has {count} pauses; allowed are up to {PAUSES}"
        )));
    }
    let mut least = 0;
    for pause in &job.pauses {
        check_message(&pause.message)?;
        check_place(job, pause.before, least)?;
        least = pause.before + 1;
    }
    Ok(())
}

fn check_message(message: &str) -> Result<(), Refusal> {
    let found = message.chars().count();
    if found == 0 || found > MESSAGE_LEN {
        return Err(Refusal::Malformed(format!(
            "the message of a pause has {found} characters; allowed are 1 to {MESSAGE_LEN}"
        )));
    }
    if !message.chars().all(is_plain) {
        return Err(Refusal::Malformed(format!(
            "the message of a pause is {message:?}; allowed is one line without control characters"
        )));
    }
    Ok(())
}

/// Checks that a pause comes after the one before it, where the arm is at rest.
fn check_place(job: &NewJob, before: usize, least: usize) -> Result<(), Refusal> {
    if !(least..job.commands.len()).contains(&before) {
        let most = job.commands.len().saturating_sub(1);
        return Err(Refusal::Malformed(format!(
            "a pause is before command {before}; allowed are {least} to {most}, in order"
        )));
    }
    let last = before.checked_sub(1).map(|before| &job.commands[before]);
    match last {
        Some(Command::WriteVector(vector)) if !vector.stop && vector.end_speed_mm_s > 0.0 => {
            let why = format!(
                "a pause is before it, and the previous vector ends at {} mm/s; allowed is 0",
                vector.end_speed_mm_s
            );
            Err(Refusal::bad_job(before, why))
        }
        _ => Ok(()),
    }
}

const TITLE_LEN: usize = 200;
const LIFT_MM: f32 = 100.0;
const PAUSES: usize = 1_000;
const MESSAGE_LEN: usize = 200;
