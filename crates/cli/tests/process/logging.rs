//! The log of a station, for people and for programs.

use std::io::Read;
use std::process::Command;

use serde_json::Value;
use tempfile::TempDir;

use crate::support::program::{command, command_at, run};
use crate::support::running_process::{RunningProcess, line_with};

/// A station with a virtual arm, and its data.
fn up(arguments: &[&str]) -> (Command, TempDir) {
    let folder = tempfile::tempdir().expect("there is room");
    let ports = ["--http", "127.0.0.1:0", "--raw", "off"];
    let arguments = [&["up", "--virtual"], &ports[..], arguments].concat();
    (command_at(folder.path(), &arguments), folder)
}

/// Stops the arm, ends the station, and returns its log from then on.
fn stopped_and_ended(station: RunningProcess, folder: &TempDir, mut errors: impl Read) -> String {
    run(&mut command_at(folder.path(), &["stop"]), b"").succeeds();
    assert_eq!(station.interrupt(), Some(0));
    let mut log = String::new();
    errors.read_to_string(&mut log).expect("it is text");
    log
}

fn events(log: &str) -> Vec<Value> {
    let event = |line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
    log.lines().map(event).collect()
}

#[test]
fn the_log_of_a_service_is_a_json_object_a_line_from_its_start_to_its_end() {
    let (up, folder) = up(&["--log-format", "json"]);
    let (station, mut errors) = RunningProcess::with_errors(up);
    let started = line_with("the station has started", &mut errors);
    let [started] = &events(&started)[..] else {
        panic!("{started} is not one line");
    };
    assert_eq!(started["level"], "INFO");
    let page = started["page"]
        .as_str()
        .expect("the log has the address of the page");
    assert!(page.starts_with("http://127.0.0.1:"), "{started}");

    let log = stopped_and_ended(station, &folder, errors);
    let events = events(&log);
    let stop = events.iter().find(|event| event["news"] == "Stopped");
    let stop = stop.unwrap_or_else(|| panic!("no stop is logged: {log}"));
    assert_eq!(
        (&stop["level"], &stop["target"]),
        (&"WARN".into(), &"dobot_host::driver::log".into())
    );
    assert!(
        events.iter().all(|event| event["level"] != "DEBUG"),
        "{log}"
    );
}

#[test]
fn a_station_logs_requests_if_asked_to_and_logs_no_notice_twice() {
    let (mut up, folder) = up(&[]);
    up.env("RUST_LOG", "warn,dobot_host=info,dobot_station=debug");
    let (mut station, errors) = RunningProcess::with_errors(up);
    station.wait_for_line("Ctrl-C");
    let log = stopped_and_ended(station, &folder, errors);
    assert!(log.contains("DEBUG dobot_station::http"), "{log}");
    assert_eq!(log.matches("Stopped").count(), 1, "{log}");
    let token = std::fs::read_to_string(folder.path().join("tokens.toml")).unwrap_or_default();
    assert!(token.lines().all(|line| !log.contains(line)), "{log}");
}

#[test]
fn a_station_shows_events_to_a_person_and_logs_nothing_by_default() {
    let (up, folder) = up(&[]);
    let (mut station, errors) = RunningProcess::with_errors(up);
    station.wait_for_line("Ctrl-C");
    let log = stopped_and_ended(station, &folder, errors);
    assert!(log.contains("stopping: the laser goes off"), "{log}");
    for level in ["INFO", "WARN", "DEBUG"] {
        assert!(!log.contains(level), "{log}");
    }
}

#[test]
fn a_service_that_cannot_start_logs_the_cause_and_the_remedy() {
    let (mut up, _folder) = up(&["--log-format", "json", "--policy", "nowhere.toml"]);
    let outcome = run(&mut up, b"");
    assert_eq!(outcome.code, Some(1), "{outcome:?}");
    let events = events(&outcome.stderr);
    let last = events.last().expect("the log has the reason");
    assert_eq!(last["level"], "ERROR");
    let field_of = |field: &str| last[field].as_str().unwrap_or_default().to_owned();
    assert!(field_of("message").contains("nowhere.toml"), "{last}");
    assert!(field_of("hint").contains("dobot policy check"), "{last}");
}

#[test]
fn an_unknown_level_is_reported_and_prevents_nothing() {
    let mut policy = command(&["policy"]);
    let outcome = run(policy.env("RUST_LOG", "dobot_host=loud"), b"").succeeds();
    assert!(
        outcome.stderr.contains("RUST_LOG is \"dobot_host=loud\""),
        "{outcome:?}"
    );
}
