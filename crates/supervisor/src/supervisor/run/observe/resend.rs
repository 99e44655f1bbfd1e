//! Resending lost commands: a program continues by itself where that is safe.

use dobot_api::JobPhase;
use dobot_journal::Window;
use dobot_wire::Command;

use crate::refusal::Refusal;
use crate::supervisor::arm::Arm;
use crate::supervisor::run::{JobEffect, Phase, RestMode, Run, StartedJob};

/// How often the same command was sent again in a row.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Retries {
    /// The command, counted over all cycles.
    command: usize,
    times: u32,
}

impl Run {
    /// Handles a failed command: the job comes to rest, to continue by itself if that is safe.
    pub(in crate::supervisor) fn fail(&mut self, why: &str) -> Option<JobEffect> {
        let is_running = matches!(self.phase, Phase::Running { .. });
        if !is_running || !self.may_resend() {
            return self.interrupt(why);
        }
        let counted = self.started.completed + self.started.back;
        let before = if self.retries.command == counted {
            self.retries.times
        } else {
            0
        };
        self.retries = Retries {
            command: counted,
            times: before + 1,
        };
        let window = self.certain();
        self.started.doubt = Some(Window {
            upto: self.next,
            ..window
        });
        Some(self.drain(
            JobPhase::Running,
            &format!("{why}; it is sent again"),
            RestMode::ToResend,
        ))
    }

    /// Returns whether commands may be sent again. A target is absolute and may be sent again
    /// wherever the arm is; vectors are relative.
    fn may_resend(&self) -> bool {
        let counted = self.started.completed + self.started.back;
        let is_new = self.retries.command != counted;
        let sent = self.started.completed..self.next;
        let mut sent = self.started.plan.commands()[sent].iter();
        let leads_somewhere = sent.all(|command| !matches!(command, Command::WriteVector(_)));
        leads_somewhere && (is_new || self.retries.times < MAX_RETRIES)
    }

    /// Pauses the job because lost commands cannot be sent again.
    pub(in crate::supervisor) fn give_up(&mut self, why: &str) -> JobEffect {
        self.drain(JobPhase::Paused, why, RestMode::AsItIs)
    }

    /// Continues from where the arm rests: after what it has done or, if that is unclear, from the
    /// first command not seen to be done.
    pub(in crate::supervisor) fn resend_lost(
        &self,
        arm: &mut Arm,
    ) -> Result<(Self, Vec<JobEffect>), Refusal> {
        let started = self.started.clone();
        let started = StartedJob {
            single_step: self.step_end.is_some(),
            ..started
        };
        let (mut run, effects) = Self::begin(started.clone(), arm, Some(self)).or_else(|_| {
            let started = StartedJob {
                doubt: None,
                ..started
            };
            Self::begin(started, arm, Some(self))
        })?;
        run.retries = self.retries;
        // A notice has said already that it continues.
        let kept = effects
            .into_iter()
            .filter(|effect| matches!(effect, JobEffect::WritePhase(_)));
        Ok((run, kept.collect()))
    }
}

/// A link that loses the same command this often is broken.
const MAX_RETRIES: u32 = 5;
