//! Virtual arms as processes of their own.

use std::iter;
use std::sync::mpsc::Receiver;

use dobot_wire::Command;

use super::PATIENCE;
use super::program::command;
use super::running_process::RunningProcess;
use super::wire::{Passed, wire};

/// How fast time passes for an arm that only has to arrive.
pub(crate) const FAST: &str = "8";

/// `dobot arm` with its time as fast as a clock's.
pub(crate) fn real_time_arm(arguments: &[&str]) -> RunningProcess {
    RunningProcess::new(command(&[&["arm"], arguments].concat()))
}

/// `dobot arm` that only has to arrive.
pub(crate) fn fast_arm(arguments: &[&str]) -> RunningProcess {
    real_time_arm(&[&["--time-factor", FAST], arguments].concat())
}

/// An arm at the end of a wire that records the packets.
pub(crate) struct WiredArm {
    _arm: RunningProcess,
    /// The end that a station connects to.
    pub(crate) address: String,
    pub(crate) passed: Receiver<Passed>,
}

impl WiredArm {
    /// An arm that is served over TCP.
    pub(crate) fn new(mut arm: RunningProcess) -> Self {
        let address = arm.address();
        let address = address.trim_start_matches("tcp:");
        let (wire, passed) = wire(address.parse().expect("an address"));
        Self {
            _arm: arm,
            address: format!("tcp:{wire}"),
            passed,
        }
    }

    /// Waits for what passes next.
    pub(crate) fn next(&self) -> Passed {
        let next = self.passed.recv_timeout(PATIENCE);
        next.expect("something passes the wire")
    }

    /// The commands that the arm got, when the program that sent them has ended.
    pub(crate) fn got(&self) -> Vec<Command> {
        let all = iter::repeat_with(|| self.next());
        let until_closed = all.take_while(|passed| !matches!(passed, Passed::Closed));
        let of_arm = |passed| match passed {
            Passed::ToArm(_, command) => Some(command),
            _ => None,
        };
        until_closed.filter_map(of_arm).collect()
    }
}
