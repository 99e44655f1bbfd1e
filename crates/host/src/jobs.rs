//! The jobs on the disk: submitted jobs, their progress and recovery.

mod check;
mod list;
mod offers;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use dobot_api::{Answer, ClientId, JobPath, JobPhase, JobState, JobView, NewJob, Reply};
use dobot_arm::{Joints, Tool};
use dobot_journal::{Job, JobExtension, JobId, Journal, JournalError, PlannedJob, Window};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::Policy;
use dobot_supervisor::{Effect, JobPlan, Refusal, StartedJob, plain};
use dobot_wire::Command;
use tokio::sync::{mpsc, oneshot};

use self::check::check_new;
pub(crate) use self::list::{again, forget, list, move_before};
pub use self::offers::WITHDRAWN;
pub(crate) use self::offers::answer;
use crate::handle::{Message, OfferAnswer, OfferRequest};
use crate::job_path::path_of;

/// The jobs on the disk. Planning and writing may be slow, so both happen outside the driver.
#[derive(Clone, Debug)]
pub(crate) struct Jobs {
    journal: Arc<Journal>,
    policy: Arc<Policy>,
    orders: mpsc::UnboundedSender<Order>,
}

/// A request to start or resume a job.
#[derive(Debug)]
pub(crate) struct JobStart {
    pub(crate) client: ClientId,
    pub(crate) job: u64,
    /// Whether it comes to rest after the next step.
    pub(crate) single_step: bool,
    pub(crate) reply: oneshot::Sender<Result<Reply, Refusal>>,
}

/// A completed or failed write.
#[derive(Debug)]
pub(crate) struct Written {
    pub(crate) effect: Effect,
    /// The error, in one line.
    pub(crate) outcome: Result<(), String>,
}

/// An order to the writer thread.
#[derive(Debug)]
enum Order {
    Write(Effect, mpsc::UnboundedSender<Written>),
    /// Reports that all earlier orders are written.
    Reached(oneshot::Sender<()>),
    /// The last order: the station ends, with the arm at rest or not.
    End {
        at_rest: bool,
        done: oneshot::Sender<()>,
    },
}

impl Jobs {
    /// Opens the jobs of a journal. The driver is notified if they can no longer be written.
    pub(crate) fn new(
        journal: Journal,
        policy: Arc<Policy>,
        driver: mpsc::Sender<Message>,
    ) -> Self {
        let journal = Arc::new(journal);
        let (orders, waiting) = mpsc::unbounded_channel();
        let writer = journal.clone();
        std::thread::spawn(move || watch(&driver, || write_all(&writer, waiting)));
        Self {
            journal,
            policy,
            orders,
        }
    }

    /// Uses another policy for planning from now on.
    pub(crate) fn set_policy(&mut self, policy: &Policy) {
        self.policy = Arc::new(policy.clone());
    }

    /// Returns what is missing because the journal was damaged and what to do, in one line.
    pub(crate) fn missing(&self) -> Option<String> {
        let missing = self.journal.missing_writes();
        (missing > 0).then(|| {
            let writes = if missing == 1 { "write" } else { "writes" };
            format!(
                "the journal was damaged and has lost its last {missing} {writes}: the last queued jobs may be missing; check `dobot jobs`, and submit missing jobs again"
            )
        })
    }

    /// Returns the job that was running when the station ended unexpectedly.
    pub(crate) fn interrupted(&self) -> Result<Option<Job>, JournalError> {
        let jobs = self.journal.jobs()?;
        Ok(jobs.into_iter().find(|job| job.state == JobState::Running))
    }

    /// Checks a job again and returns it for the supervisor.
    pub(crate) fn started_job(&self, job: &Job, model: Model) -> Result<StartedJob, Refusal> {
        check_again(&self.journal, &self.policy, job, model)
    }

    /// Fails a job that cannot even be checked again.
    pub(crate) fn give_up(&self, job: &Job, why: &str) {
        let reason = why.to_owned();
        // If the journal cannot be written either, the next start tries again.
        let _ = self.journal.set_state(job.id, &JobState::Failed { reason });
    }

    /// Plans and stores a new job.
    pub(crate) fn submit(
        self,
        job: NewJob,
        key: Option<String>,
        model: Model,
        now_ms: i64,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        self.answer(reply, move |jobs| jobs.keep(job, key, model, now_ms));
    }

