//! The driver: the task that owns the arm's port, with supervisor, clock, link, journal and
//! recording.

mod log;

use std::collections::HashMap;
use std::io;
use std::time::Duration;

use dobot_api::{
    Answer, CalibrationFile, Calibrations, ClientId, FleetWideStop, LinkPhase, LinkProblem, News,
    Notice, Reply, Request,
};
use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_session::{Link, LinkError};
use dobot_supervisor::{Effect, Refusal, StartedJob, StoppedBy, Supervisor};
use dobot_wire::{Dialect, Packet};
use tokio::runtime::Handle;
use tokio::sync::{mpsc, oneshot};
use tokio::time::Instant;

use self::log::log;
use crate::Found;
use crate::connect::{Connecting, Source};
use crate::disk::Disk;
use crate::finder::cause_of_link;
use crate::handle::{DriverChannels, Message, PassedPacket};
use crate::host::scaled_to_arm_time;
use crate::jobs::{GivenAnswer, JobStart, Jobs, Written, recovery_model};
use crate::known_arms::{KnownArms, NewText};
use crate::recording::Recording;
use crate::saved_slots::SavedSlots;
use crate::saved_stop::{Content, SavedStop};
use crate::watchdog::HeartbeatSender;

/// The task that owns the arm's port. It handles all events of the arm in one order.
#[derive(Debug)]
pub(crate) struct Driver {
    supervisor: Supervisor,
    started: Instant,
    channels: DriverChannels,
    source: Source,
    arms: KnownArms,
    slots: SavedSlots,
    stop: Option<SavedStop>,
    disk: Disk,
    link: Option<Link>,
    /// The current or last address of the arm.
    address: Option<String>,
    /// News of the connecting task, while there is no link.
    connecting: Option<mpsc::Receiver<Connecting>>,
    incoming: Vec<u8>,
    jobs: Jobs,
    /// Completed journal writes.
    written: mpsc::UnboundedReceiver<Written>,
    to_journal: mpsc::UnboundedSender<Written>,
    recording: Recording,
    /// Pending answers.
    waiting: HashMap<ClientId, oneshot::Sender<Result<Reply, Refusal>>>,
    /// A start that waits until its job has come to rest.
    held_start: Option<DeferredStart>,
    /// Whether an answer to the question of the job is being processed.
    is_answering: bool,
    /// For tasks that send messages to the driver.
    own: mpsc::Sender<Message>,
    heartbeats: HeartbeatSender,
    ending: Option<Instant>,
    /// The failure of something that the arm depends on.
    failure: Option<String>,
}

/// The components of a driver.
#[derive(Debug)]
pub(crate) struct DriverParts {
    pub(crate) supervisor: Supervisor,
    pub(crate) channels: DriverChannels,
    pub(crate) source: Source,
    pub(crate) arms: KnownArms,
    pub(crate) slots: SavedSlots,
    pub(crate) stop: Option<SavedStop>,
    pub(crate) disk: Disk,
    pub(crate) jobs: Jobs,
    pub(crate) recording: Recording,
    /// For tasks that send messages to the driver.
    pub(crate) own: mpsc::Sender<Message>,
    pub(crate) heartbeats: HeartbeatSender,
}

/// A start that waits until its job has come to rest.
#[derive(Debug)]
struct DeferredStart {
    start: JobStart,
    until: Duration,
}

/// What the driver waits for.
enum DriverEvent {
    Message(Option<Message>),
    Link(Result<bool, LinkError>),
    Connecting(Option<Connecting>),
    Written(Option<Written>),
    Time,
}

impl Driver {
    pub(crate) fn new(parts: DriverParts) -> Self {
        let (to_journal, written) = mpsc::unbounded_channel();
        Self {
            supervisor: parts.supervisor,
            started: Instant::now(),
            channels: parts.channels,
            source: parts.source,
            arms: parts.arms,
            slots: parts.slots,
            stop: parts.stop,
            disk: parts.disk,
            link: None,
            address: None,
            connecting: None,
            incoming: Vec::new(),
            jobs: parts.jobs,
            written,
            to_journal,
            recording: parts.recording,
            waiting: HashMap::new(),
            held_start: None,
            is_answering: false,
            own: parts.own,
            heartbeats: parts.heartbeats,
            ending: None,
            failure: None,
        }
    }

