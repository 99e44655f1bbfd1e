//! How the rest of the station talks to the one who owns the arm.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError, RwLock};
use std::time::Duration;

use bytes::Bytes;
use dobot_api::{
    Calibrations, ClientId, FleetWideStop, JobPath, JobView, NewJob, Notice, Reply, Request, Role,
    State,
};
use dobot_arm::Calibration;
use dobot_safety::Policy;
use dobot_wire::Packet;
use tokio::sync::{broadcast, mpsc, oneshot, watch};

use dobot_supervisor::{Refusal, StartedJob, StoppedBy};

/// How the rest of the station talks to the task that owns the arm; clones share it.
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

/// The driver's side of all [`StationHandle`]s: receives their messages and publishes states, notices and packets.
#[derive(Debug)]
pub struct DriverChannels {
    /// What clients ask.
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
    /// When, since the station started.
    pub at: Duration,
    /// Whether it went to the arm; otherwise it is a status.
    pub to_arm: bool,
    /// The packet.
    pub bytes: [u8; 42],
    /// Below which height of the tool a pen draws then, in millimetres and the arm's own words; `None` where no job lifts
    /// one.
    pub pen_below_mm: Option<f64>,
}

/// What holds until the policy or the arm is changed.
#[derive(Clone, Debug)]
pub struct Rules {
    /// The policy.
    pub policy: Policy,
    /// How long a jog button stays pressed without being said again, in seconds.
    pub dead_man_s: f64,
    /// How the arm differs from the drawing of it.
    pub calibrations: Calibrations,
}

impl Rules {
    /// The rules of a policy.
    #[must_use]
    pub fn of(policy: &Policy) -> Self {
        Self {
            policy: policy.clone(),
            dead_man_s: policy.jog.dead_man_s,
            calibrations: Calibrations::default(),
        }
    }
}

/// A state, and its JSON, written once for all who watch.
#[derive(Debug)]
pub struct Snapshot {
    state: State,
    /// `{"state":...}`, as it goes out to those who watch, in UTF-8.
    message: Bytes,
}

impl Snapshot {
    /// Writes the JSON of a state.
    ///
    /// # Panics
    ///
    /// Never: a state is made of structures with text keys, which JSON can always hold.
    #[must_use]
    pub fn new(state: State) -> Self {
        let json = serde_json::to_string(&state).expect("structures with text keys are JSON");
        Self {
            state,
            message: format!("{BEFORE}{json}{AFTER}").into(),
        }
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// The state as JSON; a clone shares its bytes.
    #[must_use]
    pub fn json(&self) -> Bytes {
        let end = self.message.len() - AFTER.len();
        self.message.slice(BEFORE.len()..end)
    }

    /// The message to those who watch, `{"state":...}` in UTF-8; a clone shares its bytes.
    #[must_use]
    pub fn message(&self) -> Bytes {
        self.message.clone()
    }
}

const BEFORE: &str = "{\"state\":";
const AFTER: &str = "}";

/// A client of the station; it leaves when this is dropped, and its lease ends with it.
#[derive(Debug)]
pub struct Client {
    id: ClientId,
    role: Role,
    person: String,
    handle: StationHandle,
}

/// What reaches the driver.
#[derive(Debug)]
pub enum Message {
    /// A client came.
    Came {
        /// What it calls itself.
        name: String,
        /// By which name time slots know it.
        person: String,
        /// What it may do.
        role: Role,
        /// Its number.
        reply: oneshot::Sender<ClientId>,
    },
    /// A client left.
    Left(ClientId),
    /// A client asks for something.
    Asked {
        /// Who.
        client: ClientId,
        /// What for.
        request: Request,
        /// The answer.
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    },
    /// A raw program sent a packet.
    Raw {
        /// Who.
        client: ClientId,
        /// The packet.
        packet: Packet,
        /// Whether it is sent.
        reply: oneshot::Sender<Result<(), Refusal>>,
    },
    /// A job that a client wants to start has been planned.
    Planned {
        /// Who.
        client: ClientId,
        /// The job.
        started: Box<StartedJob>,
        /// The answer.
        reply: oneshot::Sender<Result<Reply, Refusal>>,
    },
    /// Somebody wants to know all jobs: the oldest first, unless queued ones were moved.
    Jobs(oneshot::Sender<Result<Vec<JobView>, Refusal>>),
    /// A client wants another policy to hold.
    Policy {
        /// Who.
        client: ClientId,
        /// The policy.
        policy: Box<Policy>,
        /// Whether it holds.
        reply: oneshot::Sender<Result<(), Refusal>>,
    },
    /// Somebody wants to know the way of a job.
    JobPath {
        /// Its number.
        job: u64,
        /// The answer.
        reply: oneshot::Sender<Result<JobPath, Refusal>>,
    },
    /// Another station offers a job, or asks what has become of its offer.
    Offer {
        /// Under which key.
        key: String,
        /// What it wants.
        ask: OfferAsk,
        /// The answer.
        reply: oneshot::Sender<Result<OfferAnswer, Refusal>>,
    },
    /// Somebody stops the whole fleet at this station.
    FleetStop {
        /// The number that this station goes by in its fleet.
        origin: String,
        /// Who, and why.
        by: StoppedBy,
        /// The stop, of which the others are to be told, and how this arm stops.
        reply: oneshot::Sender<(FleetWideStop, Reply)>,
    },
    /// Another station tells which stops of the fleet it knows of.
    FleetStops {
        /// The stops.
        stops: Vec<FleetWideStop>,
        /// Those that are known here now, and how this arm stops if a stop holds it.
        reply: oneshot::Sender<(Vec<FleetWideStop>, Option<Reply>)>,
    },
    /// Somebody lets the whole fleet move again.
    FleetReset {
        /// Who.
        by: String,
        /// The stops, of which the others are to be told.
        reply: oneshot::Sender<Vec<FleetWideStop>>,
    },
    /// A client behaves badly, in one line: those who watch are to know.
    Trouble(String),
    /// Something that the arm depends on failed, in one line: end, and say so.
    Failed(String),
    /// End: laser off, and no more.
    End,
}

/// What another station wants, which offers a job under a key. What is answered to an offer holds for good.
#[derive(Clone, Debug, PartialEq)]
pub enum OfferAsk {
    /// That the job is queued, if the arm has no other that is not over.
    Take {
        /// The job.
        job: Box<NewJob>,
        /// The calibration of the arm that its places are meant for, where it was not planned for this one.
        made_for: Option<Calibration>,
    },
    /// That it is refused: this station cannot do it, or not now.
    Refuse {
        /// Why.
        reason: String,
        /// Whether it may be taken later, when it is offered anew.
        busy: bool,
    },
    /// That no job comes of it, and that the one that has come of it ends if it has not begun.
    Withdraw {
        /// What the other station is called.
        by: String,
    },
    /// To know what has become of it.
    Look,
}

/// What is answered to an offer.
#[derive(Clone, Debug, PartialEq)]
pub enum OfferAnswer {
    /// It was taken: the job as it is now.
    Taken(Box<JobView>),
    /// It was refused: no job comes of it any more.
    Refused {
        /// Why.
        reason: String,
        /// Whether it may be taken later, when it is offered anew.
        busy: bool,
    },
    /// Nothing was offered under this key.
    Unknown,
}

impl DriverChannels {
    /// Tells a new state.
    pub fn publish_state(&self, state: State) {
        let snapshot = Arc::new(Snapshot::new(state));
        self.states.send_replace(snapshot.clone());
        // Nobody may be watching.
        let _ = self.every.send(snapshot);
    }

