//! The driver: the task that owns the arm's port, with supervisor, clock, link, journal and
//! recording.

mod log;
mod messages;
mod requests;
mod saved;

use std::collections::HashMap;
use std::time::Duration;

use dobot_api::{ClientId, LinkPhase, LinkProblem, Reply};
use dobot_session::{Link, LinkError};
use dobot_supervisor::{Effect, Refusal, Supervisor};
use dobot_wire::{Dialect, Packet};
use tokio::runtime::Handle;
use tokio::sync::{mpsc, oneshot};
use tokio::time::Instant;

use self::log::log;
use self::requests::DeferredStart;
use crate::Found;
use crate::connect::{Connecting, Source};
use crate::disk::Disk;
use crate::finder::{cause_of_link, check_open};
use crate::handle::{DriverChannels, Message, PassedPacket};
use crate::jobs::{Jobs, Written};
use crate::known_arms::KnownArms;
use crate::recording::Recording;
use crate::saved_slots::SavedSlots;
use crate::saved_stop::SavedStop;
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
            self.handle_event(event);
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

    fn handle_event(&mut self, event: DriverEvent) {
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

    /// Ends the station, because something that the arm depends on has failed.
    fn fail(&mut self, text: String) {
        tracing::error!("the station ends: {text}");
        self.connecting = None;
        self.failure = Some(text);
        self.end();
    }

    fn handle_received(&mut self, outcome: Result<bool, LinkError>) {
        let now = self.now();
        if !self.incoming.is_empty() {
            self.recording.received(now, &self.incoming);
            self.supervisor.handle_bytes(now, &self.incoming);
            self.incoming.clear();
        }
        let Err(error) = check_open(outcome) else {
            return;
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
