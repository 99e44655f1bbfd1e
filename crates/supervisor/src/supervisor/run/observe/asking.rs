//! Questions of a program: asked at rest after its last command, answered by more commands.

use std::time::Duration;

use dobot_api::{Answer, JobPhase, News, PendingQuestion, Question};

use crate::supervisor::arm::Arm;
use crate::supervisor::run::{JobEffect, Phase, Run, StartedJob};

/// What is due for a question without an answer.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::supervisor) enum DueAnswer {
    /// This answer: the station's own, or the one after the timeout.
    Answer {
        /// The job.
        job: u64,
        /// The answer.
        answer: Answer,
    },
    /// A pause, for this reason: nobody answered in time.
    Pause(String),
}

impl Run {
    /// Asks the question after the last command.
    pub(crate) fn ask(&mut self, arm: &mut Arm) -> Vec<JobEffect> {
        if self.asked_at.is_some() {
            return Vec::new();
        }
        arm.send_laser_off();
        self.asked_at = Some(arm.now());
        let (job, title) = (self.job(), &self.started.title);
        let Some(pending) = self.question() else {
            return Vec::new();
        };
        let text = format!("job {job} ({title}) asks: {}", pending.question);
        let news = News::JobAsks { job };
        vec![JobEffect::Notify(news, text)]
    }

    /// Returns the question that the job waits for, unless the station itself answers it.
    pub(in crate::supervisor) fn question(&self) -> Option<&PendingQuestion> {
        let pending = self.pending()?;
        (pending.question != Question::NextCycle).then_some(pending)
    }

    fn pending(&self) -> Option<&PendingQuestion> {
        self.asked_at?;
        self.started.program.question()
    }

    /// Returns the number of answers so far, if the job waits for another one.
    pub(in crate::supervisor) fn answers(&self) -> Option<usize> {
        self.pending()?;
        let asking = self.started.program.asking.as_ref()?;
        Some(asking.answers.len())
    }

    /// Returns what is due now for the question.
    pub(in crate::supervisor) fn due_answer(&self, now: Duration) -> Option<DueAnswer> {
        let (pending, asked_at) = (self.pending()?, self.asked_at?);
        let job = self.job();
        if pending.question == Question::NextCycle {
            let answer = Answer::NextCycle;
            return Some(DueAnswer::Answer { job, answer });
        }
        let timeout_s = pending.timeout_s?;
        if now.saturating_sub(asked_at).as_secs_f64() < timeout_s {
            return None;
        }
        Some(match pending.otherwise.clone() {
            Some(answer) => DueAnswer::Answer { job, answer },
            None => DueAnswer::Pause(format!(
                "nobody answered within {timeout_s} s: {}",
                pending.question
            )),
        })
    }

    /// Continues with the longer program that follows an answer.
    pub(in crate::supervisor) fn extend(&mut self, longer: StartedJob) -> JobEffect {
        let (job, commands) = (self.job(), longer.commands);
        self.started.plan = longer.plan;
        self.started.pauses = longer.pauses;
        self.started.program = longer.program;
        self.started.commands = commands;
        self.reach = None;
        self.asked_at = None;
        // An answer ends the step; the next one runs on request only.
        self.step_end = self.step_end.map(|_| self.started.completed);
        let answer = self.started.program.asking.as_ref();
        let answer = answer.and_then(|asking| asking.answers.last());
        let text = answer.map_or_else(String::new, |answer| format!("job {job}: {answer}"));
        if matches!(self.phase, Phase::Running { .. }) {
            self.phase = self.running();
        }
        JobEffect::Notify(News::JobAnswered { job }, text)
    }

    /// Returns whether the job may ask: all its commands are over.
    pub(crate) fn asks(&self) -> bool {
        self.view_phase() == JobPhase::Running && self.started.program.question().is_some()
    }
}