    /// Changes what holds.
    pub fn change_rules(&self, change: impl FnOnce(&mut Rules)) {
        let mut shared = self.rules.write().unwrap_or_else(PoisonError::into_inner);
        change(Arc::make_mut(&mut shared));
    }

    /// Tells what happened.
    pub fn publish_notice(&self, notice: Notice) {
        let notice = Arc::new(notice);
        let mut recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        if recent.len() == RECENT {
            recent.pop_front();
        }
        recent.push_back(notice.clone());
        drop(recent);
        // Nobody may be watching.
        let _ = self.notices.send(notice);
    }

    /// Passes on a status packet of the arm to raw programs.
    pub fn pass_on(&self, packet: [u8; 42]) {
        // There may be no raw program.
        let _ = self.packets.send(packet);
    }

    /// Tells that a packet has passed between the station and the arm.
    pub fn publish_packet(&self, packet: PassedPacket) {
        // Mostly nobody listens; then it costs nothing.
        let _ = self.passed.send(packet);
    }
}

/// How many messages may wait for the driver.
const MESSAGES: usize = 1024;
/// How many notices a client may lag behind before it loses some.
const NOTICES: usize = 1024;
/// How many packets a raw program may lag behind before it loses some.
const PACKETS: usize = 256;
/// How many packets both ways one who listens may lag behind before he loses some.
const PASSED: usize = 1024;
/// How many notices are kept for those who ask later.
const RECENT: usize = 200;

impl StationHandle {
    /// How many states a client may lag behind before it loses some: at a thousand times the speed of time 12,500 come
    /// in a second.
    pub const STATES: usize = 2048;

    /// A handle, and its other end for the driver of the arm.
    #[must_use]
    pub fn new(first: State, rules: Rules) -> (Self, DriverChannels) {
        Self::with_packets(first, rules, PACKETS)
    }

    /// The same, where a raw program may lag so many packets behind before it loses some.
    #[must_use]
    pub fn with_packets(first: State, rules: Rules, kept: usize) -> (Self, DriverChannels) {
        let (asking, messages) = mpsc::channel(MESSAGES);
        let (telling, states) = watch::channel(Arc::new(Snapshot::new(first)));
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
            states: telling,
            every: handle.every.clone(),
            notices: handle.notices.clone(),
            recent: handle.recent.clone(),
            packets: handle.packets.clone(),
            rules: handle.rules.clone(),
            passed: handle.passed.clone(),
        };
        (handle, channels)
    }

