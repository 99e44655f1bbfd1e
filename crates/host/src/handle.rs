//! The channels between the station's tasks and the driver.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError, RwLock};
use std::time::Duration;

use bytes::Bytes;
use dobot_api::{
    Calibrations, ClientId, Device, FleetWideStop, JobPath, JobView, NewJob, Notice, Reply,
    Request, Role, State,
};
use dobot_arm::Calibration;
use dobot_safety::Policy;
use dobot_wire::Packet;
use tokio::sync::{broadcast, mpsc, oneshot, watch};

use dobot_supervisor::{Refusal, StartedJob, StoppedBy};

/// The station's access to the driver; clones share it.
#[derive(Clone, Debug)]
pub struct StationHandle {
    pub(crate) messages: mpsc::Sender<Message>,
    pub(crate) states: watch::Receiver<Arc<Snapshot>>,
    pub(crate) every: broadcast::Sender<Arc<Snapshot>>,
    pub(crate) notices: broadcast::Sender<Arc<Notice>>,
    pub(crate) recent: Arc<Mutex<VecDeque<Arc<Notice>>>>,
    pub(crate) packets: broadcast::Sender<[u8; 42]>,
    pub(crate) passed: broadcast::Sender<PassedPacket>,
    pub(crate) rules: Arc<RwLock<Arc<Rules>>>,
}

/// The driver's side of all [`StationHandle`]s: receives their messages and publishes states,
/// notices and packets.
#[derive(Debug)]
pub struct DriverChannels {
    /// Messages from handles and clients.
    pub messages: mpsc::Receiver<Message>,
    states: watch::Sender<Arc<Snapshot>>,
    every: broadcast::Sender<Arc<Snapshot>>,
    notices: broadcast::Sender<Arc<Notice>>,
    recent: Arc<Mutex<VecDeque<Arc<Notice>>>>,
    packets: broadcast::Sender<[u8; 42]>,
    rules: Arc<RwLock<Arc<Rules>>>,
    passed: broadcast::Sender<PassedPacket>,
}

/// A packet that has passed between the station and the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassedPacket {
    /// The time since the station started.
    pub at: Duration,
    /// Whether it went to the arm; otherwise it is a status.
    pub to_arm: bool,
    /// The packet.
    pub bytes: [u8; 42],
    /// The tool height below which a pen draws at that time, in millimetres and raw coordinates;
    /// `None` if no job lifts a pen.
    pub pen_below_mm: Option<f64>,
}

/// The rules in force until policy or calibration change.
#[derive(Clone, Debug)]
pub struct Rules {
    /// The policy.
    pub policy: Policy,
    /// The dead-man time: how long a jog button stays pressed without a repeated request, in
    /// seconds.
    pub dead_man_s: f64,
    /// The calibrations of the arm.
    pub calibrations: Calibrations,
}

impl Rules {
    /// Returns the rules of a policy and of the calibrations of an arm.
    #[must_use]
    pub fn with_calibrations(policy: &Policy, calibrations: Calibrations) -> Self {
        Self {
            calibrations,
            ..Self::of(policy)
        }
    }

    /// Returns the rules of a policy.
    #[must_use]
    pub fn of(policy: &Policy) -> Self {
        Self {
            policy: policy.clone(),
            dead_man_s: policy.jog.dead_man_s,
            calibrations: Calibrations::default(),
        }
    }
}

/// A state with its JSON, serialized once for all observers.
#[derive(Debug)]
pub struct Snapshot {
    state: State,
    /// `{"state":...}` in UTF-8, as sent to observers.
    message: Bytes,
}

impl Snapshot {
    /// Serializes a state.
    ///
    /// # Panics
    ///
    /// Never: a state consists of structures with string keys, which JSON can always represent.
    #[must_use]
    pub fn new(state: State) -> Self {
        let json = serde_json::to_string(&state).expect("structures with text keys are JSON");
        Self {
            state,
            message: format!("{BEFORE}{json}{AFTER}").into(),
        }
    }

