//! `dobot doctor`: the report of this machine.

use serde_json::Value;

use crate::support::program::{command_at, run};
use crate::support::up::Up;

#[test]
fn the_report_names_every_check_and_no_folder_of_this_user() {
    let home = tempfile::tempdir().expect("there is room");
    let data = home.path().join("anna");
    let outcome = run(command_at(&data, &["doctor"]).env("HOME", home.path()), b"");
    for check in [
        "ports",
        "clock",
        "disk",
        "station",
        "recordings",
        "certificate",
        "tokens",
        "data",
    ] {
        let line = |line: &str| line.split_whitespace().nth(1) == Some(check);
        assert!(outcome.stdout.lines().any(line), "{check}: {outcome:?}");
    }
    assert!(outcome.stdout.starts_with("dobot 0."), "{outcome:?}");
    assert!(!outcome.stdout.contains("anna"), "{outcome:?}");
    assert!(!data.exists(), "it only looks");
}

#[test]
fn a_check_that_fails_says_what_to_do_and_the_exit_code_is_one() {
    let data = tempfile::tempdir().expect("there is room");
    let newer = "format = 2\nprogram = \"dobot 0.3.0\"\n";
    std::fs::write(data.path().join("format.toml"), newer).expect("there is room");
    let outcome = run(&mut command_at(data.path(), &["doctor", "--json"]), b"");
    let report: Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
    let findings = report["findings"].as_array().expect("it is a list");
    let found = findings.iter().find(|finding| finding["check"] == "data");
    let found = found.expect("the data are checked");
    assert_eq!(found["health"], "bad");
    let text = found["text"].as_str().unwrap_or_default();
    assert!(text.contains("dobot 0.3.0"), "{text}");
    outcome.fails(1, &["failed", "bad"]);
}

#[test]
fn a_station_refuses_the_data_of_a_newer_program() {
    let data = tempfile::tempdir().expect("there is room");
    let newer = "format = 2\nprogram = \"dobot 0.3.0\"\n";
    std::fs::write(data.path().join("format.toml"), newer).expect("there is room");
    let up = ["up", "--virtual", "--http", "127.0.0.1:0", "--raw", "off"];
    run(&mut command_at(data.path(), &up), b"").fails(1, &["dobot 0.3.0", "newer version"]);
    let left: Vec<_> = std::fs::read_dir(data.path())
        .expect("it is there")
        .filter_map(|entry| Some(entry.ok()?.file_name()))
        .collect();
    assert_eq!(left, ["format.toml"], "nothing else was written");
}

#[test]
fn a_running_station_is_reported_with_its_dialect_and_version() {
    let up = Up::new(&[]);
    let outcome = up.dobot(&["doctor"]);
    assert!(
        outcome
            .stdout
            .contains("running; virtual, dialect specification"),
        "{outcome:?}"
    );
    let same = concat!("station and program are ", env!("CARGO_PKG_VERSION"));
    assert!(outcome.stdout.contains(same), "{outcome:?}");
}
