//! Keeping session and journal supplied with what the job needs next.

use dobot_client::CommandId;
use dobot_wire::Command;

use super::{Effect, Phase, Run};
use crate::keeper::Keeper;
use crate::words::{JobPhase, Refusal};

impl Keeper {
    pub(in crate::keeper) fn run_command_forgotten(&mut self, id: CommandId) {
        if let Some(run) = &mut self.run
            && let Some(at) = run.given.iter().position(|(it, _)| *it == id)
        {
            let (_, index) = run.given[at];
            run.given.truncate(at);
            run.next = run.next.min(index);
        }
    }

    /// Takes that a command is over: of the job, or on the way to it.
    pub(in crate::keeper) fn run_command_over(&mut self, id: CommandId, failed: Option<&str>) {
        let Some(run) = &mut self.run else {
            return;
        };
        let of_job = run.given.iter().position(|(it, _)| *it == id);
        let of_way = match &run.phase {
            Phase::Approaching { last } => *last == Some(id),
            Phase::Lifting { last, .. } => *last == id,
            _ => false,
        };
        if let Some(at) = of_job {
            let (_, index) = run.given.remove(at).expect("it was found there");
            if failed.is_none() && run.begun.completed == index {
                run.begun.completed = index + 1;
            }
        }
        match failed {
            Some(why) if of_job.is_some() || matches!(run.phase, Phase::Approaching { .. }) => {
                let why = why.to_owned();
                self.part_from_laser();
                self.drop_waiting(&why);
                self.interrupt_run(&why);
            }
            None if of_way && matches!(run.phase, Phase::Approaching { .. }) => {
                run.phase = Phase::Running;
            }
            _ => {}
        }
    }

    /// Keeps the session and the journal supplied.
    pub(in crate::keeper) fn pump(&mut self) {
        if !matches!(
            self.run,
            Some(Run {
                phase: Phase::Approaching { last: None } | Phase::Running,
                ..
            })
        ) {
            return;
        }
        if let Some(Run {
            phase: phase @ Phase::Approaching { .. },
            ..
        }) = &mut self.run
        {
            *phase = Phase::Running;
        }
        self.ask_journal();
        while self.session.waiting() < KEEP_WAITING
            && let Some(command) = self.next_of_run()
        {
            if let Err(refusal) = self.give(&command) {
                let why = refusal.to_string();
                self.part_from_laser();
                self.drain(JobPhase::Paused, &why, true);
                return;
            }
        }
    }

    fn next_of_run(&self) -> Option<Command> {
        let run = self.run.as_ref()?;
        let commands = &run.begun.plan.commands()[..run.durable];
        commands.get(run.next).copied()
    }

    fn give(&mut self, command: &Command) -> Result<(), Refusal> {
        self.check_laser(command)?;
        self.check_way(command)?;
        let id = self.session.send(*command)?;
        self.note_laser(command);
        let run = self.run.as_mut().expect("the command is of the run");
        run.given.push_back((id, run.next));
        run.next += 1;
        Ok(())
    }

    /// The journal is asked in time, so that the arm does not wait for the disk.
    fn ask_journal(&mut self) {
        let Some(run) = &mut self.run else {
            return;
        };
        if run.asked > run.durable || run.durable >= run.next + LOW_WATER {
            return;
        }
        let Some(upto) = self.last.map(|status| run.window_end(&status)) else {
            return;
        };
        if upto > run.asked {
            run.asked = upto;
            let effect = Effect::Give {
                job: run.job(),
                completed: run.begun.completed,
                upto,
                start: run.start(),
            };
            self.effects.push_back(effect);
        }
    }
}

/// So many commands wait in the session, so that a permit finds one.
const KEEP_WAITING: usize = 2;
/// The journal is asked for more when so few are left.
const LOW_WATER: usize = 12;
