//! How soon the arm of a station that is killed or frozen receives its packets.

use std::io::BufRead;
use std::net::TcpListener;
use std::ops::Deref;
use std::time::{Duration, Instant};

use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis};
use serde_json::Value;

use crate::Turn;
use crate::support::arm::real_time_arm;
use crate::support::bench;
use crate::support::running_process::{RunningProcess, line_with};
use crate::support::spiral::{LASER_OFF, burns, spiral};
use crate::support::wire::Passed;

pub(crate) const JOINT_RELEASE: Command =
    Command::JointJog(JointJog::new(JointJogAxis::Released, 0.0));
const LINEAR_RELEASE: Command = Command::LinearJog(LinearJog::new(LinearJogAxis::Released, 0.0));

/// An arm at the end of a wire and a place for its station, while few other tests run.
pub(crate) struct Bench {
    bench: bench::Bench,
    _turn: Turn,
}

impl Deref for Bench {
    type Target = bench::Bench;

    fn deref(&self) -> &bench::Bench {
        &self.bench
    }
}

impl Bench {
    pub(crate) fn new() -> Self {
        let turn = Turn::wait();
        Self {
            bench: bench::Bench::new(real_time_arm(&["--tcp", "127.0.0.1:0"])),
            _turn: turn,
        }
    }

    /// A station that may move its arm, and its standard error.
    fn station(&self) -> (RunningProcess, impl BufRead + use<>) {
        let station = self.station_with_errors();
        self.confirm();
        station
    }

    /// A person holds a button, and the arm moves.
    pub(crate) fn jog(&self, button: &str) -> RunningProcess {
        let holder = self.spawn(&["jog", button, "--for", "60"]);
        self.wait_for_jog();
        holder
    }

    pub(crate) fn wait_for_jog(&self) {
        let moves = |command: &Command| match command {
            Command::JointJog(jog) => jog.axis.moves(),
            Command::LinearJog(jog) => jog.axis.moves(),
            _ => false,
        };
        while !moves(&self.command().1) {}
        // A few statuses later it is well under way.
        let mut statuses = 0;
        while statuses < 6 {
            statuses += usize::from(matches!(self.arm.next(), Passed::FromArm(..)));
        }
    }

    /// The commands until the arm reported the same place ten times, or the wire is closed; and when it
    /// reported that place first.
    fn until_at_rest(&self) -> (Vec<(Instant, Command)>, Instant) {
        let (mut commands, mut last, mut still) = (Vec::new(), None, 0);
        let mut since = Instant::now();
        while still < 10 {
            match self.arm.next() {
                Passed::ToArm(at, command) => commands.push((at, command)),
                Passed::FromArm(at, status) if last != Some(status) => {
                    (last, since, still) = (Some(status), at, 0);
                }
                Passed::FromArm(..) => still += 1,
                Passed::Opened => {}
                Passed::Closed => break,
            }
        }
        (commands, since)
    }

    /// Where the base of the arm is, by the arm itself: no station is there any more.
    fn base_deg(&self) -> f64 {
        let ask = [
            "status",
            "--to",
            &self.arm.address,
            "--count",
            "1",
            "--json",
        ];
        let status = self.dobot(&ask).succeeds().stdout;
        let status: Value = serde_json::from_str(&status).expect("it is JSON");
        status["base_deg"].as_f64().expect("a number")
    }

    /// The watchdog sent both packets within 0.4 s, at least three times.
    #[track_caller]
    pub(crate) fn check_words(&self, at: Instant, release: Command) {
        let (commands, rests) = self.until_at_rest();
        let sent: Vec<_> = commands.iter().filter(|packet| packet.0 >= at).collect();
        let times = |wanted| sent.iter().filter(|packet| packet.1 == wanted).count();
        assert!(times(release) >= 3, "{sent:?}");
        assert!(times(LASER_OFF) >= 3, "{sent:?}");
        assert!(
            sent.iter()
                .all(|packet| [release, LASER_OFF].contains(&packet.1)),
            "{sent:?}"
        );
        let after = sent[0].0.saturating_duration_since(at);
        assert!(after <= Duration::from_millis(400), "{after:?}");
        // The run-down, and a status on its way.
        let rested = rests.saturating_duration_since(at);
        assert!(rested <= Duration::from_millis(400 + 1200), "{rested:?}");
    }
}

fn signal(station: &RunningProcess, signal: rustix::process::Signal) {
    rustix::process::kill_process(station.pid(), signal).expect("it is there");
}