    /// Restores a job that was running when the previous station was killed.
    ///
    /// # Errors
    ///
    /// The reason of a failure, in one line.
    pub(crate) fn recover(&mut self) -> Result<(), String> {
        if let Some(text) = self.jobs.missing() {
            let now = self.now();
            self.supervisor.handle_jobs_missing(now, text);
        }
        let interrupted = self.jobs.interrupted().map_err(|error| error.to_string())?;
        let Some(job) = interrupted else {
            return Ok(());
        };
        match self.jobs.started_job(&job, recovery_model(&job)) {
            Ok(started) => {
                let now = self.now();
                self.supervisor.handle_recovered(now, started, job.window);
                Ok(())
            }
            Err(refusal) => {
                self.jobs.give_up(&job, &refusal.to_string());
                Err(format!("cannot resume job {}: {refusal}", job.id))
            }
        }
    }

    /// Restores the time slots of the previous station.
    ///
    /// # Errors
    ///
    /// The reason of a failure, in one line; then there are none.
    pub(crate) fn recover_slots(&mut self) -> Result<(), String> {
        let slots = self.slots.read(now_ms());
        let now = self.now();
        let taken = slots.and_then(|slots| {
            let taken = self.supervisor.handle_saved_slots(now, &slots);
            taken.map_err(|refusal| refusal.to_string())
        });
        taken.map_err(|why| format!("the saved time slots were lost: {why}"))
    }

    /// Restores the stops that held when the previous station ended.
    pub(crate) fn recover_stop(&mut self) {
        if let Some(Content { stop, fleet }) = self.stop.as_ref().map(SavedStop::read) {
            let now = self.now();
            self.supervisor.handle_saved_stops(now, stop, fleet);
        }
    }

    /// Saves the stops for the next station.
    fn save_stops(&mut self) {
        let kept = self.supervisor.poll_saved_stops();
        if let (Some(file), Some((stop, fleet))) = (&self.stop, kept) {
            let new = file.keep(&Content { stop, fleet });
            self.write_file(new.map(Some), "the stop cannot be kept");
        }
    }

    /// Saves the time slots for the next station.
    fn save_slots(&mut self) {
        let slots = self.slots.keep(&self.supervisor.slots(), now_ms());
        self.write_file(slots.map(Some), "the time slots cannot be saved");
    }

    /// Writes a file if there is new content. `problem` states what is lost if that fails.
    fn write_file(&mut self, new: io::Result<Option<NewText>>, problem: &'static str) {
        let written = match new {
            Ok(None) => Ok(()),
            Ok(Some(new)) => self.disk.write(new, problem),
            Err(error) => Err(format!("{problem}: {error}")),
        };
        if let Err(trouble) = written {
            let now = self.now();
            self.supervisor.handle_trouble(now, trouble);
        }
    }

    /// Runs until the station is asked to end: then the laser goes off, and in-flight commands get
    /// a moment to finish. `first` is the first result of connecting.
    ///
    /// # Errors
    ///
    /// The failure of something that the arm depends on, in one line.
    pub(crate) async fn run(mut self, first: Option<Connecting>) -> Result<(), String> {
        self.recording
            .tools(Duration::ZERO, self.supervisor.policy());
        self.follow(first);
        if self.link.is_none() && self.connecting.is_none() {
            self.connect();
        }
        loop {
            self.drain_outputs();
            if self.is_over() {
                break;
            }
            let event = self.next_event().await;
            // Input that has arrived may be old: serve the arm first.
            self.send_heartbeat();
            match event {
                DriverEvent::Message(Some(message)) => self.handle(message),
                DriverEvent::Message(None) => self.end(),
                DriverEvent::Link(outcome) => self.handle_received(outcome),
                DriverEvent::Connecting(None) => {
                    self.fail("the task that searches for the arm panicked".into());
                }
                DriverEvent::Connecting(news) => self.follow(news),
                DriverEvent::Written(Some(written)) => self.note(written),
                DriverEvent::Written(None) | DriverEvent::Time => {}
            }
            let now = self.now();
            self.supervisor.handle_time(now);
            self.try_held_start();
            self.give_due_answer();
            if let Some(trouble) = self.recording.poll_trouble() {
                self.supervisor.handle_trouble(now, trouble);
            }
        }
        Box::pin(self.part()).await
    }

