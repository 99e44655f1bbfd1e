//! What the supervisor has the job do, for a person or because something happened.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, JobView, News, Reply};
use dobot_journal::Window;
use dobot_session::CommandId;
use dobot_wire::Status;

use super::Supervisor;
use super::run::{Run, StartedJob, check_height};
use crate::refusal::Refusal;

impl Supervisor {
    /// Begins a job, or goes on with a paused one.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has moved then.
    pub fn handle_start(
        &mut self,
        now: Duration,
        client: ClientId,
        started: StartedJob,
    ) -> Result<Reply, Refusal> {
        self.handle_time(now);
        let reply = self.start(client, started);
        if let Err(refusal) = &reply {
            self.notify_refused(client, refusal);
        }
        self.feed();
        reply
    }

    fn start(&mut self, client: ClientId, started: StartedJob) -> Result<Reply, Refusal> {
        self.check_may_move(client)?;
        self.arm.check_trust()?;
        self.journal_requests.check()?;
        if !self.arm.is_idle() {
            return Err(self.still_moving());
        }
        if started.plan.burns() {
            self.arm.check_laser_armed()?;
        }
        if let Some(message) = started.waits_for_person()
            && self.confirmed_job != Some(started.job)
        {
            return Err(Refusal::NeedsPerson {
                job: started.job,
                message: message.to_owned(),
            });
        }
        let (run, effects) = Run::begin(started, &mut self.arm, self.run.as_ref())?;
        self.stop_sequence.forget();
        self.run = Some(run);
        self.confirmed_job = None;
        self.apply_effects(effects);
        Ok(self.job_reply())
    }