    /// Returns the state.
    #[must_use]
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// Returns the state as JSON; clones share the bytes.
    #[must_use]
    pub fn json(&self) -> Bytes {
        let end = self.message.len() - AFTER.len();
        self.message.slice(BEFORE.len()..end)
    }

    /// Returns the message to observers, `{"state":...}` in UTF-8; clones share the bytes.
    #[must_use]
    pub fn message(&self) -> Bytes {
        self.message.clone()
    }
}

const BEFORE: &str = "{\"state\":";
const AFTER: &str = "}";

/// A client of the station; when this is dropped, it disconnects and its lease ends.
#[derive(Debug)]
pub struct Client {
    id: ClientId,
    role: Role,
    person: String,
    handle: StationHandle,
}

/// A message to the driver.
#[derive(Debug)]
pub enum Message {
    /// A client connects.
    Came {
        /// The name.
        name: String,
        /// The person it counts as for time slots.
        person: String,
        /// The device, if it is a page.
        device: Option<Device>,
        /// The role.
        role: Role,
        /// The client's number.
        reply: oneshot::Sender<ClientId>,
    },
    /// A client disconnects.
    Left(ClientId),
    /// A request of a client.
    Asked {
        /// The client.
        client: ClientId,
        /// The request.
        request: Request,
        /// The answer.
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    },
    /// A packet of a raw program.
    Raw {
        /// The client.
        client: ClientId,
        /// The packet.
        packet: Packet,
        /// Whether it is sent.
        reply: oneshot::Sender<Result<(), Refusal>>,
    },
    /// A job that a client wants to start has been planned.
    Planned {
        /// The client.
        client: ClientId,
        /// The job.
        started: Box<StartedJob>,
        /// The answer.
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    },
    /// A program continues after an answer, or cannot.
    Answered {
        /// The longer job.
        longer: Result<Box<StartedJob>, Refusal>,
        /// The requester; none if the station itself has answered.
        reply: Option<oneshot::Sender<Result<Reply, Refusal>>>,
    },
    /// List all jobs: oldest first, unless queued ones were moved.
    Jobs(oneshot::Sender<Result<Vec<JobView>, Refusal>>),
    /// Replace the policy.
    Policy {
        /// The client.
        client: ClientId,
        /// The policy.
        policy: Box<Policy>,
        /// Whether it was accepted.
        reply: oneshot::Sender<Result<(), Refusal>>,
    },
    /// Return the path of a job.
    JobPath {
        /// The job number.
        job: u64,
        /// The answer.
        reply: oneshot::Sender<Result<JobPath, Refusal>>,
    },
    /// A request of another station about a job offer.
    Offer {
        /// The key of the offer.
        key: String,
        /// The request.
        ask: OfferRequest,
        /// The answer.
        reply: oneshot::Sender<Result<OfferAnswer, Refusal>>,
    },
    /// Stop the whole fleet from this station.
    FleetStop {
        /// The id of this station in its fleet.
        origin: String,
        /// Who stops it, and why.
        by: StoppedBy,
        /// The stop to send to the other stations, and how this arm stops.
        reply: oneshot::Sender<(FleetWideStop, Reply)>,
    },
    /// The fleet-wide stops known to another station.
    FleetStops {
        /// The stops.
        stops: Vec<FleetWideStop>,
        /// The stops known here, and how this arm stops if a stop holds it.
        reply: oneshot::Sender<(Vec<FleetWideStop>, Option<Reply>)>,
    },
    /// Reset all fleet-wide stops.
    FleetReset {
        /// Who resets them.
        by: String,
        /// The stops to send to the other stations.
        reply: oneshot::Sender<Vec<FleetWideStop>>,
    },
    /// Report a fault to observers, in one line.
    Trouble(String),
    /// Report a change of the buttons on the page, in one line.
    Buttons(String),
    /// End the station, because something that the arm depends on failed (in one line).
    Failed(String),
    /// End the station: laser off, and nothing more is sent.
    End,
}