    /// Plans and stores a copy of a job.
    pub(crate) fn queue_again(
        self,
        job: u64,
        key: Option<String>,
        model: Model,
        now_ms: i64,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        self.answer(reply, move |jobs| {
            jobs.keep(again(&jobs.journal, job, &model)?, key, model, now_ms)
        });
    }

    /// Answers another station's request about a job offer.
    pub(crate) fn answer_offer(
        self,
        key: String,
        ask: OfferRequest,
        model: Result<Model, Refusal>,
        now_ms: i64,
        reply: oneshot::Sender<Result<OfferAnswer, Refusal>>,
    ) {
        self.answer(reply, move |jobs| {
            jobs.catch_up();
            let answered = answer(&jobs.journal, &jobs.policy, &key, ask, model, now_ms);
            // The history may exceed its limit until the next time.
            let _ = jobs.journal.keep_last(HISTORY);
            answered
        });
    }

    /// Moves a queued job before another one, or to the end.
    pub(crate) fn move_before(
        self,
        job: u64,
        before: Option<u64>,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        self.answer(reply, move |jobs| {
            jobs.catch_up();
            move_before(&jobs.journal, job, before)?;
            jobs.kept(job)
        });
    }

    /// Removes a job that is not the current one.
    pub(crate) fn forget(self, job: u64, reply: oneshot::Sender<Result<Reply, Refusal>>) {
        self.answer(reply, move |jobs| {
            jobs.catch_up();
            forget(&jobs.journal, job).map(|()| Reply::Done)
        });
    }

    /// Plans a job to start and sends it to the driver.
    pub(crate) fn plan(self, start: JobStart, model: Model, driver: mpsc::Sender<Message>) {
        let JobStart {
            client,
            job,
            single_step,
            reply,
        } = start;
        tokio::task::spawn_blocking(move || match self.startable(job, model) {
            Err(refusal) => {
                // The requester may have left.
                let _ = reply.send(Err(refusal));
            }
            Ok(started) => {
                let started = Box::new(StartedJob {
                    single_step,
                    ..started
                });
                // A driver that ends drops the message, and with it the reply.
                let _ = driver.blocking_send(Message::Planned {
                    client,
                    started,
                    reply,
                });
            }
        });
    }

    /// Continues a program by an answer, and sends the longer job to the driver.
    pub(crate) fn answer_question(
        self,
        given: GivenAnswer,
        model: Model,
        reply: Option<oneshot::Sender<Result<Reply, Refusal>>>,
        driver: mpsc::Sender<Message>,
    ) {
        tokio::task::spawn_blocking(move || {
            self.catch_up();
            let extend = || extended(&self.journal, &self.policy, given, model).map(Box::new);
            // The driver waits for this message before it takes another answer.
            let longer = catch_unwind(AssertUnwindSafe(extend)).unwrap_or_else(|_| {
                let why = "an internal error; the log has its place".to_owned();
                Err(Refusal::BadAnswer(why))
            });
            // A driver that ends drops the message, and with it the reply.
            let _ = driver.blocking_send(Message::Answered { longer, reply });
        });
    }

    /// Ends a job that is not the current one.
    pub(crate) fn cancel(
        self,
        job: u64,
        by: String,
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    ) {
        self.answer(reply, move |jobs| {
            jobs.catch_up();
            end_waiting(&jobs.journal, job, &by)?;
            jobs.kept(job)
        });
    }

    /// Returns all jobs in order; the supervisor's current job as it is now, all others as last
    /// stored.
    pub(crate) fn list(
        self,
        current: Option<JobView>,
        reply: oneshot::Sender<Result<Vec<JobView>, Refusal>>,
    ) {
        self.answer(reply, move |jobs| {
            jobs.catch_up();
            list(&jobs.journal, current.as_ref())
        });
    }

    /// Returns the path of a job.
    pub(crate) fn path(self, job: u64, reply: oneshot::Sender<Result<JobPath, Refusal>>) {
        self.answer(reply, move |jobs| path_of(&jobs.journal, job));
    }

    /// Writes an effect of the supervisor, in order.
    pub(crate) fn write(&self, effect: Effect, written: mpsc::UnboundedSender<Written>) {
        // The writer ends only after this sender.
        let _ = self.orders.send(Order::Write(effect, written));
    }

