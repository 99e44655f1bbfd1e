//! Interrupting a job: by a person or a fault, for good or for a while.

use dobot_api::{JobPhase, News};
use dobot_journal::Window;

use crate::supervisor::arm::Arm;
use crate::supervisor::run::{Effect, JobEffect, Phase, RestMode, Run, ToolHeight, straight, word};

impl Run {
    /// Ends a job that sends no more commands, as its phase requires.
    pub(in crate::supervisor) fn end(&mut self, why: &str) -> Option<JobEffect> {
        match &mut self.phase {
            // Nothing moves for it: its progress no longer matters.
            Phase::Paused { .. } | Phase::Locating { .. } => {
                Some(self.drain(JobPhase::Stopped, why, RestMode::AsItIs))
            }
            Phase::Draining { then, reason, .. } | Phase::Lifting { then, reason, .. } => {
                *then = JobPhase::Stopped;
                why.clone_into(reason);
                Some(self.notify(JobPhase::Stopped, why))
            }
            Phase::Running { .. } | Phase::Approaching { .. } => None,
        }
    }

    /// Comes to rest along the path and lifts the tool. Unsent commands have been dropped already.
    pub(in crate::supervisor) fn come_to_rest(&mut self, then: JobPhase, why: &str) -> JobEffect {
        let rests = if self.is_down() {
            RestMode::Lifted
        } else {
            RestMode::AsItIs
        };
        let effect = self.drain(then, why, rests);
        self.brake();
        effect
    }

    /// Interrupts the job: the in-flight commands finish, then it is paused.
    pub(in crate::supervisor) fn interrupt(&mut self, why: &str) -> Option<JobEffect> {
        if self.is_at_work() {
            return Some(self.drain(JobPhase::Paused, why, RestMode::AsItIs));
        }
        if let Phase::Draining {
            then,
            reason,
            upto,
            rests,
        } = &mut self.phase
        {
            let was_to_resend = *rests == RestMode::ToResend;
            if was_to_resend {
                *then = JobPhase::Paused;
                why.clone_into(reason);
            }
            // It does not reach the place of its pause.
            if *rests == RestMode::ForPerson && self.next < *upto {
                why.clone_into(reason);
            }
            (*upto, *rests) = (self.next, RestMode::AsItIs);
            return was_to_resend.then(|| self.notify(JobPhase::Paused, why));
        }
        None
    }

    /// Interrupts a burning job and lifts the tool.
    pub(in crate::supervisor) fn interrupt_burning(&mut self, why: &str) -> JobEffect {
        self.drain(JobPhase::Paused, why, RestMode::Lifted)
    }

    pub(in crate::supervisor::run) fn drain(
        &mut self,
        then: JobPhase,
        reason: &str,
        rests: RestMode,
    ) -> JobEffect {
        self.asked_at = None;
        self.phase = Phase::Draining {
            then,
            reason: reason.to_owned(),
            upto: self.next,
            rests,
        };
        // The journal keeps it as running until nothing is in flight: after a crash before that,
        // its progress has to be found out.
        self.notify(then, reason)
    }

    /// Lifts the tool right after the last command before the rest, so that no pen rests on the
    /// paper.
    pub(crate) fn lift(&mut self, arm: &mut Arm, may_lift: bool, then: JobPhase, reason: String) {
        let up = self.lift_mm();
        let command = straight(up.into());
        let lifts = up > 0.0 && may_lift && arm.send(&command).is_ok();
        self.phase = if lifts {
            Phase::Lifting { then, reason }
        } else {
            Phase::Draining {
                then,
                reason,
                upto: self.next,
                rests: RestMode::AsItIs,
            }
        };
    }

    /// Handles the end of everything in flight: the progress is certain and is saved.
    pub(crate) fn rest(&mut self, arm: &mut Arm, then: JobPhase, reason: String) -> Vec<JobEffect> {
        if let Phase::Draining {
            rests: RestMode::ToResend,
            ..
        } = self.phase
        {
            self.next = self.started.completed;
            return vec![JobEffect::Resend];
        }
        let window = self.come_to_end(&reason);
        arm.send_laser_off();
        let mut effects = vec![JobEffect::WritePhase(Effect::Phase {
            job: self.job(),
            phase: then,
            reason: Some(reason),
            window,
            history: self.started.history,
        })];
        effects.extend(then.is_over().then_some(JobEffect::Drop));
        effects
    }

    /// Returns the progress, if it is certain.
    fn come_to_end(&mut self, reason: &str) -> Option<Window> {
        let for_person = match &self.phase {
            Phase::Draining { rests, .. } => *rests == RestMode::ForPerson,
            _ => false,
        };
        if matches!(self.phase, Phase::Lifting { .. }) {
            self.carry_over = self.after(self.carry_over, &straight(self.lift_mm().into()));
        }
        self.next = self.started.completed;
        self.cycle_times.forget();
        self.step_end = None;
        let waited = self.started.next_pause().map(|(before, _)| before);
        if for_person && waited == Some(self.next) {
            self.started.history.pauses += 1;
        }
        self.note_ran();
        self.phase = Phase::Paused {
            reason: reason.to_owned(),
        };
        self.started
            .doubt
            .is_none()
            .then(|| self.started.counted(self.certain()))
    }

    pub(crate) fn notify(&self, phase: JobPhase, reason: &str) -> JobEffect {
        let job = self.job();
        let text = format!("job {job} is {}: {reason}", word(phase));
        JobEffect::Notify(News::Job { job, phase }, text)
    }

    /// Comes to rest along the current path, if that is soon: an arm without further commands stops
    /// abruptly.
    fn brake(&mut self) {
        let carry_over = self.carry_over();
        if carry_over.moves
            && let Some(end) =
                self.speeds
                    .brake(&self.started.plan, self.next, carry_over.speed_mm_s)
            && let Phase::Draining { upto, .. } = &mut self.phase
        {
            *upto = end;
        }
    }

    /// Returns whether the tool is at the resume point, not above it or on its way.
    const fn is_down(&self) -> bool {
        !matches!(self.phase, Phase::Approaching { .. })
            && !matches!(self.tool, ToolHeight::Above(_))
    }
}
