//! The path of a job, for display.

use dobot_api::JobPath;
use dobot_journal::{Job, Journal};
use dobot_motion::{Model, ReturnWait, Trajectory};
use dobot_supervisor::{Refusal, draws_below_mm};
use dobot_wire::Command;

use crate::jobs::{find, journal_refusal, recovery_model};

/// Returns the planned path of a job, once through its commands, in calibrated positions.
pub(crate) fn path_of(journal: &Journal, job: u64) -> Result<JobPath, Refusal> {
    let job = find(journal, job)?;
    let commands = journal
        .commands(job.id)
        .map_err(|error| journal_refusal(&error))?;
    walk(recovery_model(&job), &job, &commands)
}

fn walk(mut model: Model, job: &Job, commands: &[Command]) -> Result<JobPath, Refusal> {
    let mut path = JobPath::default();
    let mut return_wait = ReturnWait::new(model.dialect.status_period().as_secs_f64());
    let mut begun_s = 0.0;
    for (index, command) in commands.iter().enumerate() {
        let trajectory = model
            .trajectory(command)
            .map_err(|error| Refusal::bad_job(index, error.to_string()))?;
        let after = model.after(command, &trajectory);
        begun_s += return_wait.before(&model, &trajectory, &after);
        add_corners(&mut path, (index, begun_s), &model, &trajectory);
        begun_s += trajectory.duration_s().unwrap_or_default();
        model = after;
    }
    if let Some(lift_mm) = job.lift_mm {
        mark_lowered(&mut path, lift_mm.into());
    }
    Ok(path)
}

/// Adds the corners of a command, given with the time of its begin in seconds.
fn add_corners(
    path: &mut JobPath,
    (command, begun_s): (usize, f64),
    model: &Model,
    trajectory: &Trajectory,
) {
    for (place, after_s) in trajectory.corners() {
        let position = model.calibrated_place(&place).pose.position;
        path.path_mm
            .push([position.x.0, position.y.0, position.z.0].map(rounded));
        path.commands.push(command);
        path.marks.push(trajectory.laser());
        path.until_s.push(rounded(begun_s + after_s));
    }
}

/// A pen draws where a vector ends closer to the lowest position than to the lift height.
fn mark_lowered(path: &mut JobPath, lift_mm: f64) {
    let heights = path.path_mm.iter().map(|position| position[2]);
    let below_mm = draws_below_mm(heights.fold(f64::MAX, f64::min), lift_mm);
    let is_low = |at: &[f64; 3]| at[2] < below_mm;
    let mut was_low = false;
    for (at, marks) in path.path_mm.iter().zip(&mut path.marks) {
        *marks |= was_low && is_low(at);
        was_low = is_low(at);
    }
}

/// Rounds to a thousandth: more is not visible, and it makes a long path shorter to send.
fn rounded(number: f64) -> f64 {
    (number * 1000.0).round() / 1000.0
}
