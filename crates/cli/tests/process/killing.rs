//! A station that is killed while the laser burns, and started again, as processes.

use dobot_wire::Command;
use serde_json::Value;

use crate::support::api::Api;
use crate::support::arm::real_time_arm;
use crate::support::bench::Bench;
use crate::support::running_process::RunningProcess;
use crate::support::spiral::{LASER_OFF, burns, spiral};
use crate::support::wire::Passed;

/// An arm and its burned lines.
struct Burning {
    bench: Bench,
    burnt: Vec<Command>,
}

impl Burning {
    fn new() -> Self {
        Self {
            // As fast as a clock: the job is not to be over before the station is killed.
            bench: Bench::new(real_time_arm(&["--tcp", "127.0.0.1:0"])),
            burnt: Vec::new(),
        }
    }

    /// A station that is there, and its API.
    fn station(&self) -> (RunningProcess, Api) {
        let (station, page) = self.bench.station();
        (station, Api::new(&page))
    }

    /// Waits for what passes the wire, and keeps commands that burn.
    fn next(&mut self) -> Passed {
        let next = self.bench.arm.next();
        if let Passed::ToArm(_, command) = next
            && burns(&command)
        {
            self.burnt.push(command);
        }
        next
    }

    /// Resumes the job until this many vectors have burned. A station that hangs on a busy machine pauses it.
    fn burns_until(&mut self, count: usize) -> RunningProcess {
        let mut follower = self.start();
        while self.burnt.len() < count {
            if follower.has_ended() {
                follower = self.start();
            }
            self.next();
        }
        follower
    }

    /// The first command after the wire was opened.
    fn first_of_station(&mut self) -> Command {
        while !matches!(self.next(), Passed::Opened) {}
        loop {
            match self.next() {
                Passed::ToArm(_, command) => return command,
                Passed::FromArm(..) | Passed::Closed => {}
                Passed::Opened => panic!("the wire was opened again before a command"),
            }
        }
    }

    /// A person has checked the arm and resumes the job.
    fn start(&self) -> RunningProcess {
        self.bench.confirm();
        self.bench
            .spawn(&["jobs", "start", "1", "--arm-laser", "600"])
    }
}

#[test]
fn a_station_killed_while_burning_first_switches_the_laser_off_and_then_finishes_the_job() {
    let mut burning = Burning::new();
    let job = spiral();
    let file = burning.bench.folder().join("job.json");
    let text = serde_json::to_string(&job).expect("it is JSON");
    std::fs::write(&file, text).expect("there is room");
    let (mut station, _) = burning.station();
    assert_eq!(burning.first_of_station(), LASER_OFF);
    let submit = ["jobs", "submit", file.to_str().expect("the path is text")];
    burning.bench.dobot(&submit).succeeds();
    for kill in 1..=3 {
        let _follower = burning.burns_until(4 * kill);
        station.kill();
        let (again, api) = burning.station();
        station = again;
        assert_eq!(burning.first_of_station(), LASER_OFF, "after kill {kill}");
        // The job is paused from the first moment on; where the arm rests is found out later, and whoever
        // goes on at once waits for that.
        let is_patient = kill != 2;
        api.wait_for_state(|state| {
            let job = &state["job"];
            assert_ne!(job["phase"], "failed", "{job}");
            let reason = job["reason"].as_str().unwrap_or_default();
            let is_found = !is_patient || reason.contains("the arm rests where command");
            job["phase"] == "paused" && is_found
        });
    }
    let all = job.commands.iter().filter(|command| burns(command)).count();
    assert_eq!(burning.burns_until(all).ends(), Some(0));
    let job_1 = burning.bench.dobot(&["jobs", "show", "1", "--json"]);
    let job_1: Value = serde_json::from_str(&job_1.succeeds().stdout).expect("it is JSON");
    assert_eq!(job_1["phase"], "done", "{job_1}");
    station.kill();
    while let Ok(passed) = burning.bench.arm.passed.try_recv() {
        if let Passed::ToArm(_, command) = passed {
            burning.burnt.extend(Some(command).filter(burns));
        }
    }
    let wanted: Vec<Command> = job.commands.into_iter().filter(burns).collect();
    assert_eq!(burning.burnt, wanted, "every vector once, in its order");
}
