//! The tasks that connect Zenoh and the station.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use dobot_api::{ApiAnswer, Member, MemberAbout, MemberAnswer};
use dobot_host::StationHandle;
use dobot_station::{FleetChannels, FleetCommand, FleetPort, StationApi, UNSETTLED};
use tokio::sync::oneshot;
use tokio::task::{JoinHandle, JoinSet};
use tokio::time::{MissedTickBehavior, interval};
use zenoh::query::Query;
use zenoh::sample::{Sample, SampleKind};

use crate::CredentialsError;
use crate::config::{FleetConfig, FleetConfigError};
use crate::identity::Identity;
use crate::key_expressions::{Alive, MESSAGES, MemberKey, STATE};
use crate::network::{Incoming, Network, Opening, ask_all, incoming};
use crate::publisher::{self, Pace};
use crate::requests::{self, Requester, Responder};
use crate::roster::Roster;
use crate::session::FleetSession;
use crate::stops::{self, StopExchange};
use crate::work::WorkTasks;

/// A station's membership in a fleet; the station leaves when this is dropped.
#[derive(Debug)]
pub struct Fleet {
    leave: oneshot::Sender<()>,
    joined: JoinHandle<()>,
}

/// The error returned when a station cannot join.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FleetError {
    /// The configuration is invalid.
    #[error(transparent)]
    Config(#[from] FleetConfigError),
    /// The credentials cannot be used.
    #[error(transparent)]
    Credentials(#[from] CredentialsError),
    /// The submitted jobs cannot be read.
    #[error(
        "the submitted jobs in {folder} cannot be read: {source}; free disk space, or check the folder's permissions"
    )]
    Work {
        /// Their folder.
        folder: PathBuf,
        /// The cause.
        source: std::io::Error,
    },
    /// Zenoh cannot be started.
    #[error("cannot join the fleet: {0}")]
    Zenoh(String),
}

impl FleetError {
    pub(crate) fn zenoh(error: &zenoh::Error) -> Self {
        Self::Zenoh(error.to_string())
    }
}

/// The maximum number of arrivals and departures that are handled in a row.
const LIVES_AT_ONCE: usize = 256;
/// The interval at which the state is published, and at which it is checked whether anybody watches
/// the members.
const LOOK_EVERY: Duration = Duration::from_millis(100);
impl Fleet {
    /// Joins through a session, for as long as this is kept. Continues in the background while a
    /// router is unreachable.
    ///
    /// # Errors
    ///
    /// [`FleetError`]; the station is then in no fleet.
    pub async fn join(
        session: &FleetSession,
        config: &FleetConfig,
        id: &str,
        api: &StationApi,
    ) -> Result<Self, FleetError> {
        let identity = session.identity();
        config.check(&identity.own().name)?;
        let work = open_work(config, api)?;
        let mut network = None;
        let own = MemberKey {
            name: config.name.clone(),
            id: id.into(),
        };
        let alive = Alive::signed(&own, identity, now_ms());
        let mut roster = Roster::new(own.clone());
        let at_s = api.handle().state().state().at_s;
        roster.handle_arrival(alive.clone(), Some(identity.own().clone()), at_s);
        let opening = Network::open(session.clone(), alive, roster.peers().clone());
        let mut opening: Opening = Box::pin(opening);
        if session.is_open() {
            // Errors of this machine are reported immediately.
            network = Some((&mut opening).await?);
        }
        let (port, end) = FleetPort::new(&config.name, id);
        let port = port
            .taking(config.about.takes_work)
            .on_one_machine(session.is_on_one_machine());
        end.is_settled.send_replace(false);
        let member = Joined {
            api: api.clone(),
            stops: StopExchange::new(own.clone(), Duration::ZERO, SystemTime::now()),
            stop_exchanges: JoinSet::new(),
            own,
            identity: identity.clone(),
            about: config.about.clone(),
            end,
            roster,
            network,
            work,
            state_queries: JoinSet::new(),
            waiting: Vec::new(),
            pace: Pace::default(),
            since: (Instant::now(), at_s),
        };
        api.join(port);
        let (leave, leaving) = oneshot::channel();
        Ok(Self {
            leave,
            joined: tokio::spawn(member.run(opening, leaving)),
        })
    }

