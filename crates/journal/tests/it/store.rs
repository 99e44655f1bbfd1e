//! The promises of the journal on a disk that works.

use std::fs;

use crate::lab::{START, job, vector};
use dobot_api::{Answer, AskingProgram, JobPause, JobProgram, JobState};
use dobot_journal::{
    Adjustment, HeightChange, JobExtension, JobHistory, JobId, Journal, JournalError, PlannedJob,
    Window,
};
use dobot_wire::{Command, Configuration, Dialect, Status};
use proptest::prelude::*;

#[test]
fn a_job_survives_closing_and_opening_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let wanted = job("a picture", 40);
    let window = Window {
        completed: 3,
        upto: 17,
        start: Some(START),
    };
    let paused = JobState::Paused {
        reason: "the arm was unplugged".into(),
    };
    let id = {
        let journal = Journal::open(&path).unwrap();
        let id = running(&journal, &wanted);
        journal.extend_window(id, &window).unwrap();
        journal.set_state(id, &paused).unwrap();
        id
    };

    let journal = Journal::open(&path).unwrap();
    let found = journal.job(id).unwrap();
    assert_eq!(journal.jobs().unwrap(), vec![found.clone()]);
    assert_eq!(journal.commands(id).unwrap(), wanted.commands);
    assert_eq!(journal.progress(id).unwrap(), window);
    assert_eq!(found.title, wanted.title);
    assert_eq!(found.kind, wanted.kind);
    assert_eq!(found.dialect, wanted.dialect);
    assert_eq!(found.lift_mm, wanted.lift_mm);
    assert_eq!(found.created_ms, wanted.created_ms);
    assert_eq!(found.commands, wanted.commands.len());
    assert_eq!(found.state, paused);
}

#[test]
fn a_running_job_gets_the_commands_that_follow_an_answer() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let (mut wanted, mut longer) = (job("sorting", 4), job("sorting", 9));
    wanted.program = asking(&[]);
    longer.program = asking(&["red"]);
    longer.pauses.push(JobPause {
        before: 6,
        message: "empty the bin".into(),
    });
    let extension = JobExtension {
        commands: longer.commands.clone(),
        pauses: longer.pauses.clone(),
        program: longer.program.clone(),
    };
    let id = {
        let journal = Journal::open(&path).unwrap();
        let id = running(&journal, &wanted);
        let window = |completed, upto| Window {
            completed,
            upto,
            start: Some(START),
        };
        journal.extend_window(id, &window(2, 4)).unwrap();
        journal.extend_window(id, &window(4, 9)).unwrap_err();
        journal.extend(id, &extension).unwrap();
        journal.extend_window(id, &window(4, 9)).unwrap();
        id
    };
    let journal = Journal::open(&path).unwrap();
    let found = journal.job(id).unwrap();
    assert_eq!(journal.commands(id).unwrap(), longer.commands);
    assert_eq!(found.program, longer.program);
    assert_eq!(found.pauses, longer.pauses);

    let other = JobExtension {
        commands: longer.commands[1..].to_vec(),
        ..extension.clone()
    };
    let error = journal.extend(id, &other).unwrap_err();
    assert!(matches!(error, JournalError::Shorter(_)), "{error}");
    journal.set_state(id, &JobState::Done).unwrap();
    let error = journal.extend(id, &extension).unwrap_err();
    assert!(matches!(error, JournalError::NotRunning { .. }), "{error}");
}

/// A program with these answers.
fn asking(answers: &[&str]) -> JobProgram {
    let answers = answers
        .iter()
        .map(|answer| Answer::Choice((*answer).to_owned()));
    JobProgram {
        steps: vec![0, 2],
        lines: vec![1, 4],
        asking: Some(Box::new(AskingProgram {
            text: "[[steps]]".into(),
            answers: answers.collect(),
            ..AskingProgram::default()
        })),
        ..JobProgram::default()
    }
}

#[test]
fn only_the_journal_and_the_count_of_its_writes_are_left_in_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    let names = fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<_> = names.map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["journal.redb", "journal.redb.writes"]);
    drop(journal);
}