    /// Reports to the watchdog that this loop is running. After a stall longer than the watchdog's
    /// patience, acts as after a fault.
    fn send_heartbeat(&mut self) {
        if let Some(silent) = self.heartbeats.send_due() {
            let now = self.now();
            self.supervisor.handle_stall(now, silent);
            self.disk.take_note(self.heartbeats.note());
        }
        let (now, gone) = (self.now(), self.heartbeats.gone().cloned());
        self.supervisor.handle_watchdog(now, gone);
        if let Some(trouble) = self.heartbeats.poll_trouble() {
            self.supervisor.handle_trouble(now, trouble);
        }
    }

    /// Returns the supervisor's time: the virtual arm's clock may run faster than real time.
    fn now(&self) -> Duration {
        match &self.link {
            Some(link) if self.source.is_virtual() => link.now(),
            _ => self.started.elapsed(),
        }
    }

    /// Returns until when to wait, in the arm's time and in real time.
    fn wakeups(&self) -> (Duration, Instant) {
        let within = self.heartbeats.due_in().unwrap_or(LOOK_AT_LEAST);
        let latest = Instant::now() + within.min(LOOK_AT_LEAST);
        let wanted = self.supervisor.poll_wakeup();
        if self.source.is_virtual() {
            return (wanted, latest);
        }
        let wanted = self.started.checked_add(wanted);
        (
            Duration::MAX,
            wanted.map_or(latest, |wanted| wanted.min(latest)),
        )
    }

    async fn next_event(&mut self) -> DriverEvent {
        let (until, wakeup) = self.wakeups();
        let link = self.link.as_mut();
        tokio::select! {
            // Messages come first, because a stop is a message. They starve nothing: each client
            // waits for its answer before it sends more, or is rate-limited.
            biased;
            message = self.channels.messages.recv() => DriverEvent::Message(message),
            written = self.written.recv() => DriverEvent::Written(written),
            received = receive(link, until, &mut self.incoming) => DriverEvent::Link(received),
            news = listen(self.connecting.as_mut()) => DriverEvent::Connecting(news),
            () = tokio::time::sleep_until(wakeup) => DriverEvent::Time,
        }
    }

    /// Carries out the supervisor's outputs, packets first.
    fn drain_outputs(&mut self) {
        self.send();
        self.relay();
        self.write_journal();
        while let Some((client, answer)) = self.supervisor.poll_answer() {
            if let Some(reply) = self.waiting.remove(&client) {
                // The requester may have left.
                let _ = reply.send(answer);
            }
        }
        while let Some(notice) = self.supervisor.poll_notice() {
            log(&notice);
            self.recording.notice(self.now(), &notice);
            self.remember(&notice);
            self.channels.publish_notice(notice);
        }
        self.save_stops();
        if self.supervisor.poll_changed() {
            self.publish();
        }
    }

    /// Hands all effects to the journal.
    fn write_journal(&mut self) {
        while let Some(effect) = self.supervisor.poll_effect() {
            self.write(effect);
        }
    }

    /// Sends packets before anything else, including answers and recording.
    fn send(&mut self) {
        self.send_heartbeat();
        while let Some(packet) = self.supervisor.poll_bytes() {
            let bytes = packet.to_bytes();
            let dialect = self.supervisor.dialect().unwrap_or(Dialect::SPECIFICATION);
            self.heartbeats.note_packet(&packet, &dialect);
            if let Some(link) = &mut self.link {
                link.send(&bytes);
                link.push();
                let pen_below_mm = self.supervisor.pen_draws_below_mm();
                self.recording.sent(self.now(), &bytes, pen_below_mm);
                self.publish_packet(true, bytes);
            }
        }
    }

