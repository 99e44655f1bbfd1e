//! The commands of a job that are done again and again.

use dobot_api::JobProgram;
use dobot_wire::Command;

/// The commands at the end of a job that are done again.
///
/// ```text
///   once     first time   second     third ...      how a job is done
///   |--------|------------|----------|----------
///   0      from         end        end + len        places in a plan
///                         ^----------^              a job that is here goes back by `len`
/// ```
///
/// The first cycle begins wherever the commands before it leave the arm, each later one where the cycle
/// before it does. So a job whose second cycle is over stands where it stood when the first one was: its
/// places in the plan go back by a cycle, and the journal counts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::supervisor) struct Cycle {
    pub(in crate::supervisor) from: usize,
    pub(in crate::supervisor) len: usize,
    /// How often it is done in all; `None` where that goes on until a person ends it.
    pub(in crate::supervisor) times: Option<u64>,
}

impl Cycle {
    /// The cycle of a job with so many commands.
    pub(super) fn of(program: &JobProgram, commands: usize) -> Option<Self> {
        let repeat = program.repeat?;
        Some(Self {
            from: repeat.from,
            len: commands.checked_sub(repeat.from).filter(|it| *it > 0)?,
            times: repeat.times,
        })
    }

    /// Where the first cycle ends.
    pub(in crate::supervisor) const fn end(&self) -> usize {
        self.from + self.len
    }

    /// The commands with their cycle as often as it takes: twice, and as far beyond as is ever looked
    /// ahead.
    pub(super) fn unroll(&self, mut commands: Vec<Command>) -> Vec<Command> {
        let most = 2 + AHEAD.div_ceil(self.len);
        let times = usize::try_from(self.times.unwrap_or(u64::MAX)).unwrap_or(usize::MAX);
        let cycle = commands[self.from..].to_vec();
        for _ in 1..most.min(times) {
            commands.extend_from_slice(&cycle);
        }
        commands
    }

    /// By how many cycles a job goes back of which so many commands are over.
    pub(in crate::supervisor) const fn cycles_back(&self, completed: usize) -> usize {
        (completed.saturating_sub(self.from) / self.len).saturating_sub(1)
    }

    /// Where the job ends, in a plan that has gone back by so many cycles.
    pub(in crate::supervisor) fn job_end(&self, cycles_back: usize) -> usize {
        let times = self
            .times
            .map_or(usize::MAX, |it| usize::try_from(it).unwrap_or(usize::MAX));
        let left = times.saturating_sub(cycles_back);
        left.saturating_mul(self.len).saturating_add(self.from)
    }
}

/// No window of the journal, and no command that waits, is farther ahead.
const AHEAD: usize = 64;
