//! `dobot log` and `dobot replay`.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{About, Limits, Record, Recorder, Topic, recordings};
use dobot_wire::{Dialect, MoveTo, Status};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::program::{Outcome, command, dobot};

/// Rear arm upright, forearm level.
fn status() -> [u8; 42] {
    let status = Status {
        suction: true,
        ..Status::AT_ZERO
    };
    status.emit().to_bytes()
}

fn target(x_mm: f32) -> [u8; 42] {
    let target = MoveTo::to(x_mm, 0.0, 20.0);
    target.emit(&Dialect::SPECIFICATION).to_bytes()
}

/// Three statuses, each answered, and an event: a fifth of a second.
pub(crate) fn recording() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("there is room");
    let about = About {
        program: "dobot 0.1.0".to_owned(),
        address: "virtual:".to_owned(),
        dialect: Some(Dialect::SPECIFICATION),
        personality: None,
    };
    let start = "2026-11-21T12:30:00Z".parse().expect("it is a time");
    let recorder = Recorder::start(folder.path(), Limits::DEFAULT, about, start);
    let recorder = recorder.expect("the limits are good");
    for (n, x_mm) in [200.0, 210.0, 220.0].into_iter().enumerate() {
        let at = Duration::from_millis(1000 + 80 * n as u64);
        recorder.record(at, Record::FromArm(status().to_vec()));
        recorder.record(at, Record::ToArm(target(x_mm).to_vec()));
    }
    let topic = Topic::new("/events", "dobot.Event", &json!({ "type": "object" }));
    let topic = Arc::new(topic.expect("it is one"));
    let value = json!({ "type": "stopped" });
    recorder.record(Duration::from_millis(1200), Record::Json { topic, value });
    assert_eq!(recorder.finish().lost, 0);
    let file = recordings(folder.path()).expect("it is there").remove(0);
    (folder, file.path)
}

pub(crate) fn text(path: &Path) -> &str {
    path.to_str().expect("the path is text")
}

#[test]
fn the_recordings_of_a_folder_are_listed_and_found_by_their_names() {
    let (folder, file) = recording();
    let in_folder = ["--recordings", text(folder.path())];
    let outcome = dobot(&[&["log"][..], &in_folder].concat()).succeeds();
    assert!(
        outcome.stdout.starts_with("2026-11-21T12:30:01Z"),
        "{outcome:?}"
    );
    assert!(outcome.stdout.contains(text(&file)), "{outcome:?}");
    let outcome = dobot(&[&["log", "--json"][..], &in_folder].concat()).succeeds();
    let listed: Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    assert_eq!(listed["file"], text(&file));
    let name = "dobot-2026-11-21T12-30-01Z.mcap";
    dobot(&[&["log", name][..], &in_folder].concat()).succeeds();
    dobot(&[&["log", "other.mcap"][..], &in_folder].concat())
        .fails(1, &["no file other.mcap", "run `dobot log`"]);
}

#[test]
fn packets_and_events_are_listed_with_their_times() {
    let (_folder, file) = recording();
    let outcome = dobot(&["log", text(&file)]).succeeds();
    let lines: Vec<&str> = outcome.stdout.lines().collect();
    assert_eq!(lines.len(), 8, "{outcome:?}");
    assert!(
        lines[0].contains("arm virtual:, dialect specification"),
        "{}",
        lines[0]
    );
    for (line, parts) in [
        (
            lines[1],
            ["1.000", "/wire/from_arm", "status", "suction on"],
        ),
        (lines[4], ["1.080", "/wire/to_arm", "move_to", "x 210 mm"]),
        (lines[7], ["1.200", "/events", "type", "stopped"]),
    ] {
        for part in parts {
            assert!(line.contains(part), "`{part}` is missing: {line}");
        }
    }
}

