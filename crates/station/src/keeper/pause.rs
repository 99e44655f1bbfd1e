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
        self.part_from_laser();
        // One that is coming to rest already need not be told again, nor lifted twice.
        if at_work {
            self.drop_waiting(&why);
            self.drain(JobPhase::Paused, &why, true);
        }
        Ok(self.job_reply())
    }

    pub(super) fn cancel_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        if self.lease.is_some() {
            self.check_lease(client)?;
        }
        if self.run.as_ref().is_none_or(|it| it.job() != job) {
            return Err(Refusal::NoSuchJob(job));
        }
        let why = format!("ended by {}", self.name(client));
        self.part_from_laser();
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
                self.drop_waiting(why);
                self.drain(JobPhase::Stopped, why, true);
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

    /// The job goes no further: what is under way comes to its end, then it is paused.
    pub(super) fn interrupt_run(&mut self, why: &str) {
        if self.run.as_ref().is_some_and(Run::is_at_work) {
            self.drain(JobPhase::Paused, why, false);
        } else if let Some(run) = &mut self.run
            && let Phase::Draining { lift, .. } = &mut run.phase
        {
            *lift = false;
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
        run.phase = Phase::Draining {
            then,
            reason: reason.to_owned(),
            lift,
        };
        // The journal keeps it as running until nothing is under way: a crash until then has to find
        // out how far the job got.
        self.tell_phase(then, reason);
    }

    pub(super) fn drained(&mut self, then: JobPhase, reason: String, lift: bool) {
        let up = self.run.as_ref().map_or(0.0, Run::lift_mm);
        if lift && up > 0.0 && self.stop.is_none() && self.is_linked() {
            let command = straight(up.into());
            if self.check_way(&command).is_ok()
                && let Ok(last) = self.session.send(command)
                && let Some(run) = &mut self.run
            {
                run.phase = Phase::Lifting { last, then, reason };
                return;
            }
        }
        self.rest_run(then, reason);
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
        };
        self.keep_phase(effect);
        if then.is_over() {
            self.run = None;
        }
        self.changed = true;
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