#[cfg(unix)]
#[test]
fn the_jobs_are_readable_by_their_owner_only() {
    use std::os::unix::fs::PermissionsExt;

    let folder = tempfile::tempdir().unwrap();
    let _journal = Journal::open(&folder.path().join("journal.redb")).unwrap();
    for file in ["journal.redb", "journal.redb.writes"] {
        let mode = fs::metadata(folder.path().join(file))
            .unwrap()
            .permissions();
        assert_eq!(mode.mode() & 0o777, 0o600, "{file}");
    }
}

#[test]
fn a_clean_shutdown_is_distinguished_from_a_crash() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let first = Journal::open(&path).unwrap();
    assert!(first.was_clean(), "there is no earlier data");
    drop(first);

    let after_crash = Journal::open(&path).unwrap();
    assert!(!after_crash.was_clean());
    after_crash.note_clean_shutdown().unwrap();
    drop(after_crash);

    assert!(Journal::open(&path).unwrap().was_clean());
    assert!(!Journal::open(&path).unwrap().was_clean());
}

#[test]
fn the_number_of_a_removed_job_is_not_reused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    let first = journal.submit(&job("one", 2)).unwrap();
    journal.remove(first).unwrap();
    drop(journal);

    let journal = Journal::open(&path).unwrap();
    assert_ne!(journal.submit(&job("two", 2)).unwrap(), first);
    for error in [
        journal.job(first).unwrap_err(),
        journal.commands(first).unwrap_err(),
        journal.progress(first).unwrap_err(),
        journal.remove(first).unwrap_err(),
        journal.set_state(first, &JobState::Done).unwrap_err(),
        journal
            .extend_window(first, &Window::default())
            .unwrap_err(),
    ] {
        assert!(matches!(error, JournalError::NoSuchJob(id) if id == first));
    }
}

#[test]
fn reordered_jobs_exchange_their_places_and_keep_them_when_the_file_is_opened_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    let ids: Vec<JobId> = ["one", "two", "three", "four"]
        .map(|title| journal.submit(&job(title, 2)).unwrap())
        .into();
    let [one, two, three, four] = ids[..] else {
        panic!("there are four");
    };
    journal.arrange(&[four, one, three]).unwrap();
    drop(journal);

    let journal = Journal::open(&path).unwrap();
    let order = || {
        let jobs = journal.jobs().unwrap();
        jobs.iter().map(|job| job.id).collect::<Vec<_>>()
    };
    assert_eq!(order(), [four, two, one, three]);
    let five = journal.submit(&job("five", 2)).unwrap();
    assert_eq!(order(), [four, two, one, three, five]);
    journal.remove(two).unwrap();
    assert!(matches!(
        journal.arrange(&[one, two]),
        Err(JournalError::NoSuchJob(id)) if id == two
    ));
    assert_eq!(order(), [four, one, three, five]);
}

#[test]
fn history_is_bounded_and_unfinished_jobs_stay() {
    let journal = Journal::in_memory().unwrap();
    let failed = JobState::Failed { reason: "x".into() };
    let stopped = JobState::Stopped { reason: "x".into() };
    let paused = JobState::Paused { reason: "x".into() };
    let states = [
        JobState::Done,
        paused,
        failed,
        JobState::Queued,
        stopped,
        JobState::Running,
        JobState::Done,
    ];
    let ids: Vec<JobId> = states
        .iter()
        .map(|state| in_state(&journal, state))
        .collect();

    assert_eq!(journal.keep_last(2).unwrap(), 2);
    let left: Vec<JobId> = journal.jobs().unwrap().iter().map(|job| job.id).collect();
    assert_eq!(left, [ids[1], ids[3], ids[4], ids[5], ids[6]]);
    assert_eq!(journal.keep_last(2).unwrap(), 0);
    assert!(matches!(
        journal.remove(ids[5]).unwrap_err(),
        JournalError::Unfinished { .. }
    ));
}