    /// Makes a client known under a name, with what it may do.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn client(&self, name: &str, role: Role) -> Result<Client, Refusal> {
        self.client_of(name, role, name).await
    }

    /// Makes a client known under a name, with what it may do, and by which name time slots know it.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`].
    pub async fn client_of(&self, name: &str, role: Role, person: &str) -> Result<Client, Refusal> {
        let (reply, answer) = oneshot::channel();
        let came = Message::Came {
            name: name.to_owned(),
            person: person.to_owned(),
            role,
            reply,
        };
        self.send(came).await?;
        let id = answer.await.map_err(|_| Refusal::Ending)?;
        Ok(Client {
            id,
            role,
            person: person.to_owned(),
            handle: self.clone(),
        })
    }

    /// What holds until the policy is changed.
    #[must_use]
    pub fn rules(&self) -> Arc<Rules> {
        let rules = self.rules.read().unwrap_or_else(PoisonError::into_inner);
        rules.clone()
    }

    /// What the station knows now.
    #[must_use]
    pub fn state(&self) -> Arc<Snapshot> {
        self.states.borrow().clone()
    }

    /// The state, whenever it changes: with each status of the arm, and with each event. Who looks
    /// late sees the newest one only.
    #[must_use]
    pub fn states(&self) -> watch::Receiver<Arc<Snapshot>> {
        self.states.clone()
    }

    /// Every single state from now on.
    #[must_use]
    pub fn every_state(&self) -> broadcast::Receiver<Arc<Snapshot>> {
        self.every.subscribe()
    }

    /// What happened lately, the oldest first.
    #[must_use]
    pub fn recent(&self) -> Vec<Arc<Notice>> {
        let recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        recent.iter().cloned().collect()
    }

    /// All jobs: the oldest first, unless queued ones were moved.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`], [`Refusal::Journal`] where the journal cannot be read.
    pub async fn jobs(&self) -> Result<Vec<JobView>, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.send(Message::Jobs(reply)).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// The way of a job, once through its commands, as it was planned.
    ///
    /// # Errors
    ///
    /// [`Refusal::NoSuchJob`], [`Refusal::Ending`], [`Refusal::Journal`] where the journal cannot be read.
    pub async fn job_path(&self, job: u64) -> Result<JobPath, Refusal> {
        let (reply, answer) = oneshot::channel();
        self.send(Message::JobPath { job, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Another station offers a job under a key, or asks what has become of its offer.
    ///
    /// # Errors
    ///
    /// [`Refusal::Ending`], [`Refusal::Journal`]; then nothing is answered, and it can be asked again.
    pub async fn offer(&self, key: &str, ask: OfferAsk) -> Result<OfferAnswer, Refusal> {
        let (reply, answer) = oneshot::channel();
        let key = key.to_owned();
        self.send(Message::Offer { key, ask, reply }).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Stops the whole fleet, as far as this station does that: its own arm. The others are to be told of the stop that is
    /// returned. `origin` is the number that this station goes by in its fleet.
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

    /// Takes which stops of the fleet another station knows of. Gives those that are known here then, and how this arm stops
    /// where a stop holds it.
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

    /// Lets the whole fleet move again, as far as this station does that. The others are to be told of the stops that are
    /// returned.
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

    /// Lets those who watch know that a client behaves badly.
    pub async fn report_trouble(&self, text: String) {
        // Without a driver nobody is there to know.
        let _ = self.send(Message::Trouble(text)).await;
    }

    /// The same, at once; where very much waits for the driver already, this is left out.
    pub fn try_report_trouble(&self, text: String) {
        let _ = self.messages.try_send(Message::Trouble(text));
    }

    /// What happens, from now on.
    #[must_use]
    pub fn notices(&self) -> broadcast::Receiver<Arc<Notice>> {
        self.notices.subscribe()
    }

    /// The status packets of the arm, from now on, for raw programs: each one is a permit.
    #[must_use]
    pub fn packets(&self) -> broadcast::Receiver<[u8; 42]> {
        self.packets.subscribe()
    }

    /// Every packet between the station and the arm, both ways, from now on.
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
    /// Its number.
    #[must_use]
    pub const fn id(&self) -> ClientId {
        self.id
    }

    /// What it may do.
    #[must_use]
    pub const fn role(&self) -> Role {
        self.role
    }

    /// By which name time slots know it.
    #[must_use]
    pub fn person(&self) -> &str {
        &self.person
    }

    /// The station.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        &self.handle
    }

    /// Asks for something.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has changed then.
    pub async fn request(&self, request: Request) -> Result<Reply, Refusal> {
        let answer = self.ask(request).await?;
        answer.await.map_err(|_| Refusal::Ending)?
    }

    /// Hands over a request; its answer comes later, and the next one may be handed over before. It never comes from a station that ends.
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

    /// Puts another policy in place of the one that holds.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the old one holds on then.
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

    /// Passes on a packet of a raw program, which speaks the arm's own protocol. The first one
    /// takes the lease if nobody has it.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the packet is not sent then.
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
            // The driver has much to do; it must hear of this all the same.
            if let Ok(runtime) = tokio::runtime::Handle::try_current() {
                runtime.spawn(async move { messages.send(left).await });
            }
        }
    }
}
