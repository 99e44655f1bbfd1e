//! The packets that still reach the arm of a station that ends, is killed or does not start.

use std::io::Read;
use std::net::TcpListener;

use crate::support::arm::{fast_arm, real_time_arm};
use crate::support::bench::Bench;
use crate::support::program::run;
use crate::support::running_process::{RunningProcess, line_with};
use crate::support::spiral::LASER_OFF;
use crate::support::up::Up;

fn bench() -> Bench {
    Bench::new(fast_arm(&["--tcp", "127.0.0.1:0"]))
}

/// The first command that an arm receives from a station that does not start.
fn first_of_a_failing_start(bench: &Bench, others: &[&str], parts: &[&str]) {
    run(&mut bench.up(others), b"").fails(1, parts);
    assert_eq!(bench.command().1, LASER_OFF);
}

#[test]
fn the_watchdog_of_a_station_that_ends_normally_reports_nothing() {
    let bench = bench();
    let (station, mut errors) = bench.station_with_errors();
    bench.confirm();
    station.is_interrupted();
    // Until here a busy machine may have kept the station waiting, and the watchdog has spoken.
    line_with("stopping: the laser goes off", &mut errors);
    assert_eq!(station.ends(), Some(0));
    let mut rest = String::new();
    errors.read_to_string(&mut rest).expect("it is text");
    assert!(!rest.contains("watchdog"), "{rest}");
    let note = std::fs::read_to_string(bench.folder().join("watchdog.txt"));
    assert_eq!(note.expect("the watchdog was there"), "");
}

#[test]
fn the_watchdog_of_a_killed_station_acts_over_a_virtual_serial_port_too() {
    let folder = tempfile::tempdir().expect("there is room");
    let link = folder.path().join("arm");
    let link = link.to_str().expect("the path is text");
    // As fast as a clock: the jog is to be far from its end when the station is killed.
    let mut arm = real_time_arm(&["--pty", link]);
    let arm = ["--arm", &arm.address(), "--dialect", "specification"];
    let mut up = Up::with_arm(&arm, &[]);
    up.dobot(&["confirm", "--yes"]).succeeds();
    let _holder = RunningProcess::new(up.command(&["jog", "base+", "--for", "60"]));
    up.wait_for_state(|state| state["arm"]["base_deg"].as_f64() > Some(3.0));
    up.station.kill();
    let ports = ["up", "--http", "127.0.0.1:0", "--raw", "off"];
    let mut again = RunningProcess::new(up.command(&[&ports[..], &arm].concat()));
    again.wait_for_line("released the joint jog button");
    again.wait_for_line("Ctrl-C");
    let base = || {
        let status = up.json(&["status", "--count", "1"]);
        status["base_deg"].as_f64().expect("a number")
    };
    let (before, after) = (base(), base());
    assert!((after - before).abs() < 0.01, "{before} {after}");
}

#[test]
fn a_start_that_fails_has_switched_the_laser_off_first() {
    let bench = bench();
    let policy = bench.folder().join("wrong.toml");
    std::fs::write(&policy, "[jog]\ndead_man = 1").expect("there is room");
    let policy = policy.to_str().expect("the path is text");
    first_of_a_failing_start(&bench, &["--policy", policy], &["policy"]);
    let held = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let taken = held.local_addr().expect("it has an address").to_string();
    first_of_a_failing_start(&bench, &["--http", &taken], &[&taken]);
    std::fs::write(bench.folder().join("journal.redb"), "a power cut").expect("there is room");
    first_of_a_failing_start(&bench, &[], &["journal"]);
    let file = bench.folder().join("journal.redb");
    let file = file.to_str().expect("the path is text");
    first_of_a_failing_start(&bench, &["--data", file], &[file]);
}