    /// Waits until all is written and notes whether the arm is at rest.
    pub(crate) async fn end(&self, at_rest: bool) {
        let (done, waiting) = oneshot::channel();
        if self.orders.send(Order::End { at_rest, done }).is_ok() {
            // The writer exists until it has answered.
            let _ = waiting.await;
        }
    }

    /// Does slow work in a background thread and answers with its result.
    fn answer<T: Send + 'static>(
        self,
        reply: oneshot::Sender<Result<T, Refusal>>,
        work: impl FnOnce(&Self) -> Result<T, Refusal> + Send + 'static,
    ) {
        tokio::task::spawn_blocking(move || {
            // The requester may have left.
            let _ = reply.send(work(&self));
        });
    }

    fn keep(
        &self,
        job: NewJob,
        key: Option<String>,
        model: Model,
        now_ms: i64,
    ) -> Result<Reply, Refusal> {
        let id = submit(&self.journal, &self.policy, job, key, model, now_ms)?;
        // The history may exceed its limit until the next time.
        let _ = self.journal.keep_last(HISTORY);
        self.kept(id.0)
    }

    /// Returns the job from the journal.
    fn kept(&self, job: u64) -> Result<Reply, Refusal> {
        let job = find(&self.journal, job)?;
        Ok(Reply::Job { job: view(&job) })
    }

    fn startable(&self, job: u64, model: Model) -> Result<StartedJob, Refusal> {
        self.catch_up();
        startable(&self.journal, &self.policy, job, model)
    }

    /// Waits until the journal has all earlier effects, such as a pause.
    fn catch_up(&self) {
        let (done, reached) = oneshot::channel();
        if self.orders.send(Order::Reached(done)).is_ok() {
            // A writer that has ended has written everything.
            let _ = reached.blocking_recv();
        }
    }
}

/// Ends a job that is not the current one.
pub(crate) fn end_waiting(journal: &Journal, job: u64, by: &str) -> Result<(), Refusal> {
    let job = find(journal, job)?;
    if job.state.is_over() {
        return Err(Refusal::JobPhase {
            job: job.id.0,
            found: job.state.phase(),
            allowed: "queued, running or paused",
        });
    }
    let reason = format!("ended by {by}");
    journal
        .set_state(job.id, &JobState::Stopped { reason })
        .map_err(|error| journal_refusal(&error))
}

/// Returns whether a job last came to rest at a pause for a person.
fn waits_for_person(job: &Job) -> bool {
    let last = job.history.pauses.checked_sub(1);
    let pause = last.and_then(|last| job.pauses.get(last));
    job.state.phase() == JobPhase::Paused
        && pause.is_some_and(|pause| pause.before == job.window.completed)
}

/// Converts a job of the journal to its view.
pub(crate) fn view(job: &Job) -> JobView {
    JobView {
        job: job.id.0,
        title: job.title.clone(),
        kind: job.kind,
        created_ms: job.created_ms,
        phase: job.state.phase(),
        reason: job.state.reason().map(str::to_owned),
        waits_for_person: waits_for_person(job),
        commands: job.commands,
        completed: job.program.at(job.window.completed, job.commands).1,
        planned_s: job.planned_s,
        left_s: job.planned_s.filter(|_| job.window.completed == 0),
        took_s: job.history.ran_s.filter(|_| job.state == JobState::Done),
        speed_percent: job.adjustment.speed_percent,
        height_mm: job
            .adjustment
            .heights
            .last()
            .map_or(0.0, |height| height.offset_mm),
        program: job.program.view(job.commands, job.window.completed),
        question: None,
    }
}

/// Plans a new job completely and stores it; returns its number, or that of the earlier job with
/// the same key.
pub(crate) fn submit(
    journal: &Journal,
    policy: &Policy,
    job: NewJob,
    key: Option<String>,
    model: Model,
    now_ms: i64,
) -> Result<JobId, Refusal> {
    let planned = planned(policy, job, key, model, now_ms)?;
    journal
        .submit(&planned)
        .map_err(|error| journal_refusal(&error))
}

