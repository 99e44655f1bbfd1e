//! A disk that is full or fails: the journal reports it, loses nothing, and works again afterwards.

use crate::lab::{Disk, job};
use dobot_api::JobState;
use dobot_journal::{JobId, Journal, JournalError, Window};

#[test]
fn a_full_disk_refuses_a_new_job_and_keeps_the_old_ones() {
    let (disk, journal, id) = running_job();
    disk.hold(Some(disk.length()));
    let error = journal.submit(&job("too large", u16::MAX)).unwrap_err();
    assert!(matches!(error, JournalError::Full { .. }), "{error}");
    assert!(
        error
            .to_string()
            .starts_with("there is no room left for the journal")
    );

    let jobs = journal.jobs().unwrap();
    assert_eq!(jobs.len(), 1);
    assert_eq!(
        journal.commands(id).unwrap(),
        job("a picture", 100).commands
    );
    // A running job needs no room to continue.
    journal.extend_window(id, &window(8)).unwrap();

    disk.hold(None);
    journal.submit(&job("too large", u16::MAX)).unwrap();
    assert_eq!(journal.jobs().unwrap().len(), 2);
}

#[test]
fn a_disk_that_accepts_nothing_stops_the_job_and_nothing_is_lost() {
    let (disk, journal, id) = running_job();
    journal.extend_window(id, &window(8)).unwrap();
    disk.hold(Some(0));
    for _ in 0..3 {
        let error = journal.extend_window(id, &window(16)).unwrap_err();
        assert!(matches!(error, JournalError::Full { .. }), "{error}");
    }

    disk.hold(None);
    assert_eq!(journal.progress(id).unwrap(), window(8));
    journal.extend_window(id, &window(16)).unwrap();
    let left = disk.after_power_cut(|| false, 1.0);
    assert_eq!(open(&left).progress(id).unwrap(), window(16));
}

#[test]
fn a_failing_disk_is_distinguished_from_a_full_one() {
    let (disk, journal, id) = running_job();
    disk.cut_after(0);
    let error = journal.extend_window(id, &window(8)).unwrap_err();
    assert!(matches!(error, JournalError::Io { .. }), "{error}");
    assert_eq!(
        error.to_string(),
        "the storage of the journal in memory failed: the power is off"
    );
}

fn running_job() -> (Disk, Journal, JobId) {
    let disk = Disk::default();
    let journal = open(&disk);
    let id = journal.submit(&job("a picture", 100)).unwrap();
    journal.set_state(id, &JobState::Running).unwrap();
    (disk, journal, id)
}

fn open(disk: &Disk) -> Journal {
    let disk = disk.clone();
    Journal::with_backend(move || disk.clone()).unwrap()
}

fn window(upto: usize) -> Window {
    Window {
        upto,
        ..Window::default()
    }
}
