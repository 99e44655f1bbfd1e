//! The requests of clients: those about jobs that do not run, and starts that wait until a job has come
//! to rest. The supervisor handles all others.

use std::time::Duration;

use dobot_api::{Answer, ClientId, Reply, Request};
use dobot_motion::Model;
use dobot_supervisor::{Refusal, StartedJob};
use tokio::sync::oneshot;

use super::{Driver, now_ms};
use crate::jobs::{GivenAnswer, JobStart};

/// A start that waits until its job has come to rest.
#[derive(Debug)]
pub(super) struct DeferredStart {
    start: JobStart,
    until: Duration,
}

impl Driver {
    pub(super) fn ask(
        &mut self,
        client: ClientId,
        request: Request,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        let now = self.now();
        self.withdraw_start(&request);
        if let Request::Calibrate { calibration } = request {
            let changed = self.calibrate(now, client, calibration.map(|calibration| *calibration));
            let changed = changed.map(|changed| Reply::Calibrated {
                calibrations: Box::new(changed),
            });
            return drop(reply.send(changed));
        }
        if let Some((request, reply)) = self.ask_jobs(client, request, reply) {
            self.ask_supervisor(now, client, request, reply);
        }
    }

    fn ask_supervisor(
        &mut self,
        now: Duration,
        client: ClientId,
        request: Request,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        let sets_slots = matches!(request, Request::SetSlots { .. });
        let answer = self.supervisor.handle_request(now, client, request);
        self.send();
        if sets_slots && matches!(answer, Some(Ok(_))) {
            self.save_slots();
        }
        match answer {
            // The requester may have left.
            Some(answer) => drop(reply.send(answer)),
            None => drop(self.waiting.insert(client, reply)),
        }
    }

    /// Handles requests about jobs other than the current one; returns all others.
    fn ask_jobs(
        &mut self,
        client: ClientId,
        request: Request,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) -> Option<(Request, oneshot::Sender<Result<Reply, Refusal>>)> {
        if self.supervisor.check_request(client, &request).is_err() {
            return Some((request, reply));
        }
        if matches!(request, Request::MarkEpisode { .. })
            && let Some(why) = self.recording.missing()
        {
            drop(reply.send(Err(Refusal::NotRecorded(why))));
            return None;
        }
        let jobs = self.jobs.clone();
        match request {
            Request::SubmitJob { job, key } => match self.supervisor.planning_model() {
                Ok(model) => jobs.submit(job, key, model, now_ms(), reply),
                Err(refusal) => drop(reply.send(Err(refusal))),
            },
            Request::QueueAgain { job, key } => match self.supervisor.planning_model() {
                Ok(model) => jobs.queue_again(job, key, model, now_ms(), reply),
                Err(refusal) => drop(reply.send(Err(refusal))),
            },
            Request::MoveJob { job, before } => jobs.move_before(job, before, reply),
            Request::ForgetJob { job } if !self.is_at(job) => jobs.forget(job, reply),
            Request::StartJob { job } | Request::StepJob { job } => {
                let until = self.now() + HOLD_START;
                let start = JobStart {
                    client,
                    job,
                    single_step: matches!(request, Request::StepJob { .. }),
                    reply,
                };
                self.start_job(DeferredStart { start, until });
            }
            Request::AnswerJob {
                job,
                question,
                answer,
            } => self.answer_question(job, question, answer, Some(reply)),
            Request::CancelJob { job } if !self.is_at(job) => {
                jobs.cancel(job, self.supervisor.client_name(client), reply);
            }
            request => return Some((request, reply)),
        }
        None
    }

    /// Continues the program that waits for an answer.
    fn answer_question(
        &mut self,
        job: u64,
        question: Option<u64>,
        answer: Answer,
        reply: Option<oneshot::Sender<Result<Reply, Refusal>>>,
    ) {
        match self.check_answerable(job, question) {
            Err(refusal) => match reply {
                Some(reply) => drop(reply.send(Err(refusal))),
                None => self.supervisor.handle_bad_answer(self.now(), &refusal),
            },
            Ok((before, model)) => {
                self.is_answering = true;
                self.write_journal();
                let given = GivenAnswer {
                    job,
                    before,
                    answer,
                };
                let own = self.own.clone();
                self.jobs.clone().answer_question(given, model, reply, own);
            }
        }
    }

    /// Returns the number of answers before, and the model for planning, if the program waits for an
    /// answer to this question.
    fn check_answerable(&self, job: u64, question: Option<u64>) -> Result<(usize, Model), Refusal> {
        let before = self.supervisor.answers_of(job, question)?;
        if self.is_answering {
            return Err(Refusal::NoQuestion(job));
        }
        Ok((before, self.supervisor.planning_model()?))
    }

    /// Handles the longer program that follows an answer, or why there is none.
    pub(super) fn handle_answered(
        &mut self,
        now: Duration,
        longer: Result<Box<StartedJob>, Refusal>,
        reply: Option<oneshot::Sender<Result<Reply, Refusal>>>,
    ) {
        self.is_answering = false;
        let answer = longer.and_then(|longer| self.supervisor.handle_answered(now, *longer));
        match (reply, answer) {
            // The requester may have left.
            (Some(reply), answer) => drop(reply.send(answer)),
            (None, Err(refusal)) => self.supervisor.handle_bad_answer(now, &refusal),
            (None, Ok(_)) => {}
        }
    }

    /// Gives the answer that is due without a person.
    pub(super) fn give_due_answer(&mut self) {
        if self.is_answering {
            return;
        }
        if let Some((job, answer)) = self.supervisor.poll_due_answer() {
            self.answer_question(job, None, answer, None);
        }
    }

    /// Returns whether this is the current job.
    fn is_at(&self, job: u64) -> bool {
        self.supervisor.job().is_some_and(|view| view.job == job)
    }

    /// Starts a job, or defers that while the job comes to rest.
    fn start_job(&mut self, held: DeferredStart) {
        match self.startable(held.start.job) {
            Err(Refusal::StillMoving { .. })
                if self.now() < held.until && self.held_start.is_none() =>
            {
                self.held_start = Some(held);
            }
            Err(refusal) => drop(held.start.reply.send(Err(refusal))),
            Ok(model) => {
                let own = self.own.clone();
                // The journal must know that the job is paused, which may have just happened.
                self.write_journal();
                self.jobs.clone().plan(held.start, model, own);
            }
        }
    }

    pub(super) fn try_held_start(&mut self) {
        // The requester may have left.
        if let Some(held) = self
            .held_start
            .take()
            .filter(|held| !held.start.reply.is_closed())
        {
            self.start_job(held);
        }
    }

    /// Drops a deferred start: after pause, cancel or stop the job must not start.
    fn withdraw_start(&mut self, request: &Request) {
        let rests = matches!(
            request,
            Request::PauseJob
                | Request::CancelJob { .. }
                | Request::Stop { .. }
                | Request::Lock { .. }
        );
        if rests {
            self.drop_held_start();
        }
    }

    pub(super) fn drop_held_start(&mut self) {
        if let Some(held) = self.held_start.take() {
            let why = "it was stopped before it had come to rest".to_owned();
            drop(held.start.reply.send(Err(Refusal::CannotResume(why))));
        }
    }

    fn startable(&self, job: u64) -> Result<Model, Refusal> {
        self.supervisor.check_rests(job)?;
        self.supervisor.planning_model()
    }
}

/// The time a job may take to come to rest before a deferred start: longer than it takes to locate
/// the job of a killed station.
const HOLD_START: Duration = Duration::from_secs(30);