#[test]
fn a_window_neither_leaves_its_job_nor_goes_back() {
    let journal = Journal::in_memory().unwrap();
    let id = running(&journal, &job("a picture", 10));
    journal.extend_window(id, &window(4, 9)).unwrap();
    for wrong in [window(3, 9), window(5, 11), window(6, 5)] {
        let error = journal.extend_window(id, &wrong).unwrap_err();
        assert!(
            matches!(
                error,
                JournalError::Window {
                    done: 4,
                    commands: 10,
                    ..
                }
            ),
            "{error}"
        );
    }
    assert_eq!(journal.progress(id).unwrap(), window(4, 9));
    // After a crash it is known that commands 7 and 8 were not done.
    journal.extend_window(id, &window(7, 7)).unwrap();
    journal.set_state(id, &JobState::Done).unwrap();
    let error = journal.extend_window(id, &window(7, 9)).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!("job {id} is done; only a running job may get commands")
    );
}

#[test]
fn a_command_that_fits_no_packet_is_refused_with_its_place() {
    let journal = Journal::in_memory().unwrap();
    let with = |command: Command| {
        let mut job = job("a picture", 3);
        job.commands[2] = command;
        journal.submit(&job).unwrap_err().to_string()
    };
    assert_eq!(
        with(vector(f32::NAN, 0.0, 1.0)),
        "command 2 of the job cannot be sent: float 3 (X) is NaN; Table 2.6 allows a finite number"
    );
    let angles = Configuration::InitialAngles {
        rear_deg: 0.1,
        fore_deg: 45.0,
    };
    assert!(with(angles.into()).starts_with("command 2 of the job reads differently"));
    for lift in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let job = PlannedJob {
            lift_mm: Some(lift),
            ..job("a picture", 3)
        };
        assert!(matches!(journal.submit(&job), Err(JournalError::Lift(_))));
    }
    assert_eq!(journal.jobs().unwrap(), []);
}

#[test]
fn a_start_that_no_status_can_hold_is_refused() {
    let journal = Journal::in_memory().unwrap();
    let id = running(&journal, &job("a picture", 3));
    let start = Status {
        z_mm: f32::NAN,
        ..START
    };
    let wrong = Window {
        start: Some(start),
        ..window(0, 2)
    };
    assert!(matches!(
        journal.extend_window(id, &wrong).unwrap_err(),
        JournalError::Start { .. }
    ));
    assert_eq!(journal.progress(id).unwrap(), Window::default());
}

#[test]
fn a_journal_that_is_open_is_not_opened_twice() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let first = Journal::open(&path).unwrap();
    assert!(matches!(
        Journal::open(&path).unwrap_err(),
        JournalError::InUse { .. }
    ));
    first.submit(&job("one", 2)).unwrap();
}

#[test]
fn a_file_of_another_program_is_named_and_not_touched() {
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in [
        (
            "letter.txt",
            &b"Dear journal, this is a letter and no database"[..],
        ),
        ("empty", &b""[..]),
        ("short", &b"redb"[..]),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, content).unwrap();
        let error = Journal::open(&path).unwrap_err();
        assert!(matches!(error, JournalError::Foreign { .. }), "{error}");
        assert!(error.to_string().contains(name), "{error}");
        let is_reported = !content.is_empty() || error.to_string().contains("it is empty");
        assert!(is_reported, "{error}");
        assert_eq!(fs::read(&path).unwrap(), content);
    }
}

#[test]
fn a_database_of_another_program_is_named_and_not_touched() {
    const TABLE: redb::TableDefinition<'_, u64, u64> = redb::TableDefinition::new("jobs");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("other.redb");
    let other = redb::Database::create(&path).unwrap();
    let change = other.begin_write().unwrap();
    change.open_table(TABLE).unwrap().insert(1, 2).unwrap();
    change.commit().unwrap();
    drop(other);

    let error = Journal::open(&path).unwrap_err();
    assert!(matches!(error, JournalError::Foreign { .. }), "{error}");
    let other = redb::Database::open(&path).unwrap();
    let table = redb::ReadableDatabase::begin_read(&other).unwrap();
    let table = table.open_table(TABLE).unwrap();
    assert_eq!(table.get(1).unwrap().unwrap().value(), 2);
}

