//! A station that is killed while the laser burns, and started again: as processes, in real time.

use std::net::SocketAddr;
use std::path::Path;
use std::sync::mpsc::Receiver;
use std::time::Duration;

use dobot_api::{JobKind, NewJob};
use dobot_wire::{
    Command, Configuration, EndEffector, JointJog, JointJogAxis, MoveTo, WriteVector,
};
use serde_json::Value;
use tempfile::TempDir;

use crate::going::Going;
use crate::program::{command, command_at, run};
use crate::wire::{Passed, wire};

const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));

/// A spiral to be burnt: no two of its points are near each other.
pub(crate) fn spiral() -> NewJob {
    let mut commands: Vec<Command> = vec![
        Configuration::EndEffector {
            tool: EndEffector::Laser,
        }
        .into(),
        MoveTo::to(220.0, 0.0, -20.0).into(),
        vector([0.0, 0.0, -10.0], false),
    ];
    commands.extend((0_u8..16).map(|line| {
        let side_mm = 4.0 + f32::from(line / 2) * 2.0;
        let way = [
            [side_mm, 0.0],
            [0.0, side_mm],
            [-side_mm, 0.0],
            [0.0, -side_mm],
        ];
        let [x, y] = way[usize::from(line % 4)];
        vector([x, y, 0.0], true)
    }));
    commands.push(vector([0.0, 0.0, 10.0], false));
    NewJob {
        title: "a burnt spiral".into(),
        kind: JobKind::Drawing,
        commands,
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    }
}

fn vector([x_mm, y_mm, z_mm]: [f32; 3], laser: bool) -> Command {
    let stroke = WriteVector::by(x_mm, y_mm, z_mm, 40.0);
    if laser { stroke.burning() } else { stroke }.into()
}

pub(crate) fn burns(command: &Command) -> bool {
    matches!(command, Command::WriteVector(it) if it.laser)
}

/// A bench with an arm, a wire that listens, and the data of a station.
struct Bench {
    _arm: Going,
    wire: SocketAddr,
    passed: Receiver<Passed>,
    folder: TempDir,
    burnt: Vec<Command>,
}

impl Bench {
    fn new() -> Self {
        let mut arm = Going::new(command(&["arm", "--tcp", "127.0.0.1:0", "--speed", "4"]));
        let address = arm.address();
        let address = address.trim_start_matches("tcp:");
        let (wire, passed) = wire(address.parse().expect("an address"));
        Self {
            _arm: arm,
            wire,
            passed,
            folder: tempfile::tempdir().expect("there is room"),
            burnt: Vec::new(),
        }
    }

    fn station(&self) -> Going {
        let arm = format!("tcp:{}", self.wire);
        let ports = ["--http", "127.0.0.1:0", "--raw", "off"];
        let arm = ["up", "--dialect", "specification", "--arm", &arm];
        let arguments = [&arm[..], &ports].concat();
        let mut station = Going::new(command_at(self.folder.path(), &arguments));
        station.reads("Ctrl-C");
        station
    }

    fn folder(&self) -> &Path {
        self.folder.path()
    }

    fn job(&self) -> Value {
        let show = ["jobs", "show", "1", "--json"];
        let outcome = run(&mut command_at(self.folder(), &show), b"").succeeds();
        serde_json::from_str(&outcome.stdout).expect("it is JSON")
    }

    /// Waits for what passes the wire to the arm, and keeps those that burn.
    fn next(&mut self) -> Passed {
        loop {
            let next = self.passed.recv_timeout(Duration::from_secs(60));
            let next = next.expect("something passes the wire within a minute");
            match next {
                Passed::FromArm(..) => continue,
                Passed::ToArm(_, command) if burns(&command) => self.burnt.push(command),
                Passed::ToArm(..) | Passed::Opened => {}
            }
            return next;
        }
    }

    /// The first command after the wire was opened.
    fn first_of_station(&mut self) -> Command {
        while !matches!(self.next(), Passed::Opened) {}
        match self.next() {
            Passed::ToArm(_, command) => command,
            other => panic!("{other:?} instead of a command"),
        }
    }

    /// A person has looked at the arm, and has the job go on.
    fn start(&self) -> Going {
        run(&mut command_at(self.folder(), &["confirm", "--yes"]), b"").succeeds();
        let start = ["jobs", "start", "1", "--arm-laser", "600"];
        Going::new(command_at(self.folder(), &start))
    }

    fn wait_until(&self, so: impl Fn(&Value) -> bool) {
        loop {
            let job = self.job();
            assert_ne!(job["phase"], "failed", "{job}");
            if so(&job) {
                return;
            }
        }
    }
}

#[test]
fn a_station_that_is_killed_while_it_burns_switches_the_laser_off_first_and_finishes_the_job() {
    let mut bench = Bench::new();
    let job = spiral();
    let file = bench.folder().join("job.json");
    let text = serde_json::to_string(&job).expect("it is JSON");
    std::fs::write(&file, text).expect("there is room");
    let mut station = bench.station();
    assert_eq!(bench.first_of_station(), LASER_OFF);
    let submit = ["jobs", "submit", file.to_str().expect("the path is text")];
    run(&mut command_at(bench.folder(), &submit), b"").succeeds();
    for kill in 1..=3 {
        let _follower = bench.start();
        while bench.burnt.len() < 4 * kill {
            bench.next();
        }
        station.kill();
        station = bench.station();
        assert_eq!(bench.first_of_station(), LASER_OFF, "after kill {kill}");
        // The job is paused from the first moment on; where the arm rests is found out later, and whoever
        // goes on at once waits for that.
        let is_patient = kill != 2;
        bench.wait_until(|job| {
            let reason = job["reason"].as_str().unwrap_or_default();
            let is_found = !is_patient || reason.contains("the arm rests where command");
            job["phase"] == "paused" && is_found
        });
    }
    let _follower = bench.start();
    bench.wait_until(|job| job["phase"] == "done");
    station.kill();
    while let Ok(passed) = bench.passed.try_recv() {
        if let Passed::ToArm(_, command) = passed {
            bench.burnt.extend(Some(command).filter(burns));
        }
    }
    let wanted: Vec<Command> = job.commands.into_iter().filter(burns).collect();
    assert_eq!(bench.burnt, wanted, "every vector once, in its order");
}