    /// A person has done what the job waits for.
    pub(super) fn confirm_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        self.confirmed_job = Some(job);
        let name = self.client_name(client);
        let text = format!("{name} confirmed that job {job} may go on");
        self.notify(News::Message { client }, text);
        Ok(Reply::Done)
    }

    /// Takes a job that was at work when the station ended without saying so: the laser goes off,
    /// and where the arm comes to rest tells how far the job got.
    pub fn handle_recovered(&mut self, now: Duration, started: StartedJob, window: Window) {
        self.handle_time(now);
        self.arm.session_mut().distrust(Run::RESTARTED);
        self.run = Some(Run::recovered(started, window));
        self.outgoing.note_change();
    }

    /// Whether a job may be started as far as its own last motion goes: one that was paused a
    /// moment ago still does what the arm has got, and lifts the tool; one that a killed station left
    /// shows how far it got where the arm comes to rest.
    ///
    /// # Errors
    ///
    /// [`Refusal::StillMoving`]; [`Refusal::NoLink`] where nothing tells that the arm rests.
    pub fn check_rests(&self, job: u64) -> Result<(), Refusal> {
        let run = self.run.as_ref().filter(|it| it.job() == job);
        if run.is_some_and(Run::is_coming_to_rest) {
            self.link.check()?;
            return Err(self.still_moving());
        }
        Ok(())
    }

    /// The job that is at work or paused.
    #[must_use]
    pub fn job(&self) -> Option<JobView> {
        self.run.as_ref().map(Run::view)
    }

    /// How many commands of that job are over, counted over all cycles, and how far it is.
    #[must_use]
    pub fn job_progress(&self) -> Option<(usize, JobPhase)> {
        self.run.as_ref().map(Run::progress)
    }

    /// Below which height of the tool a pen draws now, in millimetres and the arm's own words; `None` where no job lifts
    /// one.
    #[must_use]
    pub fn pen_draws_below_mm(&self) -> Option<f64> {
        self.run.as_ref()?.draws_below_mm()
    }

    /// Whether a job is at its commands, and not on the way to where it goes on.
    #[must_use]
    pub fn has_active_job(&self) -> bool {
        self.run.as_ref().is_some_and(Run::is_running)
    }

    fn job_reply(&self) -> Reply {
        self.job().map_or(Reply::Done, |job| Reply::Job { job })
    }

    pub(super) fn pause_job(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        let why = format!("paused by {}", self.client_name(client));
        self.pause_for(&why)
    }

    /// Pauses the job that runs, if one does, with why for those who find it so.
    pub(super) fn pause_for(&mut self, why: &str) -> Result<Reply, Refusal> {
        let Some(run) = self.run.as_ref().filter(|it| it.has_the_arm()) else {
            return Err(Refusal::NoJobRuns);
        };
        let at_work = run.is_at_work();
        self.part_from_burning();
        // One that is coming to rest already need not be told again, nor lifted twice.
        if at_work {
            self.come_to_rest(JobPhase::Paused, why);
        }
        Ok(self.job_reply())
    }

    pub(super) fn cancel_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        if self.leases.is_taken() {
            self.leases.check(client)?;
        }
        let Some(run) = self.run.as_ref().filter(|it| it.job() == job) else {
            return Err(Refusal::NoSuchJob(job));
        };
        let at_work = run.is_at_work();
        let why = format!("ended by {}", self.client_name(client));
        self.part_from_burning();
        if at_work {
            self.come_to_rest(JobPhase::Stopped, &why);
        } else {
            self.with_run(|run, _| run.end(&why));
        }
        let reply = self.job_reply();
        self.with_run(Run::handle_status);
        Ok(reply)
    }

    /// Why the job that the arm is at is not forgotten.
    pub(super) fn not_forgotten(&self, job: u64) -> Refusal {
        let found = self.job().filter(|it| it.job == job);
        found.map_or(Refusal::NoSuchJob(job), |it| Refusal::JobPhase {
            job,
            found: it.phase,
            allowed: FORGETTABLE,
        })
    }

    /// Draws the vectors that are not sent yet at another speed.
    pub(super) fn set_job_speed(
        &mut self,
        client: ClientId,
        percent: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        self.check_adjustable()?;
        if let Some(run) = &self.run {
            run.check_speed(percent)?;
        }
        self.take_back();
        self.with_run(|run, _| Some(run.set_speed(percent)));
        Ok(self.job_reply())
    }

    /// Draws what is not sent yet higher or lower: bit by bit while it runs, at once where it is
    /// paused, for there the tool comes from above.
    pub(super) fn set_job_height(
        &mut self,
        client: ClientId,
        offset_mm: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        check_height(offset_mm)?;
        self.check_adjustable()?;
        self.take_back();
        if let Some(run) = &mut self.run {
            let effect = run.set_height(offset_mm, self.arm.policy())?;
            self.apply_effects([effect]);
        }
        Ok(self.job_reply())
    }

    /// Whether there is a job whose vectors can be changed now.
    fn check_adjustable(&self) -> Result<(), Refusal> {
        let run = self.run.as_ref().ok_or(Refusal::NoJobRuns)?;
        if run.is_coming_to_rest() {
            return Err(self.still_moving());
        }
        run.check_adjustable()
    }

    /// What was given and not sent is given again.
    fn take_back(&mut self) {
        if self.run.as_ref().is_some_and(Run::is_running) {
            self.drop_waiting("it is sent at another speed or height");
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
        self.with_run(|run, _| Some(run.come_to_rest(then, why)));
        self.feed();
    }

    /// The job goes no further: what is under way comes to its end, then it is paused.
    pub(super) fn interrupt_run(&mut self, why: &str) {
        self.with_run(|run, _| run.interrupt(why));
    }

    /// A job that burns goes no further.
    pub(super) fn interrupt_burning(&mut self, why: &str) {
        let burns = |it: &Run| it.burns() && it.is_at_work();
        if self.run.as_ref().is_some_and(burns) {
            self.drop_waiting(why);
            self.with_run(|run, _| Some(run.interrupt_burning(why)));
        }
    }

    /// Takes that a command is over: of the job, or on the way to it.
    pub(super) fn run_command_over(&mut self, id: CommandId, failed: Option<&str>) {
        let now = self.arm.now();
        let Some(run) = &mut self.run else {
            return;
        };
        let (is_done, status) = (failed.is_none(), self.arm.last());
        if run.handle_over(id, now, is_done, status.as_ref())
            && let Some(why) = failed
        {
            self.fail_run(why);
        }
    }

    /// The job has failed to do something: what waits is not sent, and it tries again or is paused.
    fn fail_run(&mut self, why: &str) {
        self.arm.part_from_laser();
        self.drop_waiting(why);
        self.with_run(|run, _| run.fail(why));
    }

    /// With each status: is the grip seen that was waited for?
    pub(super) fn judge_grip(&mut self, status: &Status) {
        let now = self.arm.now();
        let lost = self.run.as_mut().and_then(|it| it.judge_grip(now, status));
        if let Some(why) = lost {
            self.fail_run(&why);
        }
    }

    /// What was lost on the way is sent again.
    pub(super) fn try_again(&mut self) {
        let Some(run) = self.run.take() else {
            return;
        };
        match run.try_again(&mut self.arm) {
            Ok((run, effects)) => {
                self.run = Some(run);
                self.apply_effects(effects);
            }
            Err(refusal) => {
                self.run = Some(run);
                let why = refusal.to_string();
                self.with_run(|run, _| Some(run.give_up(&why)));
            }
        }
    }
}

/// The phases in which a job can be removed.
pub const FORGETTABLE: &str = "queued, stopped, done or failed";