#[test]
fn a_journal_of_a_newer_version_is_not_touched() {
    const FACTS: redb::TableDefinition<'_, &str, u64> = redb::TableDefinition::new("dobot journal");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    drop(Journal::open(&path).unwrap());
    let newer = redb::Database::open(&path).unwrap();
    let change = newer.begin_write().unwrap();
    change
        .open_table(FACTS)
        .unwrap()
        .insert("format", 7)
        .unwrap();
    change.commit().unwrap();
    drop(newer);

    let error = Journal::open(&path).unwrap_err();
    assert!(
        matches!(
            error,
            JournalError::Newer {
                found: 7,
                known: 6,
                ..
            }
        ),
        "{error}"
    );
}

#[test]
fn a_journal_of_the_first_format_is_read_and_continued() {
    const FACTS: redb::TableDefinition<'_, &str, u64> = redb::TableDefinition::new("dobot journal");
    const JOBS: redb::TableDefinition<'_, u64, &[u8]> = redb::TableDefinition::new("jobs");
    const ROW: &str = r#"{"title":"a picture","kind":"drawing","dialect":"firmware-1.1",
        "lift_mm":5.0,"created_ms":7,"commands":3,"state":{"state":"paused","reason":"x"}}"#;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let id = Journal::open(&path).unwrap().submit(&job("", 3)).unwrap();
    let older = redb::Database::open(&path).unwrap();
    let change = older.begin_write().unwrap();
    let mut facts = change.open_table(FACTS).unwrap();
    facts.insert("format", 1).unwrap();
    drop(facts);
    let mut jobs = change.open_table(JOBS).unwrap();
    jobs.insert(id.0, ROW.as_bytes()).unwrap();
    drop(jobs);
    change.commit().unwrap();
    drop(older);

    let journal = Journal::open(&path).unwrap();
    let found = journal.job(id).unwrap();
    assert_eq!((found.title.as_str(), found.commands), ("a picture", 3));
    assert_eq!(found.adjustment, Adjustment::default());
    assert_eq!((found.planned_s, found.history.ran_s), (None, None));
    journal.set_state(id, &JobState::Running).unwrap();
    assert_eq!(journal.job(id).unwrap().state, JobState::Running);
}

#[test]
fn changes_by_a_person_and_the_progress_of_a_job_are_restored() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    let pauses = vec![pause(0), pause(2)];
    let wanted = PlannedJob {
        planned_s: Some(12.5),
        pauses: pauses.clone(),
        program: dobot_api::JobProgram::default(),
        ..job("a picture", 3)
    };
    let id = journal.submit(&wanted).unwrap();
    let adjustment = Adjustment {
        speed_percent: 62.5,
        heights: vec![HeightChange {
            from: 2,
            begin_mm: 0.1,
            offset_mm: -0.3,
        }],
    };
    journal.adjust(id, &adjustment).unwrap();
    let reason = "the blue pen".to_owned();
    let history = JobHistory {
        pauses: 1,
        ran_s: Some(3.25),
    };
    let paused = JobState::Paused { reason };
    journal
        .set_state_with_history(id, &paused, history)
        .unwrap();
    drop(journal);
    let found = Journal::open(&path).unwrap().job(id).unwrap();
    assert_eq!((found.planned_s, found.pauses), (Some(12.5), pauses));
    assert_eq!(found.adjustment, adjustment);
    assert_eq!((found.state, found.history), (paused, history));
}

#[test]
fn an_invalid_pause_is_refused_with_the_allowed_places() {
    let journal = Journal::in_memory().unwrap();
    for (pauses, text) in [
        (
            vec![pause(3)],
            "pause 0 of the job is before command 3; allowed are 0 to 2",
        ),
        (
            vec![pause(1), pause(1)],
            "pause 1 of the job is before command 1; allowed are 2 to 2",
        ),
    ] {
        let job = PlannedJob {
            pauses,
            ..job("a picture", 3)
        };
        assert_eq!(journal.submit(&job).unwrap_err().to_string(), text);
    }
}

