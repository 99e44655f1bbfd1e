//! A drawing plan as a job.

use dobot_api::{JobKind, JobPause, JobProgram, NewJob};
use dobot_plan::Plan;
use dobot_wire::single;

/// Returns the job that draws a plan, with the plan's pauses.
#[must_use]
pub fn drawing_job(plan: &Plan, title: &str) -> NewJob {
    let pauses = plan.breaks_in_commands().map(|(before, message)| JobPause {
        before,
        message: message.to_owned(),
    });
    NewJob {
        title: title.to_owned(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: single(plan.lift_mm()),
        pauses: pauses.collect(),
        program: JobProgram::default(),
    }
}