    /// Leaves, and notifies the other members.
    pub async fn leave(self) {
        // The task may have ended already.
        let _ = self.leave.send(());
        let _ = self.joined.await;
    }
}

/// The start of the membership, in milliseconds since 1970.
fn now_ms() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |elapsed| {
        u64::try_from(elapsed.as_millis()).unwrap_or(u64::MAX)
    })
}

/// Opens the jobs that were submitted before this start.
fn open_work(config: &FleetConfig, api: &StationApi) -> Result<WorkTasks, FleetError> {
    let opened = WorkTasks::open(config.work.as_deref());
    let (work, wrong) = opened.map_err(|source| FleetError::Work {
        folder: config.work.clone().unwrap_or_default(),
        source,
    })?;
    for file in wrong {
        let text = format!("{file}; this submitted job is ignored");
        api.handle().try_report_trouble(text);
    }
    Ok(work)
}

/// A station that has joined.
struct Joined {
    api: StationApi,
    own: MemberKey,
    identity: Arc<Identity>,
    about: MemberAbout,
    end: FleetChannels,
    roster: Roster,
    /// Absent until the router is connected.
    network: Option<Network>,
    /// The jobs that were submitted here for any arm.
    work: WorkTasks,
    /// The members to which the fleet's stops have to be sent, and when.
    stops: StopExchange,
    /// In-flight exchanges of stops; each returns the members that did not answer.
    stop_exchanges: JoinSet<Vec<MemberKey>>,
    /// In-flight state queries to all members.
    state_queries: JoinSet<Vec<Sample>>,
    /// The callers that wait for these responses.
    waiting: Vec<oneshot::Sender<()>>,
    pace: Pace,
    /// When the station joined, by the system's and by its own clock.
    since: (Instant, f64),
}

impl Joined {
    async fn run(mut self, mut opening: Opening, mut leaving: oneshot::Receiver<()>) {
        let responder = Responder::new(self.api.clone(), self.own.clone(), self.identity.clone());
        let mut asking = JoinSet::new();
        let mut looks = interval(LOOK_EVERY);
        looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let mut opens = self.network.is_none();
        self.show();
        loop {
            tokio::select! {
                opened = &mut opening, if opens => {
                    opens = false;
                    match opened {
                        Ok(network) => self.network = Some(network),
                        Err(error) => {
                            self.api.handle().try_report_trouble(error.to_string());
                        }
                    }
                }
                message = incoming(self.network.as_mut()) => {
                    self.handle_incoming(message, &responder, &mut asking);
                }
                Some(wish) = self.end.wishes.recv() => match wish {
                    FleetCommand::Look(seen) => self.look(seen).await,
                    FleetCommand::Ask(ask) => {
                        let requester = self.network.as_ref().map(|network| network.requester().clone());
                        let api = self.api.clone();
                        asking.spawn(async move { requests::ask(requester.as_ref(), &api, ask).await });
                    }
                    FleetCommand::SendStops(to, answers) => self.send_stops(to, answers),
                    FleetCommand::Work(wish) => self.work.handle(wish),
                },
                Some(_) = asking.join_next() => {}
                Some(silent) = self.stop_exchanges.join_next() => {
                    // The task does not panic.
                    for member in silent.unwrap_or_default() {
                        self.stops.handle_silent(&member, self.since.0.elapsed());
                    }
                }
                Some(samples) = self.state_queries.join_next() => {
                    // The task does not panic.
                    for sample in &samples.unwrap_or_default() {
                        self.handle_state(sample);
                    }
                    self.show_to_all();
                }
                Some(done) = self.work.doing.join_next() => {
                    if let Some(trouble) = self.work.settle(done) {
                        self.api.handle().try_report_trouble(trouble);
                    }
                }
                _ = looks.tick() => {
                    self.tick();
                    self.follow().await;
                }
                _ = &mut leaving => break,
            }
            self.exchange_due_stops();
            let held = self.held();
            let requester = self.network.as_ref().map(Network::requester);
            let members = || self.roster.members();
            self.work.start_due(requester, &self.api, members, held);
        }
        if let Some(network) = self.network {
            network.leave().await;
        }
    }