/// Plans a new job completely.
fn planned(
    policy: &Policy,
    mut job: NewJob,
    key: Option<String>,
    model: Model,
    now_ms: i64,
) -> Result<PlannedJob, Refusal> {
    key.as_deref().map_or(Ok(()), check_key)?;
    job.title = plain(&job.title, usize::MAX);
    check_new(&job)?;
    let plan = new_plan(policy, model, &job)?;
    Ok(PlannedJob {
        title: job.title,
        kind: job.kind,
        dialect: model.dialect,
        calibration: model.calibration,
        lift_mm: Some(job.lift_mm).filter(|lift_mm| *lift_mm > 0.0),
        created_ms: now_ms,
        planned_s: plan.planned_s(),
        commands: job.commands,
        pauses: job.pauses,
        program: job.program,
        key,
    })
}

fn new_plan(policy: &Policy, model: Model, job: &NewJob) -> Result<JobPlan, Refusal> {
    let commands = job.commands.clone();
    JobPlan::new(policy, model, commands, &[], job.lift_mm, 0, &job.program)
}

/// Checks a job that is to start or resume.
pub(crate) fn startable(
    journal: &Journal,
    policy: &Policy,
    job: u64,
    model: Model,
) -> Result<StartedJob, Refusal> {
    let job = find(journal, job)?;
    if !matches!(job.state, JobState::Queued | JobState::Paused { .. }) {
        return Err(Refusal::JobPhase {
            job: job.id.0,
            found: job.state.phase(),
            allowed: "queued or paused",
        });
    }
    check_made_for(&job, &model)?;
    check_again(journal, policy, &job, model)
}

/// An answer to the question of a job.
#[derive(Debug)]
pub(crate) struct GivenAnswer {
    pub(crate) job: u64,
    /// The number of answers before.
    pub(crate) before: usize,
    pub(crate) answer: Answer,
}

/// Compiles and checks the longer program that follows an answer, and stores it.
pub(crate) fn extended(
    journal: &Journal,
    policy: &Policy,
    given: GivenAnswer,
    model: Model,
) -> Result<StartedJob, Refusal> {
    let job = find(journal, given.job)?;
    let longer = continued(&job, given)?;
    let extension = JobExtension {
        commands: longer.commands,
        pauses: longer.pauses,
        program: longer.program,
    };
    let extended = Job {
        commands: extension.commands.len(),
        pauses: extension.pauses.clone(),
        program: extension.program.clone(),
        ..job
    };
    let plan =
        plan_again(policy, &extended, extension.commands.clone(), model).map_err(bad_answer)?;
    journal
        .extend(extended.id, &extension)
        .map_err(|error| journal_refusal(&error))?;
    Ok(StartedJob::new(&extended, plan))
}

/// Compiles the longer program that follows an answer.
fn continued(job: &Job, given: GivenAnswer) -> Result<NewJob, Refusal> {
    let asking = job.program.asking.as_ref();
    let asking = asking.filter(|asking| asking.answers.len() == given.before);
    let asking = asking.ok_or(Refusal::NoQuestion(given.job))?;
    let longer = dobot_teach::continued(asking, given.answer, &job.calibration)
        .map_err(|error| Refusal::BadAnswer(error.to_string()))?;
    let longer = NewJob {
        title: job.title.clone(),
        ..longer
    };
    check_new(&longer)?;
    Ok(longer)
}

/// An answer is what makes a command of the longer program bad.
fn bad_answer(refusal: Refusal) -> Refusal {
    match refusal {
        Refusal::BadJob { why, .. } => Refusal::BadAnswer(why),
        refusal => refusal,
    }
}

/// Checks that the commands of a job were made for the arm as it is now.
fn check_made_for(job: &Job, model: &Model) -> Result<(), Refusal> {
    if job.dialect != model.dialect {
        return Err(Refusal::CannotResume(format!(
            "it was made for an arm that speaks {}, and this one speaks {}",
            job.dialect, model.dialect
        )));
    }
    if !job.calibration.is_same(&model.calibration) {
        return Err(Refusal::CannotResume(
            "it was made for another calibration: the calibration has changed, or the arm was given its angles since; submit it again".into(),
        ));
    }
    Ok(())
}

pub(crate) fn find(journal: &Journal, job: u64) -> Result<Job, Refusal> {
    match journal.job(JobId(job)) {
        Err(JournalError::NoSuchJob(_)) => Err(Refusal::NoSuchJob(job)),
        found => found.map_err(|error| journal_refusal(&error)),
    }
}

/// Checks a job again and returns it for the supervisor.
pub(crate) fn check_again(
    journal: &Journal,
    policy: &Policy,
    job: &Job,
    model: Model,
) -> Result<StartedJob, Refusal> {
    let commands = journal
        .commands(job.id)
        .map_err(|error| journal_refusal(&error))?;
    Ok(StartedJob::new(
        job,
        plan_again(policy, job, commands, model)?,
    ))
}