    /// Passes statuses on to raw programs, as permits, and packets to their subscribers.
    fn relay(&mut self) {
        while let Some(status) = self.supervisor.poll_status() {
            let bytes = Packet::from(status.emit()).to_bytes();
            if self.supervisor.permits_raw() {
                self.channels.pass_on(bytes);
            }
            self.publish_packet(false, bytes);
        }
    }

    fn publish_packet(&self, to_arm: bool, bytes: [u8; 42]) {
        self.channels.publish_packet(PassedPacket {
            at: self.now(),
            to_arm,
            bytes,
            pen_below_mm: self.supervisor.pen_draws_below_mm(),
        });
    }

    fn publish(&mut self) {
        let state = self.supervisor.state();
        self.recording.state(self.now(), &state);
        self.channels.publish_state(state);
    }

    fn handle(&mut self, message: Message) {
        let now = self.now();
        match message {
            Message::Came {
                name,
                person,
                device,
                role,
                reply,
            } => {
                let client = self.supervisor.handle_client(now, &name, role, &person);
                self.supervisor.handle_device(client, device);
                tracing::debug!(client = client.0, name, ?role, "a client came");
                if reply.send(client).is_err() {
                    self.supervisor.handle_left(now, client);
                }
            }
            Message::Left(client) => {
                tracing::debug!(client = client.0, "a client left");
                self.waiting.remove(&client);
                self.supervisor.handle_left(now, client);
            }
            Message::Asked {
                client,
                request,
                reply,
            } => self.ask(client, request, reply),
            Message::Raw {
                client,
                packet,
                reply,
            } => {
                let taken = self.supervisor.handle_raw(now, client, &packet);
                self.send();
                // The program may have left.
                let _ = reply.send(taken);
            }
            Message::Planned {
                client,
                started,
                reply,
            } => {
                let answer = self.supervisor.handle_start(now, client, *started);
                let _ = reply.send(answer);
            }
            Message::Answered { longer, reply } => self.handle_answered(now, longer, reply),
            Message::Jobs(reply) => self.jobs.clone().list(self.supervisor.job(), reply),
            Message::Policy {
                client,
                policy,
                reply,
            } => {
                let changed = self.set_policy(now, client, &policy);
                // The requester may have left.
                let _ = reply.send(changed);
            }
            Message::JobPath { job, reply } => self.jobs.clone().path(job, reply),
            Message::Offer { key, ask, reply } => {
                let model = self.supervisor.planning_model();
                let jobs = self.jobs.clone();
                jobs.answer_offer(key, ask, model, now_ms(), reply);
            }
            Message::FleetStop { origin, by, reply } => {
                let _ = reply.send(self.stop_fleet(now, &origin, by));
            }
            Message::FleetStops { stops, reply } => {
                let _ = reply.send(self.adopt_fleet_stops(now, &stops));
            }
            Message::FleetReset { by, reply } => {
                let _ = reply.send(self.supervisor.handle_fleet_reset(now, &by));
            }
            Message::Trouble(text) => self.supervisor.handle_trouble(now, text),
            Message::Buttons(text) => self.supervisor.handle_buttons_changed(now, text),
            Message::Failed(text) => self.fail(text),
            Message::End => self.end(),
        }
    }

    /// Stops the whole fleet from here. Returns the stop, and how this arm stops.
    fn stop_fleet(&mut self, now: Duration, origin: &str, by: StoppedBy) -> (FleetWideStop, Reply) {
        self.drop_held_start();
        // With a clock before 1970, the count continues from the last stop.
        let now_ms = u64::try_from(now_ms()).unwrap_or_default();
        let stopped = self.supervisor.handle_fleet_stop(now, origin, by, now_ms);
        self.send();
        stopped
    }

    /// Adopts the fleet-wide stops of another station. Returns those known here, and how this arm stops
    /// if a stop holds it.
    fn adopt_fleet_stops(
        &mut self,
        now: Duration,
        stops: &[FleetWideStop],
    ) -> (Vec<FleetWideStop>, Option<Reply>) {
        let stopped = self.supervisor.handle_fleet_stops(now, stops);
        self.send();
        if stopped.is_some() {
            self.drop_held_start();
        }
        (self.supervisor.state().fleet_stops, stopped)
    }

