//! `dobot log --export` to formats that need their own libraries: Parquet files and data sets of `LeRobot`.

use crate::recordings::{export_tables, recording, text};
use crate::support::program::dobot;

#[test]
fn a_recording_is_exported_as_parquet_files() {
    export_tables("parquet");
}

#[test]
fn a_recording_is_exported_as_a_dataset() {
    let (folder, file) = recording();
    let dataset = folder.path().join("dataset");
    let dataset = text(&dataset);
    let export = ["log", text(&file), "--export", "lerobot", "-o", dataset];
    let outcome = dobot(&export).succeeds();
    assert!(
        outcome.stdout.contains("episodes 1, frames 5"),
        "{outcome:?}"
    );
    dobot(&export).fails(1, &["exists", "hint: name a new folder with `-o`"]);
}

#[test]
fn several_recordings_and_their_episodes_become_one_dataset() {
    let (folder, file) = recording();
    let (_other, other) = recording();
    let dataset = folder.path().join("dataset");
    let export = [
        "log",
        text(&file),
        text(&other),
        "--export",
        "lerobot",
        "-o",
        text(&dataset),
    ];
    let outcome = dobot(&export).succeeds();
    assert!(
        outcome.stdout.contains("episodes 2, frames 10"),
        "{outcome:?}"
    );
    let dataset = folder.path().join("marked");
    let export = [
        "log",
        text(&file),
        "--export",
        "lerobot",
        "-o",
        text(&dataset),
    ];
    let outcome = dobot(&[&export[..], &["--episode", "1..1.09"]].concat()).succeeds();
    assert!(
        outcome.stdout.contains("episodes 1, frames 3"),
        "{outcome:?}"
    );
    let wrong = ["--episode", "1.09..1"];
    dobot(&[&export[..], &wrong].concat()).fails(2, &["the earlier one first"]);
}