#[test]
fn a_part_of_a_recording_is_chosen_by_time_and_topic() {
    let (_folder, file) = recording();
    let chosen = [
        "--since",
        "1.05",
        "--until",
        "1.1",
        "--topic",
        "/wire/to_arm",
    ];
    let outcome = dobot(&[&["log", text(&file), "--json"][..], &chosen].concat()).succeeds();
    let lines: Vec<Value> = outcome
        .stdout
        .lines()
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect();
    assert_eq!(lines.len(), 2, "{outcome:?}");
    assert_eq!(lines[0]["start"], "2026-11-21T12:30:00Z");
    assert_eq!(lines[1]["at_s"], 1.08);
    assert_eq!(lines[1]["command"]["x_mm"], 210.0);
    let joints = dobot(&["log", text(&file), "--topic", "/arm/joints"]).succeeds();
    // The pose never changes.
    assert_eq!(joints.stdout.matches("base_deg").count(), 1, "{joints:?}");
}

#[test]
fn a_truncated_file_is_listed_up_to_its_end() {
    let (_folder, file) = recording();
    let bytes = std::fs::read(&file).expect("it is there");
    // Into the index after all events.
    std::fs::write(&file, &bytes[..bytes.len() - 20]).expect("there is room");
    let outcome = dobot(&["log", text(&file)]).succeeds();
    assert!(outcome.stdout.contains("stopped"), "{outcome:?}");
    assert!(
        outcome.stdout.contains("the file is damaged: only"),
        "{outcome:?}"
    );
}

#[test]
fn a_recording_in_progress_is_reported_as_such() {
    let folder = tempfile::tempdir().expect("there is room");
    let start = "2026-11-21T12:30:00Z".parse().expect("it is a time");
    let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start);
    let recorder = recorder.expect("the limits are good");
    recorder.record(Duration::ZERO, Record::ToArm(target(200.0).to_vec()));
    let file = loop {
        if let Some(file) = recorder.health().file {
            break file;
        }
        std::thread::yield_now();
    };
    let in_folder = ["log", "--recordings", text(folder.path())];
    let listed = dobot(&in_folder).succeeds();
    assert!(listed.stdout.contains("being written"), "{listed:?}");
    let listed = dobot(&[&in_folder[..], &["--json"]].concat()).succeeds();
    assert!(
        listed.stdout.contains("\"being_written\":true"),
        "{listed:?}"
    );
    let outcome = dobot(&["log", text(&file)]).succeeds();
    let expected = "the recording is still being written; this is what it contains now";
    assert!(outcome.stdout.contains(expected), "{outcome:?}");
    assert!(!outcome.stdout.contains("damaged"), "{outcome:?}");
    let outcome = dobot(&["log", text(&file), "--json"]).succeeds();
    assert!(
        outcome.stdout.contains("\"being_written\":true"),
        "{outcome:?}"
    );
    assert!(recorder.finish().trouble.is_none());
    let outcome = dobot(&["log", text(&file)]).succeeds();
    assert!(!outcome.stdout.contains("being written"), "{outcome:?}");
}

#[test]
fn a_file_that_is_not_a_recording_is_reported() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("capture.bin");
    std::fs::write(&file, target(200.0)).expect("there is room");
    for verb in ["log", "replay"] {
        dobot(&[verb, text(&file)]).fails(1, &["capture.bin", "not a recording", "dobot decode"]);
    }
    dobot(&["log", text(&file), "--since", "noon"]).fails(2, &["0 to 1000000000 seconds"]);
    dobot(&["replay", text(&file), "--time-factor", "0"]).fails(2, &["0.1 to 1000"]);
}