#[test]
fn an_arm_whose_station_is_killed_during_a_joint_jog_is_released() {
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
fn an_arm_used_without_a_station_is_released_when_the_verb_is_killed() {
    let bench = Bench::new();
    let to = ["--to", &bench.arm.address, "--pose-confirmed"];
    let mut verb = bench.spawn(&[&["jog", "base+", "--for", "60"][..], &to].concat());
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
        let (_, rest) = stat.rsplit_once(')')?;
        let is_child = rest.split_whitespace().nth(1) == Some(&parent);
        is_child.then(|| rustix::process::Pid::from_raw(number))?
    };
    all.flatten().filter_map(child).collect()
}

#[cfg(target_os = "linux")]
#[test]
fn a_killed_watchdog_is_replaced_and_the_next_one_releases_the_arm() {
    let bench = Bench::new();
    let (mut station, mut errors) = bench.station();
    let watchdogs = children(station.pid());
    assert_eq!(watchdogs.len(), 1, "{watchdogs:?}");
    rustix::process::kill_process(watchdogs[0], rustix::process::Signal::KILL)
        .expect("it is there");
    line_with("has been replaced", &mut errors);
    let _holder = bench.jog("base+");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, JOINT_RELEASE);
}

/// The station of an arm that burns.
fn burning(bench: &Bench) -> (RunningProcess, RunningProcess) {
    let (station, _) = bench.bench.station();
    bench.confirm();
    let file = bench.folder().join("job.json");
    let text = serde_json::to_string(&spiral()).expect("it is JSON");
    std::fs::write(&file, text).expect("there is room");
    let submit = ["jobs", "submit", file.to_str().expect("the path is text")];
    bench.dobot(&submit).succeeds();
    let follower = bench.spawn(&["jobs", "start", "1", "--arm-laser", "600"]);
    let mut burnt = 0;
    while burnt < 3 {
        burnt += usize::from(burns(&bench.command().1));
    }
    (station, follower)
}

#[test]
fn a_laser_whose_station_is_killed_or_frozen_is_off_within_two_fifths_of_a_second() {
    use rustix::process::Signal;
    for how in [Signal::KILL, Signal::STOP] {
        let bench = Bench::new();
        let (station, _follower) = burning(&bench);
        let at = Instant::now();
        signal(&station, how);
        let (commands, _) = bench.until_at_rest();
        let mut after = commands.iter().filter(|packet| packet.0 > at);
        // What the station had sent before may still be on the wire.
        let first = after.find(|packet| !matches!(packet.1, Command::WriteVector(_)));
        let (sent, first) = first.expect("the watchdog speaks");
        assert_eq!(*first, LASER_OFF, "{how:?}");
        let within = sent.saturating_duration_since(at);
        assert!(within <= Duration::from_millis(400), "{how:?}: {within:?}");
    }
}

#[test]
fn an_arm_whose_station_is_killed_during_a_linear_jog_is_released_and_the_next_start_reports_it() {
    let bench = Bench::new();
    let (mut station, _errors) = bench.station();
    let _holder = bench.jog("y-");
    let at = Instant::now();
    station.kill();
    bench.check_words(at, LINEAR_RELEASE);
    let mut again = RunningProcess::new(bench.up(&[]));
    again.wait_for_line("the station ended without a goodbye: the watchdog switched the laser off");
    // Once is enough.
    assert_eq!(again.interrupt(), Some(0));
    let note = std::fs::read_to_string(bench.folder().join("watchdog.txt"));
    assert_eq!(note.expect("it is there"), "");
}

#[test]
fn an_arm_whose_station_is_frozen_is_released_and_the_station_reports_it_when_it_continues() {
    use rustix::process::Signal;
    let bench = Bench::new();
    let (station, mut errors) = bench.station();
    let _holder = bench.jog("base-");
    let at = Instant::now();
    signal(&station, Signal::STOP);
    bench.check_words(at, JOINT_RELEASE);
    let on = Instant::now();
    signal(&station, Signal::CONT);
    line_with("the station hung for", &mut errors);
    line_with("the station was silent for", &mut errors);
    // Its first packet is laser off; it does not resume the jog.
    let first = loop {
        match bench.command() {
            // Once more by the watchdog, which continues until it receives a byte of the arm or the station.
            (_, JOINT_RELEASE) => {}
            (at, command) if at > on => break command,
            // The watchdog's last words may still be on the wire.
            _ => {}
        }
    };
    assert_eq!(first, LASER_OFF);
}

#[test]
fn a_silent_listener_in_place_of_a_station_does_not_keep_the_laser_on() {
    let bench = Bench::new();
    let silent = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = silent.local_addr().expect("it has an address");
    let file = format!("address = \"http://{address}\"\npid = 1\n");
    std::fs::write(bench.folder().join("station.toml"), file).expect("there is room");
    let at = Instant::now();
    let _station = RunningProcess::new(bench.up(&[]));
    let (sent, first) = bench.command();
    assert_eq!(first, LASER_OFF);
    let after = sent.saturating_duration_since(at);
    assert!(after < Duration::from_secs(3), "{after:?}");
}
