//! Operations on the job, requested by a person or caused by an event.

use std::time::Duration;

use dobot_api::{Answer, ClientId, JobPhase, JobView, News, Reply};
use dobot_journal::Window;
use dobot_session::CommandId;
use dobot_wire::Status;

use super::Supervisor;
use super::run::{DueAnswer, Run, StartedJob, check_height};
use crate::refusal::Refusal;

impl Supervisor {
    /// Starts a job or resumes a paused one.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has moved.
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

    /// Confirms that a person has done what the job waits for.
    pub(super) fn confirm_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        self.confirmed_job = Some(job);
        let name = self.client_name(client);
        let text = format!("{name} confirmed that job {job} may resume");
        self.notify(News::Message { client }, text);
        Ok(Reply::Done)
    }

    /// Returns the number of answers so far of a job that waits for another one.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`], [`Refusal::NoQuestion`] if it does not wait for one, or
    /// [`Refusal::AnsweredBefore`] if it asks another question than the one of this number.
    pub fn answers_of(&self, job: u64, question: Option<u64>) -> Result<usize, Refusal> {
        let run = self.run.as_ref().filter(|run| run.job() == job);
        let run = run.ok_or(Refusal::NoSuchJob(job))?;
        let answers = run.answers().ok_or(Refusal::NoQuestion(job))?;
        let asked = answers as u64 + 1;
        match question {
            Some(question) if question != asked => Err(Refusal::AnsweredBefore {
                job,
                question,
                asked,
            }),
            _ => Ok(answers),
        }
    }

    /// Returns what is due for a question that nobody has answered; call it with each status.
    pub fn poll_due_answer(&mut self) -> Option<(u64, Answer)> {
        match self.run.as_ref()?.due_answer(self.arm.now())? {
            DueAnswer::Answer { job, answer } => Some((job, answer)),
            DueAnswer::Pause(why) => {
                // There is a job at work, so this cannot be refused.
                let _ = self.pause_for(&why);
                None
            }
        }
    }

    /// Continues a job with the longer program that follows an answer. The journal has it already;
    /// a job that was paused meanwhile continues with it when it is resumed.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`] if it is not the current job any more.
    pub fn handle_answered(&mut self, now: Duration, longer: StartedJob) -> Result<Reply, Refusal> {
        self.handle_time(now);
        let job = longer.job;
        if self.run.as_ref().is_none_or(|run| run.job() != job) {
            return Err(Refusal::NoSuchJob(job));
        }
        self.with_run(|run, _| Some(run.extend(longer)));
        self.feed();
        Ok(self.job_reply())
    }

    /// Pauses the job, because the answer that is due does not continue it.
    pub fn handle_bad_answer(&mut self, now: Duration, why: &Refusal) {
        self.handle_time(now);
        // If there is no job at work, nothing has to be paused.
        let _ = self.pause_for(&why.to_string());
    }

    /// Restores a job that was running when the station ended unexpectedly: the laser goes off, and
    /// the position where the arm comes to rest shows how far the job got.
    pub fn handle_recovered(&mut self, now: Duration, started: StartedJob, window: Window) {
        self.handle_time(now);
        self.arm.session_mut().distrust(Run::RESTARTED);
        self.run = Some(Run::recovered(started, window));
        self.outgoing.note_change();
    }

    /// Checks that the last motion of a job is over, so that it may start: a job paused a moment
    /// ago still finishes its in-flight commands and lifts the tool; the progress of a job left by
    /// a killed station follows from where the arm comes to rest.
    ///
    /// # Errors
    ///
    /// [`Refusal::StillMoving`]; [`Refusal::NoLink`] if the arm cannot be seen at rest.
    pub fn check_rests(&self, job: u64) -> Result<(), Refusal> {
        let run = self.run.as_ref().filter(|run| run.job() == job);
        if run.is_some_and(Run::is_coming_to_rest) {
            self.link.check()?;
            return Err(self.still_moving());
        }
        Ok(())
    }

    /// Returns the running or paused job.
    #[must_use]
    pub fn job(&self) -> Option<JobView> {
        self.run.as_ref().map(Run::view)
    }

    /// Returns that job's number of completed commands, counted over all cycles, and its phase.
    #[must_use]
    pub fn job_progress(&self) -> Option<(usize, JobPhase)> {
        self.run.as_ref().map(Run::progress)
    }

    /// Returns the tool height below which a pen draws now, in millimetres and raw coordinates;
    /// `None` if no job lifts a pen.
    #[must_use]
    pub fn pen_draws_below_mm(&self) -> Option<f64> {
        self.run.as_ref()?.draws_below_mm()
    }

    /// Returns whether a job is executing its commands, as opposed to approaching its start.
    #[must_use]
    pub fn is_executing_job(&self) -> bool {
        self.run.as_ref().is_some_and(Run::is_running)
    }

    fn job_reply(&self) -> Reply {
        self.job().map_or(Reply::Done, |job| Reply::Job { job })
    }

    pub(super) fn pause_job(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        let why = format!("paused by {}", self.client_name(client));
        self.pause_for(&why)
    }

    /// Pauses the running job, if any, for this reason.
    pub(super) fn pause_for(&mut self, why: &str) -> Result<Reply, Refusal> {
        let Some(run) = self.run.as_ref().filter(|run| run.occupies_arm()) else {
            return Err(Refusal::NoJobRuns);
        };
        let at_work = run.is_at_work();
        self.send_laser_off_if_burning();
        // A job that is coming to rest need not be interrupted or lifted again.
        if at_work {
            self.come_to_rest(JobPhase::Paused, why);
        }
        Ok(self.job_reply())
    }

    pub(super) fn cancel_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        if self.leases.is_taken() {
            self.leases.check(client)?;
        }
        let Some(run) = self.run.as_ref().filter(|run| run.job() == job) else {
            return Err(Refusal::NoSuchJob(job));
        };
        let at_work = run.is_at_work();
        let why = format!("ended by {}", self.client_name(client));
        self.send_laser_off_if_burning();
        if at_work {
            self.come_to_rest(JobPhase::Stopped, &why);
        } else {
            self.with_run(|run, _| run.end(&why));
        }
        let reply = self.job_reply();
        self.with_run(Run::handle_status);
        Ok(reply)
    }

    /// Returns the refusal to remove the current job.
    pub(super) fn refuse_removal(&self, job: u64) -> Refusal {
        let found = self.job().filter(|view| view.job == job);
        found.map_or(Refusal::NoSuchJob(job), |view| Refusal::JobPhase {
            job,
            found: view.phase,
            allowed: FORGETTABLE,
        })
    }

    /// Changes the speed of the vectors not sent yet.
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

    /// Changes the height of the commands not sent yet: gradually while the job runs, immediately
    /// while it is paused, because then the tool comes from above.
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

    /// Checks that there is a job whose vectors can be changed now.
    fn check_adjustable(&self) -> Result<(), Refusal> {
        let run = self.run.as_ref().ok_or(Refusal::NoJobRuns)?;
        if run.is_coming_to_rest() {
            return Err(self.still_moving());
        }
        run.check_adjustable()
    }

    /// Takes unsent commands back, to send them again.
    fn take_back(&mut self) {
        if self.run.as_ref().is_some_and(Run::is_running) {
            self.drop_waiting("it is sent again at another speed or height");
        }
    }

    /// Switches the laser off immediately if it may be on. An arm that draws with a pen gets the
    /// packet at rest: in the middle of a stroke it would stop the arm for a moment.
    fn send_laser_off_if_burning(&mut self) {
        if self.arm.laser_view().on || self.run.as_ref().is_none_or(Run::burns) {
            self.arm.send_laser_off();
        }
    }

    /// Ends the motion of the job: it comes to rest along its path, and the tool is lifted.
    fn come_to_rest(&mut self, then: JobPhase, why: &str) {
        self.drop_waiting(why);
        self.with_run(|run, _| Some(run.come_to_rest(then, why)));
        self.feed();
    }

    /// Interrupts the job: the in-flight commands finish, then it is paused.
    pub(super) fn interrupt_run(&mut self, why: &str) {
        self.with_run(|run, _| run.interrupt(why));
    }

    /// Interrupts a burning job.
    pub(super) fn interrupt_burning(&mut self, why: &str) {
        let burns = |run: &Run| run.burns() && run.is_at_work();
        if self.run.as_ref().is_some_and(burns) {
            self.drop_waiting(why);
            self.with_run(|run, _| Some(run.interrupt_burning(why)));
        }
    }

    /// Handles a finished command of the job or its approach.
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

    /// Handles a failure of the job: waiting commands are dropped, and it retries or is paused.
    fn fail_run(&mut self, why: &str) {
        self.arm.send_laser_off();
        self.drop_waiting(why);
        self.with_run(|run, _| run.fail(why));
    }

    /// Checks with each status whether the awaited grip is visible.
    pub(super) fn check_grip(&mut self, status: &Status) {
        let now = self.arm.now();
        let lost = self
            .run
            .as_mut()
            .and_then(|run| run.check_grip(now, status));
        if let Some(why) = lost {
            self.fail_run(&why);
        }
    }

    /// Sends lost commands again.
    pub(super) fn resend_lost(&mut self) {
        let Some(run) = self.run.take() else {
            return;
        };
        match run.resend_lost(&mut self.arm) {
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
