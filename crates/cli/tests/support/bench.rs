//! A station that is killed and started again, and its arm at the end of a wire.

use std::io::BufRead;
use std::path::Path;
use std::time::Instant;

use dobot_wire::Command;
use tempfile::TempDir;

use super::arm::WiredArm;
use super::program::{Outcome, command_at, run};
use super::running_process::RunningProcess;
use super::wire::Passed;

/// An arm at the end of a wire that records, and the data of a station.
pub(crate) struct Bench {
    pub(crate) arm: WiredArm,
    folder: TempDir,
}

impl Bench {
    pub(crate) fn new(arm: RunningProcess) -> Self {
        Self {
            arm: WiredArm::new(arm),
            folder: tempfile::tempdir().expect("there is room"),
        }
    }

    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// A station that starts.
    pub(crate) fn up(&self, others: &[&str]) -> std::process::Command {
        let free: &[&str] = if others.contains(&"--http") {
            &[]
        } else {
            &["--http", "127.0.0.1:0"]
        };
        let arm = [
            "up",
            "--dialect",
            "specification",
            "--arm",
            &self.arm.address,
        ];
        let ports = [&["--raw", "off"], free].concat();
        command_at(self.folder(), &[&arm[..], &ports, others].concat())
    }

    /// A station that is there, and the address of its page.
    pub(crate) fn station(&self) -> (RunningProcess, String) {
        let mut station = RunningProcess::new(self.up(&[]));
        let page = station.wait_for_line("  page");
        let page = page.split_whitespace().last().expect("an address");
        station.wait_for_line("Ctrl-C");
        (station, page.to_owned())
    }

    /// A running station and its standard error.
    pub(crate) fn station_with_errors(&self) -> (RunningProcess, impl BufRead + use<>) {
        let (mut station, errors) = RunningProcess::with_errors(self.up(&[]));
        station.wait_for_line("Ctrl-C");
        (station, errors)
    }

    /// A person has looked at the arm.
    pub(crate) fn confirm(&self) {
        self.dobot(&["confirm", "--yes"]).succeeds();
    }

    pub(crate) fn dobot(&self, arguments: &[&str]) -> Outcome {
        run(&mut command_at(self.folder(), arguments), b"")
    }

    pub(crate) fn spawn(&self, arguments: &[&str]) -> RunningProcess {
        RunningProcess::new(command_at(self.folder(), arguments))
    }

    /// The command that passes next, unless it is something else that passes.
    pub(crate) fn next_command(&self) -> Option<(Instant, Command)> {
        match self.arm.next() {
            Passed::ToArm(at, command) => Some((at, command)),
            Passed::FromArm(..) | Passed::Opened | Passed::Closed => None,
        }
    }

    /// Waits for the next command.
    pub(crate) fn command(&self) -> (Instant, Command) {
        loop {
            if let Some(command) = self.next_command() {
                return command;
            }
        }
    }
}