/// Replays a recording to a client that sends these bytes after the first status, and reads to the
/// end.
fn replayed(file: &Path, bytes: &[u8]) -> (Outcome, Vec<u8>) {
    let mut child = command(&[
        "replay",
        text(file),
        "--tcp",
        "127.0.0.1:0",
        "--time-factor",
        "10",
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    let mut output = BufReader::new(child.stdout.take().expect("it is piped"));
    let mut line = String::new();
    output.read_line(&mut line).expect("it prints its address");
    let address = line
        .split_whitespace()
        .next()
        .expect("an address comes first");
    let mut client = TcpStream::connect(&address[4..]).expect("it is served");
    let mut received = vec![0; 42];
    client.read_exact(&mut received).expect("a status comes");
    client.write_all(bytes).expect("it is open");
    client.read_to_end(&mut received).expect("it ends in order");
    let _ = client.shutdown(Shutdown::Both);
    drop(client);
    let mut stdout = String::new();
    output.read_to_string(&mut stdout).expect("it is text");
    let mut outcome = Outcome::from(child.wait_with_output().expect("it ends"));
    outcome.stdout = stdout;
    (outcome, received)
}

#[test]
fn a_client_that_acts_as_recorded_succeeds_and_gets_all_statuses() {
    let (_folder, file) = recording();
    let same = [target(200.0), target(210.0), target(220.0)].concat();
    let (outcome, received) = replayed(&file, &same);
    assert_eq!(received, status().repeat(3));
    let outcome = outcome.succeeds();
    assert!(
        outcome.stdout.contains("3 packets as recorded"),
        "{outcome:?}"
    );
}

#[test]
fn a_client_that_acts_differently_fails_with_both_sides() {
    let (_folder, file) = recording();
    let other = [target(200.0), target(211.0)].concat();
    let (outcome, _) = replayed(&file, &other);
    let outcome = outcome.fails(1, &["2 packets were not sent as recorded"]);
    for part in [
        "sent      move_to  x 211 mm",
        "recorded  move_to  x 210 mm",
        "sent      nothing",
    ] {
        assert!(
            outcome.stdout.contains(part),
            "`{part}` is missing: {outcome:?}"
        );
    }
}

/// Exports a recording in this format and returns the error.
pub(crate) fn export_tables(form: &str) {
    let (folder, file) = recording();
    let out = |name: &str| folder.path().join(name);
    let statuses = out(&format!("run.{form}"));
    let export = ["log", text(&file), "--export", form, "-o", text(&statuses)];
    let outcome = dobot(&export).succeeds();
    assert!(outcome.stdout.contains("3 statuses"), "{outcome:?}");
    assert!(outcome.stdout.contains("3 commands"), "{outcome:?}");
    assert!(out(&format!("run.commands.{form}")).exists());
    // Existing files are kept by default.
    std::fs::write(&statuses, "mine").expect("there is room");
    dobot(&export).fails(1, &["exists", "hint: overwrite it with `--force`"]);
    assert_eq!(std::fs::read(&statuses).expect("it is there"), b"mine");
    dobot(&[&export[..], &["--force"]].concat()).succeeds();
    assert_ne!(std::fs::read(&statuses).expect("it is there"), b"mine");
    // The other table is in the way: neither is begun.
    std::fs::remove_file(&statuses).expect("it is there");
    dobot(&export).fails(1, &["commands", "exists"]);
    assert!(!statuses.exists());
}

#[test]
fn a_recording_is_exported_as_tables() {
    export_tables("csv");
}

#[test]
fn a_failed_export_is_reported_and_writes_nothing() {
    let (folder, file) = recording();
    let out = folder.path().join("run.csv");
    let export = |file: &Path, more: &[&str]| {
        dobot(
            &[
                &["log", text(file), "--export", "csv", "-o", text(&out)],
                more,
            ]
            .concat(),
        )
    };
    export(&file, &["--since", "100"]).fails(1, &["contains no packet", "hint: run `dobot log"]);
    export(&file, &["--task", "Turn."]).fails(2, &["--task", "only a dataset"]);
    export(&file, &["--json"]).fails(2, &["--json"]);
    let other = folder.path().join("other.mcap");
    std::fs::write(&other, "no recording").expect("there is room");
    export(&other, &[]).fails(1, &["other.mcap", "not a recording"]);
    std::fs::write(&other, "").expect("there is room");
    export(&other, &[]).fails(1, &["other.mcap"]);
    export(Path::new("nowhere.mcap"), &[]).fails(1, &["no file nowhere.mcap"]);
    assert!(!out.exists());
    // Not even with --force.
    let whole = std::fs::read(&file).expect("it is there");
    let itself = [
        "log",
        text(&file),
        "--export",
        "csv",
        "--force",
        "-o",
        text(&file),
    ];
    dobot(&itself).fails(1, &["is the recording itself"]);
    assert_eq!(std::fs::read(&file).expect("it is there"), whole);
    dobot(&["log", "--export", "csv"]).fails(2, &["FILE"]);
}

#[test]
fn the_readable_part_of_a_damaged_recording_is_exported() {
    let (folder, file) = recording();
    let bytes = std::fs::read(&file).expect("it is there");
    std::fs::write(&file, &bytes[..bytes.len() - 20]).expect("there is room");
    let out = folder.path().join("run.csv");
    let outcome = dobot(&["log", text(&file), "--export", "csv", "-o", text(&out)]).succeeds();
    assert!(outcome.stderr.contains("warning: "), "{outcome:?}");
    assert!(outcome.stderr.contains("only"), "{outcome:?}");
    assert_eq!(
        std::fs::read_to_string(&out)
            .expect("it is there")
            .lines()
            .count(),
        4
    );
}

#[test]
fn a_recording_that_was_cut_off_is_repaired_in_place_and_a_whole_one_is_left_alone() {
    let (folder, file) = recording();
    let whole = std::fs::read(&file).expect("it is there");
    let outcome = dobot(&["log", text(&file), "--repair"]).succeeds();
    assert!(outcome.stdout.contains("complete"), "{outcome:?}");
    assert_eq!(std::fs::read(&file).expect("it is there"), whole);
    // Without the index and the end mark.
    std::fs::write(&file, &whole[..whole.len() - 40]).expect("there is room");
    let unreadable = folder.path().join("dobot-2026-11-21T12-29-00Z.mcap");
    std::fs::write(&unreadable, &whole[..8]).expect("there is room");
    let all = ["log", "--repair", "--recordings", text(folder.path())];
    let outcome = dobot(&all).fails(
        1,
        &["12-29-00Z.mcap", "nothing in the recording can be read"],
    );
    assert!(outcome.stdout.contains("repaired"), "{outcome:?}");
    let outcome = dobot(&["log", text(&file)]).succeeds();
    assert!(!outcome.stdout.contains("damaged"), "{outcome:?}");
    assert!(outcome.stdout.contains("move_to"), "{outcome:?}");
}

#[test]
fn a_recording_that_is_being_written_is_copied_as_a_complete_one() {
    let (folder, file) = recording();
    let whole = std::fs::read(&file).expect("it is there");
    std::fs::write(&file, &whole[..whole.len() - 40]).expect("there is room");
    let writer = std::fs::File::open(&file).expect("it is there");
    writer.lock().expect("nobody else has it");
    dobot(&["log", text(&file), "--repair"]).fails(1, &["being written", "--export mcap"]);
    let copy = folder.path().join("copy.mcap");
    let export = ["log", text(&file), "--export", "mcap", "-o", text(&copy)];
    let outcome = dobot(&export).succeeds();
    assert!(outcome.stderr.is_empty(), "{outcome:?}");
    let bytes = std::fs::read(&copy).expect("it is there");
    assert!(bytes.ends_with(b"\x89MCAP0\r\n"), "it has its end mark");
    let listed = dobot(&["log", text(&copy)]).succeeds().stdout;
    assert!(listed.contains("/events"), "{listed}");
    assert!(!listed.contains("damaged"), "{listed}");
    dobot(&export).fails(1, &["exists", "never overwritten"]);
}
