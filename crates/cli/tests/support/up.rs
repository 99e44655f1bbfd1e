//! A station as a separate process.

use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;
use tempfile::TempDir;

use super::api::Api;
use super::arm::FAST;
use super::program::{Outcome, command_at, run};
use super::running_process::RunningProcess;

/// A station with a virtual arm.
pub(crate) struct Up {
    pub(crate) station: RunningProcess,
    pub(crate) folder: TempDir,
    /// Where page and API are served.
    pub(crate) page: String,
    /// Where raw packets are served.
    pub(crate) raw: String,
}

impl Up {
    /// Its arm only has to arrive.
    pub(crate) fn new(arguments: &[&str]) -> Self {
        Self::at_speed(FAST, arguments)
    }

    /// The speed of its arm, as a multiple of real time.
    pub(crate) fn at_speed(speed: &str, arguments: &[&str]) -> Self {
        Self::with_arm(&["--virtual", "--time-factor", speed], arguments)
    }

    /// A station that is started with these arguments for its arm.
    pub(crate) fn with_arm(arm: &[&str], arguments: &[&str]) -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        Self::in_folder(folder, arm, arguments)
    }

    /// Another station with the data of this one, which has ended, and a virtual arm.
    pub(crate) fn again(self) -> Self {
        Self::with_data(self.folder)
    }

    /// A station with a virtual arm and the data in a folder.
    pub(crate) fn with_data(folder: TempDir) -> Self {
        Self::in_folder(folder, &["--virtual", "--time-factor", FAST], &[])
    }

    /// A station with the data in a folder.
    pub(crate) fn in_folder(folder: TempDir, arm: &[&str], arguments: &[&str]) -> Self {
        let ports = ["--http", "127.0.0.1:0", "--raw", "127.0.0.1:0"];
        let arguments = [&["up"], arm, &ports[..], arguments].concat();
        let mut station = RunningProcess::new(command_at(folder.path(), &arguments));
        let word = |line: String| {
            let word = line
                .split_whitespace()
                .find(|part| part.contains("127.0.0.1"));
            word.expect("an address").to_owned()
        };
        let page = word(station.wait_for_line("  page"));
        let raw = word(station.wait_for_line("raw packets")).replace("tcp:", "");
        station.wait_for_line("Ctrl-C");
        Self {
            station,
            folder,
            page,
            raw,
        }
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        command_at(self.folder.path(), arguments)
    }

    pub(crate) fn dobot(&self, arguments: &[&str]) -> Outcome {
        run(&mut self.command(arguments), b"")
    }

    pub(crate) fn json(&self, arguments: &[&str]) -> Value {
        let outcome = self.dobot(&[arguments, &["--json"]].concat()).succeeds();
        serde_json::from_str(&outcome.stdout).expect("it is JSON")
    }

    /// Waits until the station reports a matching state.
    pub(crate) fn wait_for_state(&self, is_match: impl Fn(&Value) -> bool) -> Value {
        Api::new(&self.page).wait_for_state(is_match)
    }

    /// Waits until a job runs.
    pub(crate) fn runs_a_job(&self) {
        self.wait_for_state(|state| state["job"]["phase"] == "running");
    }

    /// The file with its address.
    pub(crate) fn file(&self) -> PathBuf {
        self.folder.path().join("station.toml")
    }
}
