//! A journal whose file is damaged while no program has it open.

use std::fs;
use std::path::Path;

use dobot_api::JobState;
use dobot_geometry::Random;
use dobot_journal::{Job, Journal, JournalError};
use dobot_wire::Command;

use crate::lab::job;

const CASES: u64 = 240;
const PAGE: usize = 4096;

/// All jobs with their commands.
fn content(journal: &Journal) -> Result<Vec<(Job, Vec<Command>)>, JournalError> {
    let jobs = journal.jobs()?.into_iter();
    jobs.map(|job| Ok((job.clone(), journal.commands(job.id)?)))
        .collect()
}

/// The bytes of a file in which one place is damaged, and how.
fn damaged(bytes: &[u8], older: &[u8], chance: &mut Random) -> (Vec<u8>, String) {
    let mut damaged = bytes.to_vec();
    let below =
        |chance: &mut Random, most: usize| usize::try_from(chance.number() % most as u64).unwrap();
    // Most of the file is empty: hit the written part.
    let page = loop {
        let page = below(chance, bytes.len() / PAGE) * PAGE;
        if bytes[page..][..PAGE].iter().any(|byte| *byte != 0) {
            break page;
        }
    };
    let what = match chance.number() % 4 {
        0 => {
            damaged[page..][..PAGE].fill(0);
            format!("page at {page} zeroed")
        }
        1 if page + PAGE <= older.len() => {
            damaged[page..][..PAGE].copy_from_slice(&older[page..][..PAGE]);
            format!("page at {page} is an old one")
        }
        2 => {
            // The head of the file determines which of the two newest writes is in force.
            let bit = below(chance, 320 * 8);
            damaged[bit / 8] ^= 1 << (bit % 8);
            format!("bit {bit} of the head flipped")
        }
        _ => {
            let bit = (page * 8) + below(chance, PAGE * 8);
            damaged[bit / 8] ^= 1 << (bit % 8);
            format!("bit {bit} flipped")
        }
    };
    (damaged, what)
}

#[test]
fn damage_never_loses_queued_work_silently() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let count = folder.path().join("journal.redb.writes");
    let journal = Journal::open(&path).unwrap();
    let first = journal.submit(&job("done before", 30)).unwrap();
    journal.set_state(first, &JobState::Running).unwrap();
    journal.submit(&job("queued", 300)).unwrap();
    let older = fs::read(&path).unwrap();
    journal.submit(&job("queued last", 40)).unwrap();
    let whole = content(&journal).unwrap();
    // As a kill leaves it, and as a program does that ended.
    let killed = fs::read(&path).unwrap();
    drop(journal);
    let ended = fs::read(&path).unwrap();
    let counted = fs::read(&count).unwrap();

    let (mut refused, mut reported) = (0, 0);
    for case in 0..CASES {
        let mut chance = Random::sequence(11, case);
        let bytes = if case % 2 == 0 { &killed } else { &ended };
        let (bytes, what) = damaged(bytes, &older, &mut chance);
        fs::write(&path, bytes).unwrap();
        fs::write(&count, &counted).unwrap();
        match open(&path) {
            Err(error) => {
                let text = error.to_string();
                assert!(text.contains("journal.redb"), "case {case}, {what}: {text}");
                refused += 1;
            }
            Ok((_, missing)) if missing > 0 => reported += 1,
            Ok((found, _)) => assert!(found == whole, "case {case}, {what}: jobs are missing"),
        }
    }
    assert!(
        refused > 10 && reported > 0,
        "refused {refused}, reported {reported}"
    );
}

/// Jobs with their commands.
type Kept = Vec<(Job, Vec<Command>)>;

fn open(path: &Path) -> Result<(Kept, u64), JournalError> {
    let journal = Journal::open(path)?;
    Ok((content(&journal)?, journal.missing_writes()))
}

#[test]
fn missing_writes_are_reported_at_each_start_until_a_clean_shutdown() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let journal = Journal::open(&path).unwrap();
    let copy = fs::read(&path).unwrap();
    for title in ["one", "two", "three"] {
        journal.submit(&job(title, 3)).unwrap();
    }
    assert_eq!(journal.missing_writes(), 0);
    drop(journal);
    assert_eq!(Journal::open(&path).unwrap().missing_writes(), 0);

    // A copy of before is put back: three jobs, and that it was opened again.
    fs::write(&path, copy).unwrap();
    assert_eq!(Journal::open(&path).unwrap().missing_writes(), 4);
    let journal = Journal::open(&path).unwrap();
    assert_eq!(journal.missing_writes(), 4, "after a crash");
    journal.note_clean_shutdown().unwrap();
    drop(journal);
    assert_eq!(Journal::open(&path).unwrap().missing_writes(), 0);
}

#[test]
fn a_new_journal_in_place_of_a_moved_one_misses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    Journal::open(&path)
        .unwrap()
        .submit(&job("one", 3))
        .unwrap();
    fs::rename(&path, folder.path().join("away")).unwrap();
    assert_eq!(Journal::open(&path).unwrap().missing_writes(), 0);
}

#[test]
fn a_missing_or_damaged_count_is_harmless() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let count = folder.path().join("journal.redb.writes");
    Journal::open(&path)
        .unwrap()
        .submit(&job("one", 3))
        .unwrap();
    for content in [
        &b""[..],
        b"\xff\xfe",
        b"00000000000000000009 00000000000000000001\n",
    ] {
        fs::write(&count, content).unwrap();
        let journal = Journal::open(&path).unwrap();
        assert_eq!(journal.missing_writes(), 0);
        assert_eq!(journal.jobs().unwrap().len(), 1);
    }
    fs::remove_file(&count).unwrap();
    fs::create_dir(&count).unwrap();
    let journal = Journal::open(&path).unwrap();
    journal.submit(&job("two", 3)).unwrap();
    assert_eq!(journal.missing_writes(), 0);
}
