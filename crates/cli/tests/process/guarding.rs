//! A station that is killed, frozen or does not start: what its arm is told all the same, as processes.

use std::io::{BufRead, Read};
use std::net::{SocketAddr, TcpListener};
use std::path::Path;
use std::sync::mpsc::Receiver;
use std::time::{Duration, Instant};

use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis, Status};
use tempfile::TempDir;

use crate::going::{Going, line_with};
use crate::killing::{burns, spiral};
use crate::program::{command, command_at, run};
use crate::wire::{Passed, wire};

const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));
const JOINT_RELEASE: Command = Command::JointJog(JointJog::new(JointJogAxis::Released, 0.0));
const LINEAR_RELEASE: Command = Command::LinearJog(LinearJog::new(LinearJogAxis::Released, 0.0));

/// An arm behind a wire that listens, and the data of a station.
struct Bench {
    _arm: Going,
    wire: SocketAddr,
    passed: Receiver<Passed>,
    folder: TempDir,
}

impl Bench {
    fn new() -> Self {
        let mut arm = Going::new(command(&["arm", "--tcp", "127.0.0.1:0"]));
        let address = arm.address();
        let address = address.trim_start_matches("tcp:");
        let (wire, passed) = wire(address.parse().expect("an address"));
        Self {
            _arm: arm,
            wire,
            passed,
            folder: tempfile::tempdir().expect("there is room"),
        }
    }

    fn folder(&self) -> &Path {
        self.folder.path()
    }

    fn up(&self, others: &[&str]) -> std::process::Command {
        let arm = format!("tcp:{}", self.wire);
        let arguments = ["up", "--dialect", "specification", "--arm", &arm];
        let free: &[&str] = if others.contains(&"--http") {
            &[]
        } else {
            &["--http", "127.0.0.1:0"]
        };
        let ports = [&["--raw", "off"], free].concat();
        command_at(self.folder(), &[&arguments[..], &ports, others].concat())
    }

    /// A station that is there, and what it prints on standard error.
    fn station(&self) -> (Going, impl BufRead + use<>) {
        let (mut station, errors) = Going::with_errors(self.up(&[]));
        station.reads("Ctrl-C");
        run(&mut command_at(self.folder(), &["confirm", "--yes"]), b"").succeeds();
        (station, errors)
    }

    /// Somebody holds a button, and the arm moves.
    fn jog(&self, button: &str) -> Going {
        let hold = ["jog", button, "--for", "60"];
        let holder = Going::new(command_at(self.folder(), &hold));
        self.wait_for_jog();
        holder
    }

    fn wait_for_jog(&self) {
        let moves = |command: &Command| match command {
            Command::JointJog(it) => it.axis.moves(),
            Command::LinearJog(it) => it.axis.moves(),
            _ => false,
        };
        while !self.next_command().is_some_and(|(_, it)| moves(&it)) {}
        // A few statuses later it is well under way.
        for _ in 0..6 {
            self.next_status();
        }
    }

    fn next(&self) -> Passed {
        let next = self.passed.recv_timeout(Duration::from_secs(60));
        next.expect("something passes the wire within a minute")
    }

    fn next_command(&self) -> Option<(Instant, Command)> {
        match self.next() {
            Passed::ToArm(at, command) => Some((at, command)),
            Passed::FromArm(..) | Passed::Opened => None,
        }
    }

    fn next_status(&self) -> (Instant, Status) {
        loop {
            if let Passed::FromArm(at, status) = self.next() {
                return (at, status);
            }
        }
    }

    /// The commands until the arm told the same place ten times, or the wire is closed; and when it
    /// told that place first.
    fn until_at_rest(&self) -> (Vec<(Instant, Command)>, Instant) {
        let (mut commands, mut last, mut still) = (Vec::new(), None, 0);
        let mut since = Instant::now();
        while still < 10 {
            match self.passed.recv_timeout(Duration::from_secs(2)) {
                Ok(Passed::ToArm(at, command)) => commands.push((at, command)),
                Ok(Passed::FromArm(at, status)) if last != Some(status) => {
                    (last, since, still) = (Some(status), at, 0);
                }
                Ok(Passed::FromArm(..)) => still += 1,
                Ok(Passed::Opened) => {}
                Err(_) => break,
            }
        }
        (commands, since)
    }

    /// Where the base of the arm is, by the arm itself: no station is there any more.
    fn base_deg(&self) -> f64 {
        let arm = format!("tcp:{}", self.wire);
        let ask = ["status", "--to", &arm, "--count", "1", "--json"];
        let outcome = run(&mut command_at(self.folder(), &ask), b"").succeeds();
        base_deg(&outcome.stdout)
    }

