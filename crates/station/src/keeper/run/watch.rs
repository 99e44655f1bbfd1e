//! What the statuses tell of a job: how far it got, and whether it ends where it should.

use dobot_client::position;
use dobot_course::Model;
use dobot_journal::{Unclear, Window, locate, model_at};
use dobot_wire::{Command, Status};

use super::approach::THERE_MM;
use super::{Begun, Effect, Phase, RESTARTED, Run, word};
use crate::keeper::Keeper;
use crate::words::{JobPhase, News};

impl Run {
    /// So many statuses in a row that tell the same: nothing of a window is under way any more, not
    /// even a pause.
    fn rests_after(&self, window: &Window) -> u32 {
        let commands = self.begun.plan.commands();
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

    /// What is wrong with the place where the arm rests when all is over. A vector leads from
    /// wherever the arm is: where one was lost, all behind it are displaced.
    fn misses_end(&self, status: &Status) -> Option<String> {
        let end = self.begun.plan.start_position(self.begun.plan.len())?;
        let off_mm = end.distance(position(status)).0;
        (off_mm > THERE_MM).then(|| {
            format!(
                "the arm rests {off_mm:.2} mm from where the job ends: a command was lost on its way, and what came behind it is displaced"
            )
        })
    }

    /// How long it took, and how far the plan was off, in words.
    fn took(&self) -> String {
        let Some(ran_s) = self.begun.behind.ran_s else {
            return String::new();
        };
        let planned_s = self.begun.plan.planned_s();
        format!(", in {ran_s:.1} s, planned were {planned_s:.1} s")
    }
}

impl Keeper {
    /// With each status: is the job located, drained, lifted, done?
    pub(in crate::keeper) fn watch_run(&mut self) {
        let Some(run) = &self.run else {
            return;
        };
        let idle = self.arm.is_idle();
        match &run.phase {
            Phase::Locating { window } if self.arm.still() >= run.rests_after(window) => {
                let window = *window;
                self.locate_run(&window);
            }
            Phase::Draining { then, reason, .. }
                if idle && run.given.is_empty() && run.next >= run.limit =>
            {
                let (then, reason) = (*then, reason.clone());
                self.rest_run(then, reason);
            }
            // The session may be done with commands of which it has not told yet: how far the job is,
            // only what was told says.
            Phase::Lifting { then, reason } if idle && run.given.is_empty() => {
                let (then, reason) = (*then, reason.clone());
                self.rest_run(then, reason);
            }
            Phase::Running if run.begun.completed == run.begun.plan.len() && self.is_at_rest() => {
                self.run_over();
            }
            _ => {}
        }
    }

    /// All of the job was seen to be over, and the arm rests: where the job ends?
    fn run_over(&mut self) {
        let Some(mut run) = self.run.take() else {
            return;
        };
        self.arm.part_from_laser();
        run.note_ran();
        let (job, title) = (run.job(), &run.begun.title);
        let (phase, reason) = match self.arm.last().and_then(|status| run.misses_end(&status)) {
            None => (JobPhase::Done, None),
            Some(reason) => (JobPhase::Failed, Some(reason)),
        };
        let why = reason
            .as_ref()
            .map_or_else(|| run.took(), |it| format!(": {it}"));
        let text = format!("job {job} ({title}) is {}{why}", word(phase));
        self.save.keep_phase(Effect::Phase {
            job,
            phase,
            reason,
            window: Some(run.certain()),
            behind: run.begun.behind,
        });
        self.tell(News::Job { job, phase }, text);
    }

    /// The arm rests: which command was the last one that it did?
    fn locate_run(&mut self, window: &Window) {
        let (Some(run), Some(status)) = (&mut self.run, self.arm.last()) else {
            return;
        };
        let located = locate_at(&run.begun, window, &status);
        let reason = match located {
            Ok(next) => {
                run.begun.completed = next;
                format!("{RESTARTED}; the arm rests where command {next} begins")
            }
            Err(unclear) => {
                run.begun.doubt = Some(*window);
                format!("{RESTARTED}; {unclear}")
            }
        };
        self.rest_run(JobPhase::Paused, reason);
        self.tell_job_paused();
    }
}

/// Which command is the first that was not done, by where the arm rests.
pub(super) fn locate_at(begun: &Begun, window: &Window, status: &Status) -> Result<usize, Unclear> {
    if window.completed == window.upto {
        return Ok(window.completed);
    }
    let (commands, dialect) = (begun.plan.commands(), begun.dialect);
    let model = model_at(dialect, commands, window).unwrap_or_else(|| Model::new(dialect, status));
    let lift_mm = begun.plan.lift();
    locate(commands, window, &model, lift_mm, position(status)).map(|it| it.next)
}

const fn pause_s(command: &Command) -> f32 {
    match command {
        Command::MoveTo(it) => it.pause_s,
        Command::MoveJoints(it) => it.pause_s,
        _ => 0.0,
    }
}

/// So many statuses in a row that tell the same: whatever was under way is over.
const SURELY_AT_REST: u32 = 20;
const STATUSES_PER_S: f32 = 12.5;
const A_DAY_S: f32 = 86_400.0;