/// A request of another station about a job offer with a key. The answer to an offer is final.
#[derive(Clone, Debug, PartialEq)]
pub enum OfferRequest {
    /// Queue the job, unless the arm has another unfinished one.
    Take {
        /// The job.
        job: Box<NewJob>,
        /// The calibration that its positions are meant for, unless it was planned for this arm.
        made_for: Option<Calibration>,
    },
    /// Refuse the offer: this station cannot take it, or not now.
    Refuse {
        /// The reason.
        reason: String,
        /// Whether it may be accepted later, when offered again.
        busy: bool,
    },
    /// Withdraw the offer: no job may result from it; one that exists is removed if it has not
    /// started.
    Withdraw {
        /// The name of the other station.
        by: String,
    },
    /// Return what has become of the offer.
    Look,
}

/// The answer to an offer.
#[derive(Clone, Debug, PartialEq)]
pub enum OfferAnswer {
    /// Accepted: the job in its current state.
    Taken(Box<JobView>),
    /// Refused: no job will result from it.
    Refused {
        /// The reason.
        reason: String,
        /// Whether it may be accepted later, when offered again.
        busy: bool,
    },
    /// No offer has this key.
    Unknown,
}

impl DriverChannels {
    /// Publishes a state.
    pub fn publish_state(&self, state: State) {
        let snapshot = Arc::new(Snapshot::new(state));
        self.states.send_replace(snapshot.clone());
        // There may be no observers.
        let _ = self.every.send(snapshot);
    }

    /// Changes the rules.
    pub fn change_rules(&self, change: impl FnOnce(&mut Rules)) {
        let mut shared = self.rules.write().unwrap_or_else(PoisonError::into_inner);
        change(Arc::make_mut(&mut shared));
    }

    /// Publishes a notice.
    pub fn publish_notice(&self, notice: Notice) {
        let notice = Arc::new(notice);
        let mut recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        if recent.len() == RECENT {
            recent.pop_front();
        }
        recent.push_back(notice.clone());
        drop(recent);
        // There may be no observers.
        let _ = self.notices.send(notice);
    }

    /// Passes a status packet on to raw programs.
    pub fn pass_on(&self, packet: [u8; 42]) {
        // There may be no raw program.
        let _ = self.packets.send(packet);
    }

    /// Publishes a packet that passed between the station and the arm.
    pub fn publish_packet(&self, packet: PassedPacket) {
        // Usually there is no subscriber; then it costs nothing.
        let _ = self.passed.send(packet);
    }
}

/// The maximum number of messages waiting for the driver.
const MESSAGES: usize = 1024;
/// The number of notices that a client may lag behind before it loses some.
const NOTICES: usize = 1024;
/// The number of packets that a raw program may lag behind before it loses some.
const PACKETS: usize = 256;
/// The number of packets in both directions that a subscriber may lag behind before it loses some.
const PASSED: usize = 1024;
/// The number of recent notices kept.
const RECENT: usize = 200;

impl StationHandle {
    /// The number of states that a client may lag behind before it loses some: at a thousand times
    /// real time there are 12,500 per second.
    pub const STATES: usize = 2048;

    /// Creates a handle and the driver's channels.
    #[must_use]
    pub fn new(first: State, rules: Rules) -> (Self, DriverChannels) {
        Self::with_packets(first, rules, PACKETS)
    }

    /// Creates a handle whose raw programs may lag this many packets behind before they lose some.
    #[must_use]
    pub fn with_packets(first: State, rules: Rules, kept: usize) -> (Self, DriverChannels) {
        let (asking, messages) = mpsc::channel(MESSAGES);
        let (sender, states) = watch::channel(Arc::new(Snapshot::new(first)));
        let handle = Self {
            messages: asking,
            states,
            every: broadcast::Sender::new(Self::STATES),
            notices: broadcast::Sender::new(NOTICES),
            recent: Arc::default(),
            packets: broadcast::Sender::new(kept),
            passed: broadcast::Sender::new(PASSED),
            rules: Arc::new(RwLock::new(Arc::new(rules))),
        };
        let channels = DriverChannels {
            messages,
            states: sender,
            every: handle.every.clone(),
            notices: handle.notices.clone(),
            recent: handle.recent.clone(),
            packets: handle.packets.clone(),
            rules: handle.rules.clone(),
            passed: handle.passed.clone(),
        };
        (handle, channels)
    }

