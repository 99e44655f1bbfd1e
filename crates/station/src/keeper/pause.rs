//! A job that goes no further: by a person, by trouble, for good or for a while.

use super::Keeper;
use super::run::{Effect, Phase, Run, straight, word};
use crate::words::{ClientId, JobPhase, JobView, News, Refusal, Reply};

impl Keeper {
    pub(super) fn pause_job(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        let why = format!("paused by {}", self.name(client));
        let Some(run) = self.run.as_ref().filter(|it| it.has_the_arm()) else {
            return Err(Refusal::NoJobRuns);
        };
        let at_work = run.is_at_work();
        self.part_from_burning();
        // One that is coming to rest already need not be told again, nor lifted twice.
        if at_work {
            self.come_to_rest(JobPhase::Paused, &why);
        }
        Ok(self.job_reply())
    }

    pub(super) fn cancel_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        if self.leases.is_taken() {
            self.leases.check(client)?;
        }
        if self.run.as_ref().is_none_or(|it| it.job() != job) {
            return Err(Refusal::NoSuchJob(job));
        }
        let why = format!("ended by {}", self.name(client));
        self.part_from_burning();
        self.end_run(&why);
        let reply = self.job_reply();
        self.watch_run();
        Ok(reply)
    }

    /// Ends the job, with what its phase needs for that.
    fn end_run(&mut self, why: &str) {
        let Some(run) = &mut self.run else {
            return;
        };
        match &mut run.phase {
            Phase::Running | Phase::Approaching { .. } => {
                self.come_to_rest(JobPhase::Stopped, why);
            }
            // Nothing moves for its sake: how far the job got, nobody needs to know any more.
            Phase::Paused { .. } | Phase::Locating { .. } => {
                self.drain(JobPhase::Stopped, why, false);
            }
            Phase::Draining { then, reason, .. } | Phase::Lifting { then, reason, .. } => {
                *then = JobPhase::Stopped;
                why.clone_into(reason);
                self.tell_phase(JobPhase::Stopped, why);
            }
        }
    }

    /// Laser off, at once, where it may be on. An arm that draws with a pen hears it when it rests:
    /// the packet would come in the middle of a stroke, and stop it for a moment.
    fn part_from_burning(&mut self) {
        if self.arm.laser_view().on || self.run.as_ref().is_none_or(Run::burns) {
            self.arm.part_from_laser();
        }
    }

    /// The job goes no further: it comes to rest on its way, and the tool is lifted.
    fn come_to_rest(&mut self, then: JobPhase, why: &str) {
        self.drop_waiting(why);
        let lift = self.run.as_ref().is_some_and(Run::is_down);
        self.drain(then, why, lift);
        if let Some(run) = &mut self.run {
            run.brake();
        }
        self.pump();
    }

    /// The job goes no further: what is under way comes to its end, then it is paused.
    pub(super) fn interrupt_run(&mut self, why: &str) {
        if self.run.as_ref().is_some_and(Run::is_at_work) {
            self.drain(JobPhase::Paused, why, false);
        } else if let Some(run) = &mut self.run {
            let cut_short = run.is_cut_short();
            run.end_here();
            if let Phase::Draining { lift, reason, .. } = &mut run.phase {
                *lift = false;
                if cut_short {
                    why.clone_into(reason);
                }
            }
        }
    }

    /// A job that burns goes no further.
    pub(super) fn interrupt_burning(&mut self, why: &str) {
        if self
            .run
            .as_ref()
            .is_some_and(|it| it.burns() && it.is_at_work())
        {
            self.drop_waiting(why);
            self.drain(JobPhase::Paused, why, true);
        }
    }

    pub(super) fn drain(&mut self, then: JobPhase, reason: &str, lift: bool) {
        let Some(run) = &mut self.run else {
            return;
        };
        run.end_here();
        run.phase = Phase::Draining {
            then,
            reason: reason.to_owned(),
            lift,
        };
        // The journal keeps it as running until nothing is under way: a crash until then has to find
        // out how far the job got.
        self.tell_phase(then, reason);
    }

    /// All was given that the job does before it rests: the tool is lifted right behind that, so that
    /// no pen stands on the paper.
    pub(super) fn lift_run(&mut self, then: JobPhase, reason: String) {
        let up = self.run.as_ref().map_or(0.0, Run::lift_mm);
        let command = straight(up.into());
        let wanted = up > 0.0 && !self.stop.holds() && self.link.is_there();
        let lifts = wanted
            && self.arm.check_way(&command).is_ok()
            && self.arm.session_mut().send(command).is_ok();
        let Some(run) = &mut self.run else {
            return;
        };
        run.phase = if lifts {
            Phase::Lifting { then, reason }
        } else {
            let lift = false;
            Phase::Draining { then, reason, lift }
        };
    }

    /// Nothing of the job is under way any more: how far it got is certain, and kept.
    pub(super) fn rest_run(&mut self, then: JobPhase, reason: String) {
        let Some(run) = &mut self.run else {
            return;
        };
        let window = run.rest(&reason);
        let effect = Effect::Phase {
            job: run.job(),
            phase: then,
            reason: Some(reason),
            window,
            behind: run.behind(),
        };
        self.save.keep_phase(effect);
        if then.is_over() {
            self.run = None;
        }
        self.arm.part_from_laser();
        self.outbox.note_change();
    }

    pub(super) fn tell_job_paused(&mut self) {
        if let Some(JobView { phase, reason, .. }) = self.job() {
            self.tell_phase(phase, &reason.unwrap_or_default());
        }
    }

    fn tell_phase(&mut self, phase: JobPhase, reason: &str) {
        if let Some(job) = self.run.as_ref().map(Run::job) {
            let text = format!("job {job} is {}: {reason}", word(phase));
            self.tell(News::Job { job, phase }, text);
        }
    }
}
