//! Supplies session and journal with what the job needs next.

use std::time::Duration;

use dobot_api::{JobKind, JobPhase};
use dobot_journal::Window;
use dobot_session::CommandId;
use dobot_wire::{Command, Status};

use crate::refusal::Refusal;
use crate::supervisor::arm::Arm;
use crate::supervisor::run::observe::grip_check::{SEEN_WITHIN, UnseenGrip};
use crate::supervisor::run::{
    Effect, JobEffect, Phase, RestMode, Run, RunTime, SentCommand, ToolHeight,
};

impl Run {
    /// Handles a command that was dropped before it was sent.
    pub(in crate::supervisor) fn handle_forgotten(&mut self, id: CommandId) {
        if let Some(at) = self.given.iter().position(|sent| sent.id == id) {
            let index = self.given[at].index;
            self.given.truncate(at);
            self.next = self.next.min(index);
        }
        // The tool is still up.
        if let ToolHeight::Lowering(lowering, command) = self.tool
            && lowering == id
        {
            self.tool = ToolHeight::Above(command);
        }
    }

    /// Handles a finished command of the job or its approach. Returns whether a failed one concerns
    /// the job.
    pub(in crate::supervisor) fn handle_over(
        &mut self,
        id: CommandId,
        now: Duration,
        is_done: bool,
        status: Option<&Status>,
    ) -> bool {
        let of_job = self.given.iter().position(|sent| sent.id == id);
        let of_way = match &self.phase {
            Phase::Approaching { last } => *last == Some(id),
            _ => matches!(self.tool, ToolHeight::Lowering(lowering, _) if lowering == id),
        };
        if let Some(at) = of_job {
            self.over(at, now, is_done, status);
        }
        if !is_done {
            return of_job.is_some() || of_way || self.is_approaching();
        }
        if of_way && self.is_approaching() {
            self.start_commands(now);
        } else if of_way {
            self.tool = ToolHeight::Down;
        }
        false
    }

    /// Supplies session and journal. The tool is lifted only if `may_lift`.
    pub(in crate::supervisor) fn feed(&mut self, arm: &mut Arm, may_lift: bool) -> Vec<JobEffect> {
        if matches!(self.phase, Phase::Approaching { last: None }) {
            self.start_commands(arm.now());
        }
        if !self.gives() {
            return Vec::new();
        }
        let mut effects: Vec<_> = self.ask_journal(arm.last()).into_iter().collect();
        while arm.session().waiting() < KEEP_WAITING
            && let Some(command) = self.next_command()
        {
            let command = self.scaled(command);
            let given = self.set_target_speed(arm).and_then(|()| self.lower(arm));
            let given = given.and_then(|()| self.send(arm, &command));
            if let Err(refusal) = given {
                arm.send_laser_off();
                effects.push(self.drain(JobPhase::Paused, &refusal.to_string(), RestMode::Lifted));
                break;
            }
        }
        effects.extend(self.reach_limit(arm, may_lift));
        effects
    }

    fn next_command(&mut self) -> Option<Command> {
        if self.next >= self.upto() || !self.permit.allows(self.next) || self.waits_for_grip() {
            return None;
        }
        let speed_mm_s = self.speed_mm_s();
        self.speeds
            .command(&self.started.plan, self.next, speed_mm_s)
    }

    /// Scales a program's targets to its current speed.
    fn scaled(&self, command: Command) -> Command {
        match command {
            Command::PlaybackAdjustment(adjustment) if self.started.kind == JobKind::Program => {
                self.started.at_speed(adjustment).into()
            }
            command => command,
        }
    }

    fn set_target_speed(&mut self, arm: &mut Arm) -> Result<(), Refusal> {
        if let Some(speed) = self.target_speed.take() {
            arm.send(&speed.into())?;
        }
        Ok(())
    }

    /// Lowers the tool only when a command follows directly: a pen that rests on the paper makes a
    /// blot.
    fn lower(&mut self, arm: &mut Arm) -> Result<(), Refusal> {
        if let ToolHeight::Above(command) = self.tool {
            // If that fails, no command of the job follows.
            self.tool = ToolHeight::Down;
            self.tool = ToolHeight::Lowering(arm.send(&command)?, command);
        }
        Ok(())
    }

