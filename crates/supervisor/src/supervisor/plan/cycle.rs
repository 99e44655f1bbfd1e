//! The repeated commands of a job.

use dobot_api::JobProgram;
use dobot_wire::Command;

/// The commands at the end of a job that repeat.
///
/// ```text
///   once     first time   second     third ...      how a job is done
///   |--------|------------|----------|----------
///   0      from         end        end + len        places in a plan
///                         ^----------^              a job that is here goes back by `len`
/// ```
///
/// The first cycle starts wherever the preceding commands leave the arm, each later one where the
/// previous cycle does. So after its second cycle a job is where it was after the first: its
/// position in the plan moves back by a cycle, and the journal keeps counting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::supervisor) struct Cycle {
    pub(in crate::supervisor) from: usize,
    pub(in crate::supervisor) len: usize,
    /// The total number of cycles; `None` if it repeats until it is ended.
    pub(in crate::supervisor) times: Option<u64>,
}

impl Cycle {
    /// Returns the cycle of a job with this number of commands.
    pub(super) fn of(program: &JobProgram, commands: usize) -> Option<Self> {
        let repeat = program.repeat?;
        Some(Self {
            from: repeat.from,
            len: commands.checked_sub(repeat.from).filter(|len| *len > 0)?,
            times: repeat.times,
        })
    }

    /// Returns the end of the first cycle.
    pub(in crate::supervisor) const fn end(&self) -> usize {
        self.from + self.len
    }

    /// Unrolls the cycle: twice, plus the farthest look-ahead.
    pub(super) fn unroll(&self, mut commands: Vec<Command>) -> Vec<Command> {
        let most = 2 + AHEAD.div_ceil(self.len);
        let times = usize::try_from(self.times.unwrap_or(u64::MAX)).unwrap_or(usize::MAX);
        let cycle = commands[self.from..].to_vec();
        for _ in 1..most.min(times) {
            commands.extend_from_slice(&cycle);
        }
        commands
    }

    /// Returns the number of cycles to move back after this many completed commands.
    pub(in crate::supervisor) const fn cycles_back(&self, completed: usize) -> usize {
        (completed.saturating_sub(self.from) / self.len).saturating_sub(1)
    }

    /// Returns the end of the job in a plan that has moved back by this many cycles.
    pub(in crate::supervisor) fn job_end(&self, cycles_back: usize) -> usize {
        let times = self.times.map_or(usize::MAX, |times| {
            usize::try_from(times).unwrap_or(usize::MAX)
        });
        let left = times.saturating_sub(cycles_back);
        left.saturating_mul(self.len).saturating_add(self.from)
    }
}

/// No journal window and no waiting command is farther ahead.
const AHEAD: usize = 64;
