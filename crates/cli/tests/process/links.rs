//! Ports and TCP: good ones and bad ones.

use std::io::{Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::mpsc;
use std::thread;

use tempfile::TempDir;

use crate::support::arm::fast_arm;
use crate::support::program::{Outcome, command, command_at, dobot, example};
use crate::support::running_process::RunningProcess;
use crate::support::trouble::{Trouble, commands, is_laser_off, troubled, vector};
use crate::support::up::Up;

#[test]
fn a_drawing_succeeds_over_a_virtual_serial_port_and_over_tcp() {
    let folder = tempfile::tempdir().expect("there is room");
    let link = folder.path().join("dobot");
    let mut arm = fast_arm(&[
        "--tcp",
        "127.0.0.1:0",
        "--pty",
        link.to_str().expect("the path is text"),
    ]);
    for _ in 0..2 {
        let address = arm.address();
        let arguments = [
            "draw",
            &example("square.svg"),
            "--to",
            &address,
            "--dialect",
            "specification",
            "--pose-confirmed",
            "--json",
        ];
        let outcome = dobot(&arguments).succeeds();
        let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("it is JSON");
        assert_eq!(report["measured_from"], "the statuses", "{address}");
        assert!(
            report["deviation_mm"].as_f64().expect("a number") < 0.1,
            "{report}"
        );
    }
}

#[test]
fn without_consent_a_real_arm_neither_moves_nor_burns() {
    let mut arm = fast_arm(&["--tcp", "127.0.0.1:0"]);
    let address = arm.address();
    let to = ["--to", &address, "--dialect", "specification"];
    let burn = ["draw", &example("square.svg"), "--outline", "--laser"];
    dobot(&[&burn[..], &["plywood-engrave"], &to].concat())
        .fails(1, &["no terminal", "leave out `--outline`"]);
    for moving in [
        &["move", "220", "0", "20"][..],
        &["jog", "base+"],
        &["detect"],
        &burn[..2],
    ] {
        let expected = [
            "resets a stock arm",
            "standard input is no terminal",
            "--pose-confirmed",
        ];
        dobot(&[moving, &to].concat()).fails(1, &expected);
    }
    let unarmed = [
        "draw",
        &example("square.svg"),
        "--pose-confirmed",
        "--laser",
    ];
    dobot(&[&unarmed[..], &["plywood-engrave"], &to].concat())
        .fails(1, &["the laser is disarmed", "--arm-laser SECONDS"]);
    let seen = dobot(&[&["status", "--count", "1", "--json"][..], &to].concat()).succeeds();
    let seen: serde_json::Value = serde_json::from_str(&seen.stdout).expect("it is JSON");
    assert_eq!(seen["rear_deg"], 45.0, "it stands as it was switched on");
    // A virtual arm in the process is harmless.
    dobot(&[&burn[..], &["plywood-engrave", "--to", "virtual:"]].concat()).succeeds();
}

#[test]
fn over_a_port_the_dialect_is_undecided_until_it_is_given() {
    let mut arm = fast_arm(&["--tcp", "127.0.0.1:0"]);
    let address = arm.address();
    let to = ["--pose-confirmed", "--to", &address];
    dobot(&[&["draw", &example("square.svg")], &to[..]].concat())
        .fails(1, &["--dialect firmware-1.1"]);
    dobot(&[&["move", "220", "0", "20", "--path", "movl"], &to[..]].concat())
        .fails(1, &["--dialect"]);
    dobot(&["status", "--count", "2", "--to", &address]).succeeds();
}

#[test]
fn a_missing_or_invalid_port_is_reported() {
    dobot(&["status", "--to", "serial:/dev/no-such-port"])
        .fails(1, &["no serial port /dev/no-such-port", "dobot ports"]);
    dobot(&["status", "--to", "serial:/dev/null"]).fails(1, &["/dev/null is not a serial port"]);
}

/// The state of a station, once it reports why it has no arm.
fn link_of(arm: &str) -> serde_json::Value {
    let up = Up::with_arm(&["--arm", arm], &[]);
    let state = up.wait_for_state(|state| state["link"]["cause"] != serde_json::Value::Null);
    state["link"].clone()
}

/// The serial port of an arm that a program uses.
struct UsedPort {
    _user: RunningProcess,
    _arm: RunningProcess,
    _folder: TempDir,
    address: String,
}

impl UsedPort {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        let link = folder.path().join("dobot");
        let mut arm = fast_arm(&["--pty", link.to_str().expect("the path is text")]);
        let address = arm.address();
        let mut user = RunningProcess::new(command(&["status", "--json", "--to", &address]));
        // A line of it shows that it has the port.
        user.wait_for_line("");
        Self {
            _user: user,
            _arm: arm,
            _folder: folder,
            address,
        }
    }
}

