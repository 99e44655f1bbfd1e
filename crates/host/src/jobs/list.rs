//! The list of jobs: order, copies and removal.

use dobot_api::{JobState, JobView, NewJob};
use dobot_journal::{Job, JobId, Journal};
use dobot_motion::Model;
use dobot_supervisor::{FORGETTABLE, Refusal};

use super::{check_made_for, find, journal_refusal, view};

/// Returns all jobs in order: oldest first, unless queued ones were moved; `current` replaces its
/// stored state.
pub(crate) fn list(journal: &Journal, current: Option<&JobView>) -> Result<Vec<JobView>, Refusal> {
    let jobs = journal.jobs().map_err(|error| journal_refusal(&error))?;
    let view = |job: &Job| match current {
        Some(current) if current.job == job.id.0 => current.clone(),
        _ => view(job),
    };
    Ok(jobs.iter().map(view).collect())
}

/// Queues a copy of a job.
pub(crate) fn again(journal: &Journal, job: u64, model: &Model) -> Result<NewJob, Refusal> {
    let job = find(journal, job)?;
    check_made_for(&job, model)?;
    let commands = journal.commands(job.id);
    Ok(NewJob {
        title: job.title,
        kind: job.kind,
        commands: commands.map_err(|error| journal_refusal(&error))?,
        lift_mm: job.lift_mm.unwrap_or(0.0),
        pauses: job.pauses,
        program: job.program,
    })
}

/// Moves a queued job before another queued one, or to the end.
pub(crate) fn move_before(journal: &Journal, job: u64, before: Option<u64>) -> Result<(), Refusal> {
    for job in before.into_iter().chain([job]) {
        check_queued(&find(journal, job)?)?;
    }
    let jobs = journal.jobs().map_err(|error| journal_refusal(&error))?;
    let queued = jobs.iter().filter(|job| job.state == JobState::Queued);
    let order = moved(queued.map(|job| job.id).collect(), JobId(job), before);
    let arranged = journal.arrange(&order);
    arranged.map_err(|error| journal_refusal(&error))
}

/// Removes a job that is over or has not started.
pub(crate) fn forget(journal: &Journal, job: u64) -> Result<(), Refusal> {
    let job = find(journal, job)?;
    if job.state.is_active() {
        return Err(Refusal::JobPhase {
            job: job.id.0,
            found: job.state.phase(),
            allowed: FORGETTABLE,
        });
    }
    let removed = journal.remove(job.id);
    removed.map_err(|error| journal_refusal(&error))
}

fn check_queued(job: &Job) -> Result<(), Refusal> {
    if job.state == JobState::Queued {
        return Ok(());
    }
    Err(Refusal::JobPhase {
        job: job.id.0,
        found: job.state.phase(),
        allowed: "queued",
    })
}

/// Returns the order with one job moved before another, or to the end.
fn moved(mut order: Vec<JobId>, job: JobId, before: Option<u64>) -> Vec<JobId> {
    if before == Some(job.0) {
        return order;
    }
    order.retain(|other| *other != job);
    let at = order.iter().position(|id| Some(id.0) == before);
    order.insert(at.unwrap_or(order.len()), job);
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_is_moved_before_another_one_or_to_the_end() {
        let order = |job, before| {
            let moved = moved(vec![JobId(3), JobId(5), JobId(8)], JobId(job), before);
            moved.iter().map(|id| id.0).collect::<Vec<_>>()
        };
        assert_eq!(order(8, Some(3)), [8, 3, 5]);
        assert_eq!(order(3, Some(8)), [5, 3, 8]);
        assert_eq!(order(3, None), [5, 8, 3]);
        assert_eq!(order(5, Some(5)), [3, 5, 8]);
    }
}