    fn set_policy(
        &mut self,
        now: Duration,
        client: ClientId,
        policy: &Policy,
    ) -> Result<(), Refusal> {
        let of_arm = scaled_to_arm_time(policy, self.source.speed());
        self.supervisor.handle_policy(now, client, of_arm)?;
        self.jobs.set_policy(policy);
        self.recording.tools(now, policy);
        self.channels.change_rules(|rules| {
            rules.policy = policy.clone();
            rules.dead_man_s = policy.jog.dead_man_s;
        });
        Ok(())
    }

    /// Sets the calibration and saves it for this arm.
    fn calibrate(
        &mut self,
        now: Duration,
        client: ClientId,
        calibration: Option<CalibrationFile>,
    ) -> Result<Calibrations, Refusal> {
        if let Some(Err(error)) = calibration.as_ref().map(CalibrationFile::check) {
            return Err(Refusal::OutOfRange {
                name: error.key,
                found: error.found,
                allowed: format!("{} to {}", error.least, error.most),
            });
        }
        let Some(address) = self.address.clone() else {
            return Err(Refusal::NoLink(
                "a calibration is saved for an arm, and none has been connected yet".into(),
            ));
        };
        let calibrations = self.arms.calibrations(&address).replaced_by(calibration);
        self.supervisor
            .handle_calibration(now, client, &calibrations)?;
        let new = self.arms.calibrate(&address, calibrations.clone());
        self.write_file(new, "the calibration of the arm cannot be saved");
        self.channels
            .change_rules(|rules| rules.calibrations = calibrations.clone());
        Ok(calibrations)
    }

    /// Ends the station, because something that the arm depends on has failed.
    fn fail(&mut self, text: String) {
        tracing::error!("the station ends: {text}");
        self.connecting = None;
        self.failure = Some(text);
        self.end();
    }