    /// Connects a client with a name and a role.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn client(&self, name: &str, role: Role) -> Result<Client, Refusal> {
        self.client_of(name, role, name).await
    }

    /// Connects a client with a name, a role and the person it counts as for time slots.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn client_of(&self, name: &str, role: Role, person: &str) -> Result<Client, Refusal> {
        self.page_of(name, role, person, None).await
    }

    /// Connects a client as [`client_of`](Self::client_of) does, with the device of a page.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn page_of(
        &self,
        name: &str,
        role: Role,
        person: &str,
        device: Option<Device>,
    ) -> Result<Client, Refusal> {
        let (reply, answer) = oneshot::channel();
        let message = Message::Came {
            name: name.to_owned(),
            person: person.to_owned(),
            device,
            role,
            reply,
        };
        self.send(message).await?;
        let id = answer.await.map_err(|_| Refusal::Ending)?;
        Ok(Client {
            id,
            role,
            person: person.to_owned(),
            handle: self.clone(),
        })
    }

    /// Returns the current rules.
    #[must_use]
    pub fn rules(&self) -> Arc<Rules> {
        let rules = self.rules.read().unwrap_or_else(PoisonError::into_inner);
        rules.clone()
    }

    /// Returns the current state.
    #[must_use]
    pub fn state(&self) -> Arc<Snapshot> {
        self.states.borrow().clone()
    }

    /// Returns a receiver of the latest state, which changes with each status of the arm and each
    /// event. A slow receiver sees the newest one only.
    #[must_use]
    pub fn states(&self) -> watch::Receiver<Arc<Snapshot>> {
        self.states.clone()
    }

    /// Subscribes to every state.
    #[must_use]
    pub fn every_state(&self) -> broadcast::Receiver<Arc<Snapshot>> {
        self.every.subscribe()
    }

    /// Returns the recent notices, oldest first.
    #[must_use]
    pub fn recent(&self) -> Vec<Arc<Notice>> {
        let recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        recent.iter().cloned().collect()
    }

    /// Returns all jobs: oldest first, unless queued ones were moved.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`], [`Refusal::Journal`] if the journal cannot be read.
    pub async fn jobs(&self) -> Result<Vec<JobView>, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.send(Message::Jobs(reply)).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Returns the planned path of a job, once through its commands.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`], [`Refusal::Ending`], [`Refusal::Journal`] if the journal cannot be
    /// read.
    pub async fn job_path(&self, job: u64) -> Result<JobPath, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.send(Message::JobPath { job, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Handles another station's request about a job offer.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`], [`Refusal::Journal`]; then there is no answer, and the request may be
    /// repeated.
    pub async fn offer(&self, key: &str, ask: OfferRequest) -> Result<OfferAnswer, Refusal> {
        let (reply, answer) = oneshot::channel();
        let key = key.to_owned();
        self.send(Message::Offer { key, ask, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Stops this station's arm for a fleet-wide stop. Returns the stop to send to the other
    /// stations. `origin` is the id of this station in its fleet.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn stop_fleet(
        &self,
        origin: &str,
        by: StoppedBy,
    ) -> Result<(FleetWideStop, Reply), Refusal> {
        let (reply, answer) = oneshot::channel();
        let origin = origin.to_owned();
        self.send(Message::FleetStop { origin, by, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)
    }

    /// Adopts the fleet-wide stops that another station knows. Returns the stops known here, and
    /// how this arm stops if a stop holds it.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn adopt_fleet_stops(
        &self,
        stops: Vec<FleetWideStop>,
    ) -> Result<(Vec<FleetWideStop>, Option<Reply>), Refusal> {
        let (reply, answer) = oneshot::channel();
        self.send(Message::FleetStops { stops, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)
    }

    /// Resets the fleet-wide stops at this station. Returns the stops to send to the other
    /// stations.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn reset_fleet_stops(&self, by: &str) -> Result<Vec<FleetWideStop>, Refusal> {
        let (reply, answer) = oneshot::channel();
        let by = by.to_owned();
        self.send(Message::FleetReset { by, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)
    }

    /// Reports a fault to observers.
    pub async fn report_trouble(&self, text: String) {
        // Without a driver there are no observers.
        let _ = self.send(Message::Trouble(text)).await;
    }

    /// Reports a fault without waiting; it is dropped if the driver's queue is full.
    pub fn try_report_trouble(&self, text: String) {
        let _ = self.messages.try_send(Message::Trouble(text));
    }

    /// Reports a change of the buttons on the page, in one line.
    pub fn report_buttons(&self, text: String) {
        // If the queue is full, pages show the change when they read the buttons again.
        let _ = self.messages.try_send(Message::Buttons(text));
    }

    /// Subscribes to notices.
    #[must_use]
    pub fn notices(&self) -> broadcast::Receiver<Arc<Notice>> {
        self.notices.subscribe()
    }

    /// Subscribes to the status packets of the arm, for raw programs: each one is a permit.
    #[must_use]
    pub fn packets(&self) -> broadcast::Receiver<[u8; 42]> {
        self.packets.subscribe()
    }

    /// Subscribes to every packet between the station and the arm, in both directions.
    #[must_use]
    pub fn passed(&self) -> broadcast::Receiver<PassedPacket> {
        self.passed.subscribe()
    }

    /// Ends the station: the laser goes off, and the port is closed.
    pub async fn end(&self) {
        // It may have ended already.
        let _ = self.send(Message::End).await;
    }

    /// Waits until the station has ended.
    pub async fn ended(&self) {
        self.messages.closed().await;
    }

    async fn send(&self, message: Message) -> Result<(), Refusal> {
        let sent = self.messages.send(message).await;
        sent.map_err(|_| Refusal::Ending)
    }
}

impl Client {
    /// Returns the client's number.
    #[must_use]
    pub const fn id(&self) -> ClientId {
        self.id
    }

    /// Returns the client's role.
    #[must_use]
    pub const fn role(&self) -> Role {
        self.role
    }

    /// Returns the person it counts as for time slots.
    #[must_use]
    pub fn person(&self) -> &str {
        &self.person
    }

    /// Returns the handle of the station.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        &self.handle
    }

    /// Sends a request.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has changed.
    pub async fn request(&self, request: Request) -> Result<Reply, Refusal> {
        let answer = self.ask(request).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Sends a request without waiting for the answer, so that the next one can be sent before. No
    /// answer comes from a station that ends.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn ask(
        &self,
        request: Request,
    ) -> Result<oneshot::Receiver<Result<Reply, Refusal>>, Refusal> {
        let (reply, answer) = oneshot::channel();
        let client = self.id;
        self.handle
            .send(Message::Asked {
                client,
                request,
                reply,
            })
            .await?;
        Ok(answer)
    }

    /// Replaces the policy.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the old policy stays.
    pub async fn set_policy(&self, policy: Policy) -> Result<(), Refusal> {
        let (reply, answer) = oneshot::channel();
        let client = self.id;
        let policy = Box::new(policy);
        let message = Message::Policy {
            client,
            policy,
            reply,
        };
        self.handle.send(message).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Sends a packet of a raw program, which uses the arm's own protocol. The first one takes the
    /// lease if it is free.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the packet is not sent.
    pub async fn raw(&self, packet: Packet) -> Result<(), Refusal> {
        let (reply, answer) = oneshot::channel();
        let client = self.id;
        self.handle
            .send(Message::Raw {
                client,
                packet,
                reply,
            })
            .await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let (messages, left) = (self.handle.messages.clone(), Message::Left(self.id));
        if let Err(mpsc::error::TrySendError::Full(left)) = messages.try_send(left) {
            // The driver is busy, but must still be notified.
            if let Ok(runtime) = tokio::runtime::Handle::try_current() {
                runtime.spawn(async move { messages.send(left).await });
            }
        }
    }
}
