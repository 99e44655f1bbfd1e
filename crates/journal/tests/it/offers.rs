//! Answers to the offers of other stations are final.

use crate::lab::job;
use dobot_api::JobState;
use dobot_journal::{JobId, Journal, JournalError, Offered, PlannedJob};

fn offered(key: &str) -> PlannedJob {
    PlannedJob {
        key: Some(key.into()),
        ..job("a picture", 4)
    }
}

fn take(journal: &Journal, key: &str) -> Offered {
    journal.take(key, &offered(key)).unwrap()
}

fn taken(job: u64) -> Offered {
    Offered::Taken { job, left: None }
}

fn ended(journal: &Journal, job: u64) {
    journal.set_state(JobId(job), &JobState::Done).unwrap();
}

#[test]
fn a_job_offered_again_after_a_kill_is_the_existing_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let first = take(&Journal::open(&path).unwrap(), "a");
    let journal = Journal::open(&path).unwrap();
    assert_eq!(first, taken(1));
    assert_eq!(take(&journal, "a"), first);
    assert_eq!(journal.jobs().unwrap().len(), 1);
}

#[test]
fn an_arm_with_other_work_refuses_an_offer_and_never_accepts_it_later() {
    let journal = Journal::in_memory().unwrap();
    take(&journal, "a");
    let Offered::Refused { reason, busy: true } = take(&journal, "b") else {
        panic!("it has a job");
    };
    assert_eq!(reason, "job 1 is queued here");
    ended(&journal, 1);
    assert!(matches!(take(&journal, "b"), Offered::Refused { .. }));
    assert_eq!(take(&journal, "c"), taken(2));
}

#[test]
fn an_offer_refused_before_it_arrives_is_refused_on_arrival() {
    let journal = Journal::in_memory().unwrap();
    let refused = journal.refuse("a", "withdrawn by desk-1", false).unwrap();
    assert_eq!(take(&journal, "a"), refused);
    assert!(journal.jobs().unwrap().is_empty());
    // In the opposite order it is too late.
    take(&journal, "b");
    assert_eq!(journal.refuse("b", "too late", false).unwrap(), taken(1));
    assert_eq!(journal.offered("c").unwrap(), None);
}

#[test]
fn an_offer_of_a_deleted_job_is_answered_with_its_outcome() {
    let journal = Journal::in_memory().unwrap();
    take(&journal, "a");
    ended(&journal, 1);
    journal.remove(JobId(1)).unwrap();
    take(&journal, "b");
    ended(&journal, 2);
    journal.keep_last(0).unwrap();
    for (key, job) in [("a", 1), ("b", 2)] {
        let left = Some(JobState::Done);
        assert_eq!(take(&journal, key), Offered::Taken { job, left });
    }
    assert!(journal.jobs().unwrap().is_empty());
}

#[test]
fn a_job_withdrawn_before_it_begins_never_runs_and_a_running_one_continues() {
    let journal = Journal::in_memory().unwrap();
    take(&journal, "a");
    let reason = "withdrawn by desk-1".to_owned();
    assert_eq!(journal.withdraw("a", &reason).unwrap(), taken(1));
    let stopped = JobState::Stopped { reason };
    let late = journal.set_state(JobId(1), &JobState::Running);
    assert!(matches!(late, Err(JournalError::NotRunning { .. })));
    assert_eq!(journal.job(JobId(1)).unwrap().state, stopped);
    take(&journal, "b");
    journal.set_state(JobId(2), &JobState::Running).unwrap();
    journal.withdraw("b", "withdrawn by desk-1").unwrap();
    assert_eq!(journal.job(JobId(2)).unwrap().state, JobState::Running);
}