#[test]
fn a_repeated_request_queues_one_job_even_after_a_crash() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let asked = |key: &str, title: &str| PlannedJob {
        key: Some(key.into()),
        ..job(title, 3)
    };
    let first = {
        let journal = Journal::open(&path).unwrap();
        let first = journal.submit(&asked("7f", "a")).unwrap();
        assert_eq!(journal.submit(&asked("7f", "a")).unwrap(), first);
        first
    };
    let journal = Journal::open(&path).unwrap();
    assert_eq!(journal.submit(&asked("7f", "a")).unwrap(), first);
    assert_ne!(journal.submit(&asked("80", "a")).unwrap(), first);
    assert_ne!(journal.submit(&job("a picture", 3)).unwrap(), first);
    let error = journal.submit(&asked("7f", "b")).unwrap_err();
    assert!(matches!(error, JournalError::KeyReused { job, .. } if job == first));
    // A removed job can be requested again.
    journal.remove(first).unwrap();
    assert_ne!(journal.submit(&asked("7f", "b")).unwrap(), first);
    assert_eq!(journal.jobs().unwrap().len(), 3);
}

#[test]
fn a_speed_that_is_not_finite_is_refused() {
    let journal = Journal::in_memory().unwrap();
    let id = journal.submit(&job("a picture", 3)).unwrap();
    for speed_percent in [f64::NAN, f64::INFINITY] {
        let adjustment = Adjustment {
            speed_percent,
            ..Adjustment::default()
        };
        let refused = journal.adjust(id, &adjustment).unwrap_err().to_string();
        assert!(refused.starts_with("the speed of the job is "), "{refused}");
    }
    assert_eq!(journal.job(id).unwrap().adjustment, Adjustment::default());
}

fn pause(before: usize) -> JobPause {
    JobPause {
        before,
        message: "change the pen".into(),
    }
}

#[test]
fn a_truncated_journal_is_reported_and_not_touched() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    journal.submit(&job("one", 2000)).unwrap();
    drop(journal);
    let content = fs::read(&path).unwrap();
    for len in [content.len() / 2, 4096, 100] {
        fs::write(&path, &content[..len]).unwrap();
        let error = Journal::open(&path).unwrap_err();
        assert!(
            matches!(error, JournalError::Damaged { .. }),
            "{len}: {error}"
        );
        assert_eq!(fs::read(&path).unwrap(), &content[..len]);
    }
}

#[test]
fn an_unfinished_new_journal_left_by_a_crash_is_harmless() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    fs::write(folder.path().join("journal.redb.new"), [0; 5000]).unwrap();
    let journal = Journal::open(&path).unwrap();
    journal.submit(&job("one", 2)).unwrap();
    drop(journal);
    assert_eq!(Journal::open(&path).unwrap().jobs().unwrap().len(), 1);
}

proptest! {
    #[test]
    fn every_job_is_restored_bit_by_bit(
        title in ".{0,80}",
        created_ms in any::<i64>(),
        lift_mm in proptest::option::of(1e-30_f32..1e30),
        increments in proptest::collection::vec(
            (-1e6_f32..1e6, -1e6_f32..1e6, 0.001_f32..1e6), 0..40),
        firmware in any::<bool>(),
    ) {
        let wanted = PlannedJob {
            title,
            created_ms,
            lift_mm,
            calibration: dobot_arm::Calibration::NONE,
            dialect: Dialect::ALL[usize::from(firmware)],
            commands: increments.iter().map(|&(x, y, z)| vector(x, y, z)).collect(),
            ..job("", 0)
        };
        let journal = Journal::in_memory().unwrap();
        let id = journal.submit(&wanted).unwrap();
        let found = journal.job(id).unwrap();
        prop_assert_eq!(journal.commands(id).unwrap(), wanted.commands);
        prop_assert_eq!(found.title, wanted.title);
        prop_assert_eq!(found.created_ms, wanted.created_ms);
        prop_assert_eq!(found.lift_mm, wanted.lift_mm);
        prop_assert_eq!(found.dialect, wanted.dialect);
    }
}

fn running(journal: &Journal, job: &PlannedJob) -> JobId {
    let id = journal.submit(job).unwrap();
    journal.set_state(id, &JobState::Running).unwrap();
    id
}

fn in_state(journal: &Journal, state: &JobState) -> JobId {
    let id = journal.submit(&job("one", 2)).unwrap();
    journal.set_state(id, state).unwrap();
    id
}

const fn window(completed: usize, upto: usize) -> Window {
    Window {
        completed,
        upto,
        start: None,
    }
}