    fn handle_incoming(
        &mut self,
        incoming: Incoming,
        responder: &Responder,
        asking: &mut JoinSet<()>,
    ) {
        match incoming {
            Incoming::Life(sample) => self.handle_presence(&sample),
            Incoming::Asked(query) => {
                asking.spawn(responder.clone().answer(query));
            }
            Incoming::Sealed(query) => {
                asking.spawn(responder.clone().answer_sealed(query));
            }
            Incoming::Stops(query) => {
                let handle = self.api.handle().clone();
                asking.spawn(stops::answer(handle, responder.clone(), query));
            }
            Incoming::About(query) => self.answer_about(query, asking),
            Incoming::State(sample) => self.handle_state(&sample),
        }
    }

    fn answer_about(&self, query: Query, asking: &mut JoinSet<()>) {
        if let Some(network) = &self.network {
            let message = publisher::state_message(&self.about, &self.api.handle().state());
            asking.spawn(network.answer_about(query, message));
        }
    }

    /// Handles an arrival or a departure, and those queued behind it: many come together when this
    /// station joins or a router returns.
    fn handle_presence(&mut self, sample: &Sample) {
        self.handle_life(sample);
        for _ in 0..LIVES_AT_ONCE {
            let Some(more) = self.network.as_mut().and_then(Network::poll_life) else {
                break;
            };
            self.handle_life(&more);
        }
        self.show();
    }

    /// Handles an arrival or a departure.
    fn handle_life(&mut self, sample: &Sample) {
        let Some(alive) = Alive::of(sample.key_expr().as_str()) else {
            return;
        };
        match sample.kind() {
            SampleKind::Put => self.handle_arrival(alive),
            SampleKind::Delete if alive.member == self.own => {}
            SampleKind::Delete => {
                self.stops.handle_departure(&alive.member);
                self.roster.handle_departure(&alive);
            }
        }
    }

    fn handle_arrival(&mut self, alive: Alive) {
        let peer = match alive.signer(&self.identity) {
            Ok(peer) => Some(Arc::new(peer)),
            Err(_) if alive.messages != MESSAGES => None,
            Err(why) => {
                let name = alive.member.name;
                tracing::info!(
                    name,
                    why,
                    "ignored a station without a certificate of the fleet"
                );
                return;
            }
        };
        if alive.messages == MESSAGES {
            self.stops
                .handle_arrival(&alive.member, self.since.0.elapsed());
        }
        let (at_s, was_full) = (self.at_s(), self.roster.is_full());
        self.roster.handle_arrival(alive, peer, at_s);
        if self.roster.is_full() && !was_full {
            let many = "the fleet has more stations than this one can track; some are not shown";
            self.api.handle().try_report_trouble(many.to_owned());
        }
    }

    /// Sends the stops of the fleet to the members that joined or returned.
    fn exchange_due_stops(&mut self) {
        let now = self.since.0.elapsed();
        self.stops.handle_time(now, SystemTime::now());
        let is_settled = self.stops.is_settled(now);
        self.end.is_settled.send_if_modified(|settled| {
            let was_settled = std::mem::replace(settled, is_settled);
            was_settled != is_settled
        });
        while let Some(member) = self.stops.poll_due(now) {
            let (requester, handle) = self.requester_and_station();
            self.stop_exchanges.spawn(async move {
                let answer = stops::exchange(requester.as_ref(), &handle, &member).await;
                Some(member)
                    .filter(|_| !answer.is_success())
                    .into_iter()
                    .collect()
            });
        }
    }

    /// Sends the stops of the fleet to these members immediately.
    fn send_stops(&mut self, to: Vec<Arc<Member>>, answers: oneshot::Sender<Vec<MemberAnswer>>) {
        let mut exchanges = JoinSet::new();
        for member in to {
            let (requester, handle) = self.requester_and_station();
            exchanges.spawn(async move {
                let began = Instant::now();
                let key = MemberKey {
                    name: member.name.clone(),
                    id: member.id.clone(),
                };
                let answer = if member.here {
                    ApiAnswer {
                        status: 200,
                        body: serde_json::json!({}),
                    }
                } else {
                    stops::exchange(requester.as_ref(), &handle, &key).await
                };
                let answer = MemberAnswer {
                    member: key.name.clone(),
                    id: key.id.clone(),
                    answer,
                    took_ms: began.elapsed().as_secs_f64() * 1e3,
                };
                (key, answer)
            });
        }
        self.stop_exchanges.spawn(async move {
            let mut answered = exchanges.join_all().await;
            answered.sort_by(|one, other| one.0.cmp(&other.0));
            let silent = answered.iter().filter(|entry| !entry.1.answer.is_success());
            let silent = silent.map(|entry| entry.0.clone()).collect();
            // The requester may be gone.
            drop(answers.send(answered.into_iter().map(|entry| entry.1).collect()));
            silent
        });
    }

