//! Keeping session and journal supplied with what the job needs next.

use std::time::Duration;

use dobot_client::CommandId;
use dobot_wire::Command;

use super::{Effect, Given, Phase, Run};
use crate::keeper::Keeper;
use crate::words::{JobPhase, Refusal};

impl Keeper {
    pub(in crate::keeper) fn run_command_forgotten(&mut self, id: CommandId) {
        let Some(run) = &mut self.run else {
            return;
        };
        if let Some(at) = run.given.iter().position(|it| it.id == id) {
            let index = run.given[at].index;
            run.given.truncate(at);
            run.next = run.next.min(index);
        }
        // The tool is still above.
        let lowering = run.lowering.take_if(|(it, _)| *it == id);
        run.lower = lowering.map(|(_, command)| command).or(run.lower);
    }

    /// Takes that a command is over: of the job, or on the way to it.
    pub(in crate::keeper) fn run_command_over(&mut self, id: CommandId, failed: Option<&str>) {
        let now = self.arm.now();
        let Some(run) = &mut self.run else {
            return;
        };
        let of_job = run.given.iter().position(|it| it.id == id);
        let of_way = match &run.phase {
            Phase::Approaching { last } => *last == Some(id),
            _ => run.lowering.is_some_and(|(it, _)| it == id),
        };
        if let Some(at) = of_job {
            run.over(at, now, failed.is_none());
        }
        match failed {
            Some(why) if of_job.is_some() || of_way || run.is_approaching() => {
                let why = why.to_owned();
                self.arm.part_from_laser();
                self.drop_waiting(&why);
                self.interrupt_run(&why);
            }
            None if of_way && run.is_approaching() => run.set_out(now),
            None if of_way => run.lowering = None,
            _ => {}
        }
    }

    /// Keeps the session and the journal supplied.
    pub(in crate::keeper) fn pump(&mut self) {
        let now = self.arm.now();
        let Some(run) = &mut self.run else {
            return;
        };
        if matches!(run.phase, Phase::Approaching { last: None }) {
            run.set_out(now);
        }
        if !run.gives() {
            return;
        }
        self.ask_journal();
        while self.arm.session().waiting() < KEEP_WAITING
            && let Some(command) = self.next_of_run()
        {
            if let Err(refusal) = self.lower_run().and_then(|()| self.give(&command)) {
                let why = refusal.to_string();
                self.arm.part_from_laser();
                self.drain(JobPhase::Paused, &why, true);
                break;
            }
        }
        self.reach_limit();
    }

    fn next_of_run(&mut self) -> Option<Command> {
        let run = self.run.as_mut()?;
        if run.next >= run.limit.min(run.durable) || run.unkept.is_some() {
            return None;
        }
        let speed_mm_s = run.speed_mm_s();
        run.pace.command(&run.begun.plan, run.next, speed_mm_s)
    }

    /// The tool goes down only when the job goes on right behind that: a pen that stands on the paper
    /// makes a blot.
    fn lower_run(&mut self) -> Result<(), Refusal> {
        let lower = self.run.as_mut().and_then(|it| it.lower.take());
        if let Some(command) = lower {
            self.arm.check_way(&command)?;
            let id = self.arm.session_mut().send(command)?;
            if let Some(run) = &mut self.run {
                run.lowering = Some((id, command));
            }
        }
        Ok(())
    }

    fn give(&mut self, command: &Command) -> Result<(), Refusal> {
        self.arm.check_way(command)?;
        let id = self.arm.session_mut().send(*command)?;
        let run = self.run.as_mut().expect("the command is of the run");
        let (index, left) = (run.next, run.after(run.left(), command));
        run.given.push_back(Given { id, index, left });
        run.next += 1;
        Ok(())
    }

    /// All was given up to where the job comes to rest: for a person, or to be lifted.
    fn reach_limit(&mut self) {
        let Some(run) = self.run.as_ref().filter(|it| it.next >= it.limit) else {
            return;
        };
        match &run.phase {
            Phase::Running => self.wait_for_person(),
            Phase::Draining {
                then,
                reason,
                lift: true,
            } => {
                let (then, reason) = (*then, reason.clone());
                self.lift_run(then, reason);
            }
            _ => {}
        }
    }

    fn wait_for_person(&mut self) {
        let Some(run) = &self.run else {
            return;
        };
        let here = run.begun.next_pause().filter(|it| it.before == run.next);
        if let Some(message) = here.map(|it| it.message.clone()) {
            self.drain(JobPhase::Paused, &message, false);
            if let Some(run) = &mut self.run {
                run.waits = true;
            }
        }
    }

    /// The journal is asked in time, so that the arm does not wait for the disk.
    fn ask_journal(&mut self) {
        let Some(run) = &mut self.run else {
            return;
        };
        if run.asked > run.durable || run.durable >= run.next + LOW_WATER {
            return;
        }
        let Some(upto) = self.arm.last().map(|status| run.window_end(&status)) else {
            return;
        };
        let upto = upto.min(run.limit);
        if upto > run.asked {
            (run.asked, run.asked_kept) = (upto, run.begun.completed);
            let effect = Effect::Give {
                job: run.job(),
                completed: run.begun.completed,
                upto,
                start: run.start(),
            };
            self.save.ask(effect);
        }
    }
}

impl Run {
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
