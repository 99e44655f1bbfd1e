//! Keeping session and journal supplied with what the job needs next.

use std::time::Duration;

use dobot_client::CommandId;
use dobot_wire::{Command, Status};

use super::{Effect, Given, Phase, Run, Wish};
use crate::keeper::arm::Arm;
use crate::words::{JobPhase, Refusal};

impl Run {
    /// Takes that a command was not sent, and is forgotten.
    pub(in crate::keeper) fn handle_forgotten(&mut self, id: CommandId) {
        if let Some(at) = self.given.iter().position(|it| it.id == id) {
            let index = self.given[at].index;
            self.given.truncate(at);
            self.next = self.next.min(index);
        }
        // The tool is still above.
        let lowering = self.lowering.take_if(|(it, _)| *it == id);
        self.lower = lowering.map(|(_, command)| command).or(self.lower);
    }

    /// Takes that a command is over: of the job, or on the way to it. Says whether the job is concerned
    /// by one that failed.
    pub(in crate::keeper) fn handle_over(
        &mut self,
        id: CommandId,
        now: Duration,
        is_done: bool,
    ) -> bool {
        let of_job = self.given.iter().position(|it| it.id == id);
        let of_way = match &self.phase {
            Phase::Approaching { last } => *last == Some(id),
            _ => self.lowering.is_some_and(|(it, _)| it == id),
        };
        if let Some(at) = of_job {
            self.over(at, now, is_done);
        }
        if !is_done {
            return of_job.is_some() || of_way || self.is_approaching();
        }
        if of_way && self.is_approaching() {
            self.set_out(now);
        } else if of_way {
            self.lowering = None;
        }
        false
    }

    /// Keeps the session and the journal supplied. The tool is lifted only where it may.
    pub(in crate::keeper) fn pump(&mut self, arm: &mut Arm, may_lift: bool) -> Vec<Wish> {
        if matches!(self.phase, Phase::Approaching { last: None }) {
            self.set_out(arm.now());
        }
        if !self.gives() {
            return Vec::new();
        }
        let mut wishes: Vec<_> = self.ask_journal(arm.last()).into_iter().collect();
        while arm.session().waiting() < KEEP_WAITING
            && let Some(command) = self.next_command()
        {
            let given = self.lower(arm).and_then(|()| self.give(arm, &command));
            if let Err(refusal) = given {
                arm.part_from_laser();
                wishes.push(self.drain(JobPhase::Paused, &refusal.to_string(), true));
                break;
            }
        }
        wishes.extend(self.reach_limit(arm, may_lift));
        wishes
    }

    fn next_command(&mut self) -> Option<Command> {
        if self.next >= self.limit.min(self.durable) || self.unkept.is_some() {
            return None;
        }
        let speed_mm_s = self.speed_mm_s();
        self.pace.command(&self.begun.plan, self.next, speed_mm_s)
    }

    /// The tool goes down only when the job goes on right behind that: a pen that stands on the paper
    /// makes a blot.
    fn lower(&mut self, arm: &mut Arm) -> Result<(), Refusal> {
        if let Some(command) = self.lower.take() {
            arm.check_way(&command)?;
            let id = arm.session_mut().send(command)?;
            self.lowering = Some((id, command));
        }
        Ok(())
    }

    fn give(&mut self, arm: &mut Arm, command: &Command) -> Result<(), Refusal> {
        arm.check_way(command)?;
        let id = arm.session_mut().send(*command)?;
        let (index, left) = (self.next, self.after(self.left(), command));
        self.given.push_back(Given { id, index, left });
        self.next += 1;
        Ok(())
    }

    /// All was given up to where the job comes to rest: for a person, or to be lifted.
    fn reach_limit(&mut self, arm: &mut Arm, may_lift: bool) -> Option<Wish> {
        if self.next < self.limit {
            return None;
        }
        match &self.phase {
            Phase::Running => self.wait_for_person(),
            Phase::Draining {
                then,
                reason,
                lift: true,
            } => {
                let (then, reason) = (*then, reason.clone());
                self.lift(arm, may_lift, then, reason);
                None
            }
            _ => None,
        }
    }

    fn wait_for_person(&mut self) -> Option<Wish> {
        let here = self.begun.next_pause().filter(|it| it.before == self.next);
        let message = here?.message.clone();
        let wish = self.drain(JobPhase::Paused, &message, false);
        self.waits = true;
        Some(wish)
    }

    /// The journal is asked in time, so that the arm does not wait for the disk.
    fn ask_journal(&mut self, status: Option<Status>) -> Option<Wish> {
        if self.asked > self.durable || self.durable >= self.next + LOW_WATER {
            return None;
        }
        let upto = self.window_end(&status?).min(self.limit);
        if upto <= self.asked {
            return None;
        }
        (self.asked, self.asked_kept) = (upto, self.begun.completed);
        Some(Wish::Ask(Effect::Give {
            job: self.job(),
            completed: self.begun.completed,
            upto,
            start: self.start(),
        }))
    }

    /// Where the job goes on is reached: the commands follow, up to where it waits for a person.
    fn set_out(&mut self, now: Duration) {
        self.phase = Phase::Running;
        (self.since, self.last_over) = (Some(now), now);
        let pause = self.begun.next_pause().map(|it| it.before);
        self.limit = pause.unwrap_or(self.begun.plan.len());
    }

    const fn is_approaching(&self) -> bool {
        matches!(self.phase, Phase::Approaching { .. })
    }

    /// Whether there are commands to be given.
    fn gives(&self) -> bool {
        match self.phase {
            Phase::Running => true,
            Phase::Draining { lift, .. } => lift || self.next < self.limit,
            _ => false,
        }
    }

    /// The command at this place of those given is over.
    fn over(&mut self, at: usize, now: Duration, is_done: bool) {
        let given = self.given.remove(at).expect("it was found there");
        self.last_over = now;
        if is_done && self.begun.completed == given.index {
            self.begun.completed = given.index + 1;
            self.left = given.left;
        }
    }
}

/// So many commands wait in the session, so that a permit finds one.
const KEEP_WAITING: usize = 2;
/// The journal is asked for more when so few are left.
const LOW_WATER: usize = 12;
