//! A program that is killed, again and again, on a real file.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::lab::job;
use dobot_api::JobState;
use dobot_journal::{JobId, Journal, Window};

#[test]
fn twenty_kills_lose_no_acknowledged_row() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("journal.redb");
    let mut acknowledged = BTreeMap::new();
    for round in 0..20 {
        let child = start(&path);
        read_and_kill(child, 1 + (round * 7) % 23, &mut acknowledged);
        check(&path, &acknowledged);
    }
    assert!(acknowledged.len() >= 20, "{} jobs", acknowledged.len());
}

/// The program to kill: it works on the journal forever and reports what was acknowledged.
#[test]
fn the_program_that_is_killed() {
    let Some(path) = std::env::var_os(PATH) else {
        return;
    };
    let journal = Journal::open(Path::new(&path)).unwrap();
    let mut out = std::io::stdout();
    writeln!(out).unwrap();
    loop {
        let id = journal.submit(&job("a picture", COMMANDS)).unwrap();
        writeln!(out, "{ACKNOWLEDGED} {id} 0").unwrap();
        journal.set_state(id, &JobState::Running).unwrap();
        for upto in 1..=usize::from(COMMANDS) {
            let completed = upto - 1;
            let window = Window {
                completed,
                upto,
                start: None,
            };
            journal.extend_window(id, &window).unwrap();
            writeln!(out, "{ACKNOWLEDGED} {id} {upto}").unwrap();
        }
    }
}

fn start(path: &Path) -> Child {
    Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "kill::the_program_that_is_killed", "--nocapture"])
        .env(PATH, path)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Reads the acknowledgements, kills the program after some of them, and reads the rest.
fn read_and_kill(mut child: Child, lines: usize, acknowledged: &mut BTreeMap<u64, usize>) {
    let out = BufReader::new(child.stdout.take().unwrap());
    let mut received = 0;
    for line in out.lines() {
        let line = line.unwrap();
        let Some(row) = line.strip_prefix(ACKNOWLEDGED) else {
            continue;
        };
        let mut numbers = row.split_whitespace().map(|number| number.parse().unwrap());
        let (id, upto) = (numbers.next().unwrap(), numbers.next().unwrap());
        acknowledged.insert(id, usize::try_from(upto).unwrap());
        received += 1;
        if received == lines {
            child.kill().unwrap();
        }
    }
    child.wait().unwrap();
    assert!(received >= lines, "the program ended by itself");
}

fn check(path: &Path, acknowledged: &BTreeMap<u64, usize>) {
    let journal = Journal::open(path).unwrap();
    assert!(!journal.was_clean());
    for (&id, &upto) in acknowledged {
        let found = journal.job(JobId(id)).unwrap();
        // One more may have been written without an acknowledgement.
        assert!((upto..=upto + 1).contains(&found.window.upto), "{found:?}");
        let commands = journal.commands(JobId(id)).unwrap();
        assert_eq!(commands, job("a picture", COMMANDS).commands);
    }
}

const PATH: &str = "DOBOT_JOURNAL_TO_BE_KILLED_AT";
const ACKNOWLEDGED: &str = "acknowledged";
const COMMANDS: u16 = 5;