fn plan_again(
    policy: &Policy,
    job: &Job,
    commands: Vec<Command>,
    model: Model,
) -> Result<JobPlan, Refusal> {
    let lift_mm = job.lift_mm.unwrap_or(0.0);
    JobPlan::new(
        policy,
        model,
        commands,
        &job.adjustment.heights,
        lift_mm,
        job.window.upto,
        &job.program,
    )
}

/// Returns the model for checking an interrupted job: its first target sets the start, so any
/// position works.
pub(crate) fn recovery_model(job: &Job) -> Model {
    let somewhere = Joints::new(0.0, 45.0, 45.0, 0.0);
    let place = ArmPlace::at_joints(somewhere, Tool::SuctionCup);
    Model::standing(job.dialect, place).calibrated(job.calibration)
}

/// Runs the journal writer; a panic in it ends the station.
fn watch(driver: &mpsc::Sender<Message>, writing: impl FnOnce()) {
    if catch_unwind(AssertUnwindSafe(writing)).is_err() {
        let text = "the thread that writes the journal panicked".to_owned();
        // A driver that has ended needs no journal.
        let _ = driver.blocking_send(Message::Failed(text));
    }
}

/// Writes in a thread of its own, because disks are slow.
fn write_all(journal: &Journal, mut orders: mpsc::UnboundedReceiver<Order>) {
    while let Some(order) = orders.blocking_recv() {
        match order {
            Order::Write(effect, written) => {
                let outcome = write(journal, &effect).map_err(|error| error.to_string());
                // A driver that has ended needs no confirmation.
                let _ = written.send(Written { effect, outcome });
            }
            Order::Reached(done) => {
                // The requester may have left.
                let _ = done.send(());
            }
            Order::End { at_rest, done } => {
                if at_rest {
                    // A journal that cannot be written reports that at the next start.
                    let _ = journal.note_clean_shutdown();
                }
                let _ = done.send(());
                return;
            }
        }
    }
}

/// Writes an effect of the supervisor.
pub(crate) fn write(journal: &Journal, effect: &Effect) -> Result<(), JournalError> {
    match effect {
        Effect::ExtendWindow {
            job,
            completed,
            upto,
            start,
        } => journal.extend_window(
            JobId(*job),
            &Window {
                completed: *completed,
                upto: *upto,
                start: *start,
            },
        ),
        Effect::Phase {
            job,
            phase,
            reason,
            window,
            history,
        } => {
            // A job that does not run was given nothing: its progress has not changed.
            if let Some(window) = window
                && journal.job(JobId(*job))?.state == JobState::Running
            {
                journal.extend_window(JobId(*job), window)?;
            }
            let state = JobState::new(*phase, reason.clone());
            journal.set_state_with_history(JobId(*job), &state, *history)
        }
        Effect::Adjust { job, adjustment } => journal.adjust(JobId(*job), adjustment),
    }
}

pub(crate) fn journal_refusal(error: &JournalError) -> Refusal {
    match error {
        JournalError::KeyReused { key, job } => Refusal::KeyReused {
            key: key.clone(),
            job: job.0,
        },
        error => Refusal::Journal(error.to_string()),
    }
}

/// Checks that a text is a valid idempotency key.
fn check_key(key: &str) -> Result<(), Refusal> {
    let characters = key.chars().count();
    if (1..=LONGEST_KEY).contains(&characters) && key.chars().all(dobot_supervisor::is_plain) {
        return Ok(());
    }
    Err(Refusal::Malformed(format!(
        "the key has {characters} characters; allowed are 1 to {LONGEST_KEY} visible ones"
    )))
}

/// The maximum number of characters of a key.
const LONGEST_KEY: usize = 64;

/// The number of finished jobs kept.
const HISTORY: usize = 100;

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn a_panic_while_the_journal_is_written_ends_the_station() {
        let (driver, mut messages) = mpsc::channel(1);
        std::thread::spawn(move || watch(&driver, || panic!("the disk is made of cheese")));
        let Some(Message::Failed(text)) = messages.recv().await else {
            panic!("it is reported as a failure");
        };
        assert_eq!(text, "the thread that writes the journal panicked");
    }
}