    /// The guardian said it within 0.4 s, both things, three times at least.
    #[track_caller]
    fn check_words(&self, at: Instant, release: Command) {
        let (commands, rests) = self.until_at_rest();
        let said: Vec<_> = commands.iter().filter(|it| it.0 >= at).collect();
        let times = |wanted| said.iter().filter(|it| it.1 == wanted).count();
        assert!(times(release) >= 3, "{said:?}");
        assert!(times(LASER_OFF) >= 3, "{said:?}");
        assert!(
            said.iter().all(|it| [release, LASER_OFF].contains(&it.1)),
            "{said:?}"
        );
        let after = said[0].0.saturating_duration_since(at);
        assert!(after <= Duration::from_millis(400), "{after:?}");
        // The run-down, and a status on its way.
        let rested = rests.saturating_duration_since(at);
        assert!(rested <= Duration::from_millis(400 + 1200), "{rested:?}");
    }

    /// The first thing that the arm is told by a station that does not start.
    fn first_of_a_failing_start(&self, others: &[&str], parts: &[&str]) {
        run(&mut self.up(others), b"").fails(1, parts);
        let first = loop {
            if let Some((_, command)) = self.next_command() {
                break command;
            }
        };
        assert_eq!(first, LASER_OFF);
    }
}

fn base_deg(status: &str) -> f64 {
    let status: serde_json::Value = serde_json::from_str(status).expect("it is JSON");
    status["base_deg"].as_f64().expect("a number")
}

fn signal(station: &Going, signal: rustix::process::Signal) {
    rustix::process::kill_process(station.pid(), signal).expect("it is there");
}

#[test]
fn an_arm_whose_station_is_killed_while_somebody_jogs_a_joint_is_let_go() {
    let bench = Bench::new();
    let (mut station, _errors) = bench.station();
    let _holder = bench.jog("base+");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, JOINT_RELEASE);
    let (before, after) = (bench.base_deg(), bench.base_deg());
    assert!((after - before).abs() < 0.01, "{before} {after}");
}

#[test]
fn an_arm_that_is_used_without_a_station_is_let_go_too_when_the_verb_is_killed() {
    let bench = Bench::new();
    let arm = format!("tcp:{}", bench.wire);
    let hold = [
        "jog",
        "base+",
        "--for",
        "60",
        "--to",
        &arm,
        "--pose-confirmed",
    ];
    let mut verb = Going::new(command_at(bench.folder(), &hold));
    bench.wait_for_jog();
    let at = Instant::now();
    verb.kill();
    bench.check_words(at, JOINT_RELEASE);
}

/// The processes that a process has started, as Linux lists them.
#[cfg(target_os = "linux")]
fn children(of: rustix::process::Pid) -> Vec<rustix::process::Pid> {
    let parent = of.as_raw_nonzero().to_string();
    let all = std::fs::read_dir("/proc").expect("it is Linux");
    let child = |entry: std::fs::DirEntry| {
        let number = entry.file_name().to_str()?.parse().ok()?;
        // NUMBER (NAME) STATE PARENT ...
        let stat = std::fs::read_to_string(entry.path().join("stat")).ok()?;
        let (_, behind) = stat.rsplit_once(')')?;
        let is_child = behind.split_whitespace().nth(1) == Some(&parent);
        is_child.then(|| rustix::process::Pid::from_raw(number))?
    };
    all.flatten().filter_map(child).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn a_guardian_that_is_killed_is_replaced_and_the_next_one_lets_go() {
    let bench = Bench::new();
    let (mut station, mut errors) = bench.station();
    let guardians = children(station.pid());
    assert_eq!(guardians.len(), 1, "{guardians:?}");
    rustix::process::kill_process(guardians[0], rustix::process::Signal::KILL)
        .expect("it is there");
    line_with("another one takes its place", &mut errors);
    let _holder = bench.jog("base+");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, JOINT_RELEASE);
}

/// The station of an arm that burns.
fn burning(bench: &Bench) -> (Going, Going) {
    let (station, _errors) = bench.station();
    let file = bench.folder().join("job.json");
    let text = serde_json::to_string(&spiral()).expect("it is JSON");
    std::fs::write(&file, text).expect("there is room");
    let submit = ["jobs", "submit", file.to_str().expect("the path is text")];
    run(&mut command_at(bench.folder(), &submit), b"").succeeds();
    let start = ["jobs", "start", "1", "--arm-laser", "600"];
    let follower = Going::new(command_at(bench.folder(), &start));
    let mut burnt = 0;
    while burnt < 3 {
        burnt += usize::from(bench.next_command().is_some_and(|(_, it)| burns(&it)));
    }
    (station, follower)
}

#[test]
fn a_light_whose_station_is_killed_or_stands_still_is_off_within_two_fifths_of_a_second() {
    use rustix::process::Signal;
    for how in [Signal::KILL, Signal::STOP] {
        let bench = Bench::new();
        let (station, _follower) = burning(&bench);
        let at = Instant::now();
        signal(&station, how);
        let (commands, _) = bench.until_at_rest();
        let mut after = commands.iter().filter(|it| it.0 > at);
        // What the station had sent before may still be on the wire.
        let first = after.find(|it| !matches!(it.1, Command::WriteVector(_)));
        let (said, first) = first.expect("the guardian speaks");
        assert_eq!(*first, LASER_OFF, "{how:?}");
        let within = said.saturating_duration_since(at);
        assert!(within <= Duration::from_millis(400), "{how:?}: {within:?}");
    }
}