    fn ask(
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
        if let Some((job, reply)) = self.ask_jobs(client, request, reply) {
            let sets_slots = matches!(job, Request::SetSlots { .. });
            let answer = self.supervisor.handle_request(now, client, job);
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
            Request::MarkEpisode { .. } if let Some(why) = self.recording.missing() => {
                let _ = reply.send(Err(Refusal::NotRecorded(why)));
            }
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
        let before = self.supervisor.answers_of(job, question);
        let before = before.and_then(|before| {
            let is_first = !self.is_answering;
            is_first.then_some(before).ok_or(Refusal::NoQuestion(job))
        });
        let found = before.and_then(|before| Ok((before, self.supervisor.planning_model()?)));
        match found {
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

    /// Handles the longer program that follows an answer, or why there is none.
    fn handle_answered(
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
    fn give_due_answer(&mut self) {
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

    fn try_held_start(&mut self) {
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

    fn drop_held_start(&mut self) {
        if let Some(held) = self.held_start.take() {
            let why = "it was stopped before it had come to rest".to_owned();
            drop(held.start.reply.send(Err(Refusal::CannotResume(why))));
        }
    }

    fn startable(&self, job: u64) -> Result<Model, Refusal> {
        self.supervisor.check_rests(job)?;
        self.supervisor.planning_model()
    }

    fn handle_received(&mut self, outcome: Result<bool, LinkError>) {
        let now = self.now();
        if !self.incoming.is_empty() {
            self.recording.received(now, &self.incoming);
            self.supervisor.handle_bytes(now, &self.incoming);
            self.incoming.clear();
        }
        let error = match outcome {
            Ok(true) => return,
            Ok(false) => LinkError::Closed,
            Err(error) => error,
        };
        self.link = None;
        self.heartbeats.stop();
        let problem = LinkProblem {
            cause: cause_of_link(&error),
            text: format!("{error}; the station is searching for the arm again"),
            remedy: error.hint().map(str::to_owned),
        };
        self.supervisor
            .handle_link_down(now, LinkPhase::Lost, problem);
        self.connect();
    }

    fn take_up(&mut self, found: Found) {
        let now = self.now();
        self.recording
            .link(now, &found.address, self.supervisor.dialect());
        let address = found.address.to_string();
        tracing::info!(address, "the link to the arm is open");
        self.connecting = None;
        self.heartbeats.start(&found.link);
        self.link = Some(found.link);
        if let Some(dialect) = self.arms.dialect(&address) {
            self.supervisor.handle_known_dialect(dialect);
        }
        let calibrations = self.arms.calibrations(&address);
        self.supervisor
            .handle_known_calibration(&address, &calibrations);
        self.channels
            .change_rules(|rules| rules.calibrations = calibrations);
        self.supervisor.handle_link_up(now, &address);
        self.recording.received(now, &found.bytes);
        self.supervisor.handle_bytes(now, &found.bytes);
        self.address = Some(address);
    }

    /// Saves the arm's dialect once it is known.
    fn remember(&mut self, notice: &Notice) {
        let (News::DialectKnown { dialect }, Some(address)) = (&notice.news, &self.address) else {
            return;
        };
        if self.source.is_virtual() {
            return;
        }
        let finding = self.supervisor.finding();
        let new = self.arms.keep(address, *dialect, finding);
        self.write_file(new, "the dialect of the arm cannot be saved");
    }

    /// Searches for the arm in a task.
    fn connect(&mut self) {
        if self.ending.is_none() {
            self.connecting = Some(self.source.connect(&Handle::current()));
        }
    }

    fn follow(&mut self, news: Option<Connecting>) {
        let now = self.now();
        match news {
            Some(Connecting::Up(found)) => self.take_up(found),
            Some(Connecting::Waiting(problem)) => {
                self.supervisor
                    .handle_link_down(now, LinkPhase::Searching, problem);
            }
            Some(Connecting::Begun(news)) => self.connecting = Some(news),
            None => {}
        }
    }

    fn write(&mut self, effect: Effect) {
        self.jobs.write(effect, self.to_journal.clone());
    }

    fn note(&mut self, written: Written) {
        let now = self.now();
        let Written { effect, outcome } = written;
        self.supervisor.handle_written(now, &effect, outcome);
    }

    /// Ends the station: no more commands of the job, laser off; in-flight commands get a moment to
    /// finish.
    fn end(&mut self) {
        if self.ending.is_none() {
            self.ending = Some(Instant::now() + PATIENCE);
            let now = self.now();
            self.supervisor.handle_end(now);
        }
    }

    fn is_over(&self) -> bool {
        self.ending.is_some_and(|ending| {
            let still = self.supervisor.is_at_rest() && !self.supervisor.is_urgent();
            self.link.is_none() || still || ending <= Instant::now()
        })
    }

    async fn part(mut self) -> Result<(), String> {
        self.drain_outputs();
        if let Some(link) = &mut self.link {
            // A broken link accepts nothing.
            let _ = link.flush().await;
        }
        self.heartbeats.stop();
        let at_rest = self.supervisor.is_at_rest() || self.link.is_none();
        self.jobs.end(at_rest).await;
        self.recording.end();
        self.disk.finish();
        self.failure.map_or(Ok(()), Err)
    }
}

async fn receive(
    link: Option<&mut Link>,
    until: Duration,
    incoming: &mut Vec<u8>,
) -> Result<bool, LinkError> {
    match link {
        Some(link) => link.receive(until, incoming).await,
        None => std::future::pending().await,
    }
}

async fn listen(connecting: Option<&mut mpsc::Receiver<Connecting>>) -> Option<Connecting> {
    match connecting {
        Some(connecting) => connecting.recv().await,
        None => std::future::pending().await,
    }
}

/// Returns the milliseconds since 1970-01-01T00:00:00Z.
fn now_ms() -> i64 {
    jiff::Timestamp::now().as_millisecond()
}

/// The supervisor is checked at least this often.
const LOOK_AT_LEAST: Duration = Duration::from_secs(1);
/// The time the arm may take to come to rest when the station ends.
const PATIENCE: Duration = Duration::from_secs(3);
/// The time a job may take to come to rest before a deferred start: longer than it takes to locate
/// the job of a killed station.
const HOLD_START: Duration = Duration::from_secs(30);