#[test]
fn a_station_reports_why_it_cannot_open_its_port_and_the_remedy() {
    let file = tempfile::NamedTempFile::new().expect("there is room");
    let file = format!("serial:{}", file.path().display());
    let port = UsedPort::new();
    let used = &port.address;
    let closed = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let closed_address = format!("tcp:{}", closed.local_addr().expect("it is bound"));
    drop(closed);
    for (address, cause, problem, remedy) in [
        (
            "serial:/dev/no-such-port",
            "no_such_port",
            "there is no serial port",
            "dobot ports",
        ),
        (
            &file,
            "not_a_serial_port",
            "is not a serial port",
            "dobot ports",
        ),
        (used, "in_use", "is in use by another program", "fuser"),
        (
            &closed_address,
            "unreachable",
            "cannot connect",
            "no server listens there",
        ),
    ] {
        let link = link_of(address);
        let has =
            |key: &str, text: &str| link[key].as_str().is_some_and(|value| value.contains(text));
        assert_eq!(link["phase"], "searching", "{link}");
        assert_eq!(link["cause"], cause, "{link}");
        assert!(has("problem", problem) && has("remedy", remedy), "{link}");
    }
}

#[test]
fn a_station_names_a_web_server_at_the_address_of_its_arm() {
    let web = peer(|mut stream| {
        let answer = b"HTTP/1.1 400 Bad Request\r\n\r\n";
        stream.write_all(answer).expect("it is open");
        let _ = stream.read_exact(&mut [0; 42]);
    });
    let link = link_of(&web);
    assert_eq!(link["cause"], "not_an_arm", "{link}");
    let problem = link["problem"].as_str().expect("a text");
    assert!(problem.contains("HTTP/1.1 400 Bad Request"), "{problem}");
}

#[test]
fn the_start_of_a_station_shows_the_cause_and_not_a_lost_link() {
    let folder = tempfile::tempdir().expect("there is room");
    let arguments = [
        "up",
        "--arm",
        "serial:/dev/no-such-port",
        "--http",
        "127.0.0.1:0",
    ];
    let arguments = [&arguments[..], &["--raw", "off"]].concat();
    let station = command_at(folder.path(), &arguments);
    // Either with the start, or, if the port was still being opened, in the first notice.
    let mut station = RunningProcess::with_errors_in_output(station);
    let first = station.wait_for_line("there is no serial port /dev/no-such-port");
    assert!(first.contains("dobot ports"), "{first}");
    assert!(!first.contains("lost"), "{first}");
}

#[test]
fn a_port_in_use_is_reported() {
    let port = UsedPort::new();
    let second = dobot(&["status", "--to", &port.address]);
    second.fails(1, &["in use by another program", "fuser"]);
}

/// A peer that does one thing with its one client.
fn peer(act: impl Fn(TcpStream) + Send + 'static) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || {
        for stream in listener.incoming() {
            let stream = stream.expect("the program connects");
            let handle = stream.try_clone().expect("a handle");
            act(stream);
            // A program that is started meanwhile may have a copy of the socket for a moment. The other end may be gone.
            let _ = handle.shutdown(Shutdown::Both);
        }
    });
    format!("tcp:{address}")
}

