//! A full log pipe or a hanging note file never delays the arm.

use std::io::PipeReader;
use std::time::{Duration, Instant};

use dobot_wire::Command;
use rustix::process::Signal;
use serde_json::json;

use crate::guarding::{Bench, JOINT_RELEASE};
use crate::support::api::Api;
use crate::support::running_process::RunningProcess;
use crate::support::spiral::LASER_OFF;

/// The formats of the log.
const FORMATS: [&str; 2] = ["text", "json"];

/// A station whose standard error takes nothing, the end of that pipe, and the address of its page.
fn station(bench: &Bench, format: &str) -> (RunningProcess, PipeReader, String) {
    let mut command = bench.up(&["--log-format", format]);
    command.env("RUST_LOG", "debug");
    let (station, errors) = RunningProcess::with_full_errors(command);
    // Not every format has its address on standard output.
    let file = bench.folder().join("station.toml");
    let page = loop {
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        if let Some(address) = text
            .strip_prefix("address = \"")
            .and_then(|rest| rest.split('"').next())
        {
            break address.to_owned();
        }
        std::thread::yield_now();
    };
    bench.confirm();
    (station, errors, page)
}

/// How long after `at` the arm received one of these commands.
fn delay_until(bench: &Bench, at: Instant, wanted: &[Command]) -> Duration {
    loop {
        let (passed, command) = bench.command();
        if passed >= at && wanted.contains(&command) {
            return passed - at;
        }
    }
}

/// Creates a FIFO in the data folder. Opening it for writing blocks, because it has no reader.
fn unread_pipe(bench: &Bench, name: &str) {
    let mode = rustix::fs::Mode::from_bits_truncate(0o600);
    let file = bench.folder().join(name);
    rustix::fs::mkfifoat(rustix::fs::CWD, &file, mode).expect("there is room");
}

#[test]
fn a_watchdog_acts_for_a_killed_or_frozen_station_even_if_standard_error_is_never_read() {
    for format in FORMATS {
        for how in [Signal::KILL, Signal::STOP] {
            let bench = Bench::new();
            let (station, _errors, _) = station(&bench, format);
            let _holder = bench.jog("base+");
            let at = Instant::now();
            rustix::process::kill_process(station.pid(), how).expect("it is there");
            bench.check_words(at, JOINT_RELEASE);
        }
    }
}

#[test]
fn a_watchdog_acts_for_a_killed_verb_even_if_standard_error_is_never_read() {
    let bench = Bench::new();
    let jog = [
        "jog",
        "base+",
        "--for",
        "60",
        "--to",
        &bench.arm.address,
        "--pose-confirmed",
    ];
    let (mut verb, _errors) =
        RunningProcess::with_full_errors(crate::support::program::command_at(bench.folder(), &jog));
    bench.wait_for_jog();
    let at = Instant::now();
    verb.kill();
    bench.check_words(at, JOINT_RELEASE);
}

#[test]
fn a_watchdog_acts_for_a_killed_station_even_if_its_note_is_a_pipe_without_a_reader() {
    let bench = Bench::new();
    unread_pipe(&bench, "watchdog.txt");
    let (mut station, _errors) = bench.station_with_errors();
    bench.confirm();
    let _holder = bench.jog("base+");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, JOINT_RELEASE);
}

#[test]
fn a_released_button_and_a_stop_reach_the_arm_even_if_standard_error_is_never_read() {
    for format in FORMATS {
        let bench = Bench::new();
        let (_station, _errors, page) = station(&bench, format);
        // More lines than a pipe holds.
        for n in 0..200 {
            let text = json!({ "text": format!("message {n} {}", "x".repeat(100)) });
            Api::new(&page).asks("POST", "message", &text);
        }
        let holder = bench.jog("base+");
        let at = Instant::now();
        assert_eq!(holder.interrupt(), Some(0));
        let after = delay_until(&bench, at, &[JOINT_RELEASE]);
        assert!(after < Duration::from_millis(500), "{format}: {after:?}");
        let _holder = bench.jog("base-");
        let at = Instant::now();
        bench.dobot(&["stop", "--reason", "test"]).succeeds();
        let after = delay_until(&bench, at, &[LASER_OFF]);
        assert!(after < Duration::from_millis(500), "{format}: {after:?}");
        let (after, at) = (delay_until(&bench, at, &[JOINT_RELEASE]), at.elapsed());
        assert!(
            after < Duration::from_millis(700),
            "{format}: {after:?} {at:?}"
        );
    }
}

#[test]
fn a_stop_a_release_and_the_watchdog_reach_the_arm_even_if_the_disk_hangs() {
    let bench = Bench::new();
    // The stop is written here, and the disk never answers.
    unread_pipe(&bench, "stop.new");
    let (station, _errors) = bench.station_with_errors();
    bench.confirm();
    for _ in 0..2 {
        let _holder = bench.jog("base-");
        let at = Instant::now();
        bench.dobot(&["stop", "--reason", "test"]).succeeds();
        let after = delay_until(&bench, at, &[LASER_OFF]);
        assert!(after < Duration::from_millis(500), "{after:?}");
        let after = delay_until(&bench, at, &[JOINT_RELEASE]);
        assert!(after < Duration::from_millis(700), "{after:?}");
        bench.dobot(&["stop", "--reset"]).succeeds();
    }
    let holder = bench.jog("base+");
    let at = Instant::now();
    assert_eq!(holder.interrupt(), Some(0));
    let after = delay_until(&bench, at, &[JOINT_RELEASE]);
    assert!(after < Duration::from_millis(500), "{after:?}");
    let _holder = bench.jog("base+");
    let at = Instant::now();
    rustix::process::kill_process(station.pid(), Signal::STOP).expect("it is there");
    bench.check_words(at, JOINT_RELEASE);
}