    fn requester_and_station(&self) -> (Option<Requester>, StationHandle) {
        let requester = self.network.as_ref().map(Network::requester).cloned();
        (requester, self.api.handle().clone())
    }

    /// Returns the reason why no job is offered from here at present.
    fn held(&self) -> Option<String> {
        if !self.stops.is_settled(self.since.0.elapsed()) {
            return Some(UNSETTLED.to_owned());
        }
        let snapshot = self.api.handle().state();
        let state = snapshot.state();
        if let Some(stop) = state
            .fleet_stops
            .iter()
            .find(|fleet_stop| fleet_stop.holds())
        {
            return Some(format!(
                "{}; `dobot fleet stop --reset` releases the fleet",
                stop.text()
            ));
        }
        let stop = state.stop.as_ref();
        stop.map(|stop| format!("the arm of this station is {}", stop.text()))
    }

    /// Handles a published state.
    fn handle_state(&mut self, sample: &Sample) {
        let Some(member) = MemberKey::of_resource(sample.key_expr().as_str(), STATE) else {
            return;
        };
        let signature = sample.attachment().map(|attachment| attachment.to_bytes());
        let (report, signature) = (sample.payload().to_bytes(), signature.unwrap_or_default());
        let at_s = self.at_s();
        if let Err(why) = self.roster.handle_state(&member, &report, &signature, at_s) {
            let name = member.name;
            tracing::info!(name, why, "ignored the published state of a station");
        }
    }

    /// Queries the state of all members for a caller. Does not delay stops.
    async fn look(&mut self, seen: oneshot::Sender<()>) {
        self.waiting.push(seen);
        if let Some(network) = &mut self.network
            && network.follow().await
        {
            self.state_queries
                .spawn(ask_all(network.requester().session.clone()));
        }
        if self.state_queries.is_empty() {
            self.show_to_all();
        }
    }

    /// Publishes the members to the waiting callers.
    fn show_to_all(&mut self) {
        let own = publisher::state_message(&self.about, &self.api.handle().state());
        if let Ok(report) = serde_json::from_slice(&own) {
            self.roster.store(&self.own.clone(), report, self.at_s());
        }
        self.show();
        for seen in self.waiting.drain(..) {
            // The caller may be gone.
            let _ = seen.send(());
        }
    }

    /// Subscribes to the members' states while there are jobs for them: each publishes its state
    /// every second.
    async fn follow(&mut self) {
        if let Some(network) = self.network.as_mut().filter(|_| self.work.needs_members()) {
            // Without a network there are no other members.
            network.follow().await;
        }
    }

    fn tick(&mut self) {
        self.roster
            .forget_strangers(|peer| self.identity.check(peer).is_ok());
        let (joined, _) = self.since;
        let state = self.api.handle().state();
        let is_due = self.pace.is_due(joined.elapsed(), state.state());
        // One receiver is the port's own.
        let is_watched = self.end.members.receiver_count() > 1 || self.work.needs_members();
        let network = self.network.as_ref().filter(|_| is_due);
        let network = network.filter(|network| network.is_followed());
        if is_due && (is_watched || network.is_some()) {
            let own = publisher::state_message(&self.about, &state);
            if is_watched && let Ok(report) = serde_json::from_slice(&own) {
                self.roster.store(&self.own.clone(), report, self.at_s());
            }
            if let Some(network) = network {
                network.publish(own);
            }
        }
        if is_watched {
            self.show();
        }
        if let Some(network) = &mut self.network {
            network.follow_on(is_watched);
        }
    }

    /// Publishes the current members to the station.
    fn show(&mut self) {
        let members = self.roster.members();
        self.end.members.send_if_modified(|shown| {
            let is_same = Arc::ptr_eq(shown, &members);
            *shown = members;
            !is_same
        });
    }

    /// Returns the station's clock.
    fn at_s(&self) -> f64 {
        let (joined, at_s) = self.since;
        at_s + joined.elapsed().as_secs_f64()
    }
}