/// Rear arm upright, forearm level.
/// An arm at rest with rear arm and forearm at 45 degrees: 135 sin 45 + 160 cos 45 + 55.07.
fn status() -> Vec<u8> {
    let floats: [f32; 10] = [263.6665, 0.0, -17.6777, 0.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0];
    let body = floats.iter().flat_map(|float| float.to_le_bytes());
    [0xA5].into_iter().chain(body).chain([0x5A]).collect()
}

#[test]
fn a_peer_that_closes_in_the_middle_is_reported() {
    let address = peer(|mut stream| stream.write_all(&status()[..20]).expect("it is open"));
    dobot(&["status", "--to", &address]).fails(1, &["closed the link"]);
}

#[test]
fn a_peer_that_sends_noise_is_reported() {
    let address = peer(|mut stream| {
        for _ in 0..25 {
            stream
                .write_all(&[0xA5, 0x11, 0x22, 0x5A].repeat(100))
                .expect("it is open");
        }
        // Until the program has waited long enough for something better.
        let _ = stream.read_to_end(&mut Vec::new());
    });
    dobot(&["status", "--to", &address]).fails(1, &["bytes were received, but no valid status"]);
}

fn draw_square(address: &str) -> Outcome {
    let square = example("square.svg");
    let how = [
        "--dialect",
        "specification",
        "--pen-down",
        "-40",
        "--pose-confirmed",
    ];
    dobot(&[&["draw", &square, "--to", address][..], &how].concat())
}

#[test]
fn an_arm_that_goes_silent_before_a_drawing_still_gets_laser_off() {
    let (sender, received) = mpsc::channel();
    let address = peer(move |mut stream| {
        // One status, never another one; and then everything that comes.
        stream.write_all(&status()).expect("it is open");
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let _ = sender.send(bytes);
    });
    draw_square(&address).fails(1, &["no valid status"]);
    let commands = commands(&received.recv().expect("the peer sends"));
    let last = commands.last().expect("something was sent");
    assert!(is_laser_off(last), "{commands:?}");
}

#[test]
fn a_peer_that_closes_during_a_drawing_is_reported_with_the_progress() {
    let address = peer(|mut stream| {
        // One permit, its command, and nothing else.
        stream.write_all(&status()).expect("it is open");
        stream.read_exact(&mut [0; 42]).expect("it is open");
    });
    draw_square(&address).fails(1, &["closed the link"]);
}

#[test]
fn an_arm_that_goes_silent_during_a_drawing_gets_laser_off_and_no_motion() {
    // In the middle of the first line: an arm may be silent for twenty times as long as its motions take, and the way to the line
    // takes seconds.
    let (outcome, _, after) = troubled(50, Trouble::Silence);
    outcome.fails(1, &["no valid status for", "dobot jobs start 1 --to tcp:"]);
    // What was permitted already may still have been on its way.
    let parting: Vec<_> = after
        .iter()
        .skip_while(|command| vector(command).is_some())
        .collect();
    assert!(!parting.is_empty(), "{after:?}");
    assert!(
        parting.iter().all(|command| is_laser_off(command)),
        "{after:?}"
    );
}

#[test]
fn ctrl_c_ends_the_served_arm() {
    let mut arm = fast_arm(&["--tcp", "127.0.0.1:0"]);
    arm.address();
    assert_eq!(arm.interrupt(), Some(0));
}

#[test]
fn an_occupied_tcp_port_is_reported() {
    let mut arm = fast_arm(&["--tcp", "127.0.0.1:0"]);
    let taken = arm.address()[4..].to_owned();
    dobot(&["arm", "--tcp", &taken]).fails(1, &["cannot serve on", "127.0.0.1:0"]);
}

#[test]
fn an_existing_file_at_the_path_of_the_virtual_serial_port_is_not_touched() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("precious");
    std::fs::write(&file, "data").expect("there is room");
    dobot(&["arm", "--pty", file.to_str().expect("the path is text")]).fails(
        1,
        &["precious", "File exists", "hint: remove the existing file"],
    );
    assert_eq!(std::fs::read_to_string(&file).expect("it is there"), "data");
}
