//! Progress of a job by the statuses: how far it got, and whether it ends in the right place.

use std::ops::Range;

use dobot_api::{JobPhase, News};
use dobot_journal::{Unclear, Window, locate, model_at};
use dobot_motion::Model;
use dobot_session::position;
use dobot_wire::{Command, Status};

use crate::supervisor::JobPlan;
use crate::supervisor::arm::Arm;
use crate::supervisor::run::{Effect, JobEffect, Phase, Run, StartedJob, word};

impl Run {
    /// The number of equal statuses in a row after which nothing of a window is in flight, not even
    /// a pause.
    fn rests_after(&self, window: &Window) -> u32 {
        let commands = self.started.plan.commands();
        let upto = window.upto.min(commands.len());
        let possible = &commands[window.completed.min(upto)..upto];
        let longest_s = possible.iter().map(pause_s).fold(0.0, f32::max);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a pause is positive, and longer ones than a day are no pauses"
        )]
        let statuses = (longest_s.clamp(0.0, A_DAY_S) * STATUSES_PER_S).ceil() as u32;
        SURELY_AT_REST + statuses
    }

    /// Describes what is wrong with the final position. A vector starts wherever the arm is: if one
    /// was lost, all after it are displaced.
    fn misses_end(&self, status: &Status) -> Option<String> {
        let end = self.started.plan.start_position(self.started.end())?;
        let off_mm = end.distance(position(status)).0;
        (off_mm > THERE_MM).then(|| {
            format!(
                "the arm rests {off_mm:.2} mm from where the job ends: a command was lost, and everything after it is displaced"
            )
        })
    }

    /// Describes how long it took and how far the plan was off.
    fn took(&self) -> String {
        let Some(ran_s) = self.started.history.ran_s else {
            return String::new();
        };
        let planned = self.started.plan.planned_s();
        let planned = planned
            .map(|planned_s| format!(", planned {planned_s:.1} s"))
            .unwrap_or_default();
        format!(", in {ran_s:.1} s{planned}")
    }

    /// Checks with each status whether the job is located, drained, lifted or done.
    pub(in crate::supervisor) fn handle_status(&mut self, arm: &mut Arm) -> Vec<JobEffect> {
        match &self.phase {
            Phase::Locating { window } if arm.still() >= self.rests_after(window) => {
                let window = *window;
                self.locate(arm, &window)
            }
            Phase::Draining {
                then, reason, upto, ..
            } if self.is_idle(arm) && self.next >= *upto => {
                let (then, reason) = (*then, reason.clone());
                self.rest(arm, then, reason)
            }
            Phase::Lifting { then, reason } if self.is_idle(arm) => {
                let (then, reason) = (*then, reason.clone());
                self.rest(arm, then, reason)
            }
            Phase::Running { .. } if self.is_complete() && arm.is_at_rest() => {
                if self.asks() {
                    self.ask(arm)
                } else {
                    self.finish(arm)
                }
            }
            _ => Vec::new(),
        }
    }

    /// Returns whether nothing of the job is in flight. The session may be done with commands that
    /// it has not reported yet, or whose grip was not seen yet; the progress counts only those
    /// reported.
    fn is_idle(&self, arm: &Arm) -> bool {
        arm.is_idle() && self.given.is_empty() && self.unseen.is_none()
    }

    fn is_complete(&self) -> bool {
        self.started.completed == self.started.end()
    }

    /// Handles the end of all commands with the arm at rest: checks that it is where the job ends.
    fn finish(&mut self, arm: &mut Arm) -> Vec<JobEffect> {
        arm.send_laser_off();
        self.note_ran();
        let (job, title) = (self.job(), &self.started.title);
        let (phase, reason) = match arm.last().and_then(|status| self.misses_end(&status)) {
            None => (JobPhase::Done, None),
            Some(reason) => (JobPhase::Failed, Some(reason)),
        };
        let why = reason
            .as_ref()
            .map_or_else(|| self.took(), |reason| format!(": {reason}"));
        let text = format!("job {job} ({title}) is {}{why}", word(phase));
        let effect = Effect::Phase {
            job,
            phase,
            reason,
            window: Some(self.started.counted(self.certain())),
            history: self.started.history,
        };
        vec![
            JobEffect::WritePhase(effect),
            JobEffect::Notify(News::Job { job, phase }, text),
            JobEffect::Drop,
        ]
    }

    /// Handles an arm at rest: finds the last command that it did.
    fn locate(&mut self, arm: &mut Arm, window: &Window) -> Vec<JobEffect> {
        let Some(status) = arm.last() else {
            return Vec::new();
        };
        let restarted = Self::RESTARTED;
        let reason = match locate_at(&self.started, window, &status) {
            Ok(next) => {
                self.started.completed = next;
                let (_, next) = self
                    .started
                    .program
                    .at(next + self.started.back, self.started.commands);
                format!("{restarted}; the arm rests where command {next} begins")
            }
            Err(unclear) => {
                self.started.doubt = Some(*window);
                format!("{restarted}; {unclear}")
            }
        };
        let mut wishes = self.rest(arm, JobPhase::Paused, reason.clone());
        wishes.push(self.notify(JobPhase::Paused, &reason));
        wishes
    }
}

/// Returns the first command that was not done, from the position where the arm rests.
pub(crate) fn locate_at(
    started: &StartedJob,
    window: &Window,
    status: &Status,
) -> Result<usize, Unclear> {
    if window.completed == window.upto {
        return Ok(window.completed);
    }
    let (commands, dialect) = (started.plan.commands(), started.dialect);
    let settings = started.plan.settings_before(window.completed);
    let model = model_at(dialect, settings, window).unwrap_or_else(|| Model::new(dialect, status));
    let lift_mm = started.plan.lift();
    let next = locate(commands, window, &model, lift_mm, position(status))?.next;
    Ok(skip_seen_grips(&started.plan, next..window.upto, status))
}

/// A grip shows in the status, not in the position: grips that are seen are done.
fn skip_seen_grips(plan: &JobPlan, commands: Range<usize>, status: &Status) -> usize {
    let seen = |index: &usize| plan.grips_in_place(*index) && plan.shows_grip(*index, status);
    commands.start + commands.take_while(seen).count()
}

const fn pause_s(command: &Command) -> f32 {
    match command {
        Command::MoveTo(target) => target.pause_s,
        Command::MoveJoints(target) => target.pause_s,
        _ => 0.0,
    }
}

/// After this many equal statuses in a row everything in flight is over.
const SURELY_AT_REST: u32 = 20;
const STATUSES_PER_S: f32 = 12.5;
const A_DAY_S: f32 = 86_400.0;

/// The arm is in place within this distance.
pub(crate) const THERE_MM: f64 = 0.3;