    fn send(&mut self, arm: &mut Arm, command: &Command) -> Result<(), Refusal> {
        let id = arm.send(command)?;
        let (index, carry_over) = (self.next, self.after(self.carry_over(), command));
        self.given.push_back(SentCommand {
            id,
            index,
            carry_over,
        });
        self.next += 1;
        Ok(())
    }

    /// Handles the end of the given commands, where the job rests for a person or to be lifted.
    fn reach_limit(&mut self, arm: &mut Arm, may_lift: bool) -> Option<JobEffect> {
        if self.next < self.upto() {
            return None;
        }
        match &self.phase {
            Phase::Running { .. } => self.wait_for_person(),
            Phase::Draining {
                then,
                reason,
                rests: RestMode::Lifted,
                ..
            } => {
                let (then, reason) = (*then, reason.clone());
                self.lift(arm, may_lift, then, reason);
                None
            }
            _ => None,
        }
    }

    fn wait_for_person(&mut self) -> Option<JobEffect> {
        let here = self
            .started
            .next_pause()
            .filter(|(before, _)| *before == self.next);
        if let Some((_, message)) = here {
            let message = message.to_owned();
            return Some(self.drain(JobPhase::Paused, &message, RestMode::ForPerson));
        }
        let is_over = self.next == self.started.end();
        let here = self
            .step_end
            .filter(|step_end| *step_end == self.next && !is_over);
        here.map(|_| self.drain(JobPhase::Paused, "the step is done", RestMode::AsItIs))
    }

    /// Asks the journal early, so that the arm does not wait for the disk.
    fn ask_journal(&mut self, status: Option<Status>) -> Option<JobEffect> {
        if !self.permit.is_low(self.next) {
            return None;
        }
        let completed = self.started.completed;
        let upto = self.window_end(&status?).min(self.upto());
        let counted = self.started.counted(Window {
            completed,
            upto,
            start: self.start(),
        });
        let effect = Effect::ExtendWindow {
            job: self.job(),
            completed: counted.completed,
            upto: counted.upto,
            start: counted.start,
        };
        self.permit
            .ask(upto, completed)
            .then_some(JobEffect::Write(effect))
    }

    /// Starts the commands once the resume point is reached, up to the next pause for a person.
    fn start_commands(&mut self, now: Duration) {
        self.phase = self.running();
        self.ran = Some(RunTime {
            since: now,
            last_over: now,
        });
    }

    const fn is_approaching(&self) -> bool {
        matches!(self.phase, Phase::Approaching { .. })
    }

    /// Returns whether there are commands to give.
    fn gives(&self) -> bool {
        match self.phase {
            Phase::Running { .. } => true,
            Phase::Draining { upto, rests, .. } => rests == RestMode::Lifted || self.next < upto,
            _ => false,
        }
    }

    /// Returns the first command that may not be given: there the job comes to rest.
    const fn upto(&self) -> usize {
        match self.phase {
            Phase::Running { upto } | Phase::Draining { upto, .. } => upto,
            _ => self.next,
        }
    }

    /// Handles the end of a given command.
    fn over(&mut self, at: usize, now: Duration, is_done: bool, status: Option<&Status>) {
        let given = self.given.remove(at).expect("it was found there");
        if let Some(ran) = &mut self.ran {
            ran.last_over = now;
        }
        if !is_done || self.started.completed != given.index {
            return;
        }
        if status.is_some_and(|status| self.shows_grip(given.index, status)) {
            self.handle_done(given, now);
        } else {
            let until = now + SEEN_WITHIN;
            self.unseen = Some(UnseenGrip {
                command: given,
                until,
            });
        }
    }

    pub(in crate::supervisor::run) fn handle_done(&mut self, given: SentCommand, now: Duration) {
        self.started.completed = given.index + 1;
        self.carry_over = given.carry_over;
        self.handle_progress(now);
    }
}

/// This many commands wait in the session, so that a permit always finds one.
const KEEP_WAITING: usize = 2;