#[test]
fn an_arm_whose_station_is_killed_in_a_linear_jog_is_let_go_and_the_next_start_tells_it() {
    let bench = Bench::new();
    let (mut station, _errors) = bench.station();
    let _holder = bench.jog("y-");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, LINEAR_RELEASE);
    let mut again = Going::new(bench.up(&[]));
    again.reads("the station ended without a goodbye: the guardian switched the laser off");
    // Once is enough.
    assert_eq!(again.interrupt(), Some(0));
    let note = std::fs::read_to_string(bench.folder().join("guardian.txt"));
    assert_eq!(note.expect("it is there"), "");
}

#[test]
fn an_arm_whose_station_stands_still_is_let_go_and_the_station_tells_it_when_it_goes_on() {
    use rustix::process::Signal;
    let bench = Bench::new();
    let (station, mut errors) = bench.station();
    let _holder = bench.jog("base-");
    let at = Instant::now();
    signal(&station, Signal::STOP);
    bench.check_words(at, JOINT_RELEASE);
    let on = Instant::now();
    signal(&station, Signal::CONT);
    line_with("the station stood still for", &mut errors);
    line_with("the station was silent for", &mut errors);
    // What it says first is laser off; it does not take up the jog where it was.
    let first = loop {
        match bench.next_command() {
            // Once more by the guardian, which goes on until it hears the arm or the station.
            Some((_, JOINT_RELEASE)) => {}
            Some((at, command)) if at > on => break command,
            // The guardian's last words may still be on the wire.
            _ => {}
        }
    };
    assert_eq!(first, LASER_OFF);
}

#[test]
fn a_station_that_ends_as_it_should_has_said_all_itself() {
    let bench = Bench::new();
    let (station, mut errors) = bench.station();
    assert_eq!(station.interrupt(), Some(0));
    let mut rest = String::new();
    errors.read_to_string(&mut rest).expect("it is text");
    assert!(!rest.contains("guardian"), "{rest}");
    let note = std::fs::read_to_string(bench.folder().join("guardian.txt"));
    assert_eq!(note.expect("the guardian was there"), "");
}

#[test]
fn over_a_virtual_serial_port_a_killed_station_is_spoken_for_too() {
    let folder = tempfile::tempdir().expect("there is room");
    let link = folder.path().join("arm");
    let link = link.to_str().expect("the path is text");
    let mut arm = Going::new(command(&["arm", "--pty", link]));
    let address = arm.address();
    let ports = ["--http", "127.0.0.1:0", "--raw", "off"];
    let arguments = ["up", "--dialect", "specification", "--arm", &address];
    let mut station = Going::new(command_at(
        folder.path(),
        &[&arguments[..], &ports].concat(),
    ));
    station.reads("Ctrl-C");
    run(&mut command_at(folder.path(), &["confirm", "--yes"]), b"").succeeds();
    let _holder = Going::new(command_at(folder.path(), &["jog", "base+", "--for", "60"]));
    let base = || {
        let show = ["status", "--count", "1", "--json"];
        base_deg(
            &run(&mut command_at(folder.path(), &show), b"")
                .succeeds()
                .stdout,
        )
    };
    while base() < 3.0 {}
    station.kill();
    let mut again = Going::new(command_at(
        folder.path(),
        &[&arguments[..], &ports].concat(),
    ));
    again.reads("let go of the joint jog's button");
    again.reads("Ctrl-C");
    let (before, after) = (base(), base());
    assert!((after - before).abs() < 0.01, "{before} {after}");
}

#[test]
fn a_start_that_fails_has_switched_the_laser_off_first() {
    let bench = Bench::new();
    let policy = bench.folder().join("wrong.toml");
    std::fs::write(&policy, "[jog]\ndead_man = 1").expect("there is room");
    let policy = policy.to_str().expect("the path is text");
    bench.first_of_a_failing_start(&["--policy", policy], &["policy"]);
    let held = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let taken = held.local_addr().expect("it has an address").to_string();
    bench.first_of_a_failing_start(&["--http", &taken], &[&taken]);
    std::fs::write(bench.folder().join("journal.redb"), "a power cut").expect("there is room");
    bench.first_of_a_failing_start(&[], &["journal"]);
}

#[test]
fn a_silent_listener_where_a_station_was_does_not_keep_the_laser_on() {
    let bench = Bench::new();
    let silent = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = silent.local_addr().expect("it has an address");
    let file = format!("address = \"http://{address}\"\npid = 1\n");
    std::fs::write(bench.folder().join("station.toml"), file).expect("there is room");
    let at = Instant::now();
    let _station = Going::new(bench.up(&[]));
    let first = loop {
        if let Some(first) = bench.next_command() {
            break first;
        }
    };
    assert_eq!(first.1, LASER_OFF);
    let after = first.0.saturating_duration_since(at);
    assert!(after < Duration::from_secs(3), "{after:?}");
}
