//! Joining a fleet: the tasks between Zenoh and the station.

use std::path::PathBuf;
use std::pin::Pin;
use std::time::{Duration, Instant};

use dobot_api::MemberAbout;
use dobot_rules::Handle;
use dobot_station::{FleetEnd, FleetPort, FleetWish, StationApi};
use tokio::sync::oneshot;
use tokio::task::{JoinHandle, JoinSet};
use tokio::time::{MissedTickBehavior, interval, timeout};
use zenoh::handlers::FifoChannelHandler;
use zenoh::liveliness::LivelinessToken;
use zenoh::pubsub::Subscriber;
use zenoh::query::{ConsolidationMode, Query, QueryTarget, Queryable};
use zenoh::sample::{Sample, SampleKind};
use zenoh::{Session, Wait};

use crate::asking::{self, Answering};
use crate::config::{FleetConfig, FleetConfigError};
use crate::keys::{ALL_ALIVE, API, Alive, MESSAGES, MemberKey, TOLD, of_all};
use crate::roster::{Roster, Told};
use crate::telling::{self, Pace};
use crate::work::Working;

/// A station's place in its fleet; it is left when this is dropped.
#[derive(Debug)]
pub struct Fleet {
    leave: oneshot::Sender<()>,
    joined: JoinHandle<()>,
}

/// Why a station cannot join.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FleetError {
    /// It is not set up for it.
    #[error(transparent)]
    Config(#[from] FleetConfigError),
    /// The work that was submitted cannot be read.
    #[error(
        "the work for the fleet in {folder} cannot be read: {source}; make room on the disk, or check the folder's permissions"
    )]
    Work {
        /// Where it is.
        folder: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// Zenoh cannot be started.
    #[error("the fleet cannot be joined: {0}")]
    Zenoh(String),
}

impl FleetError {
    pub(crate) fn zenoh(error: &zenoh::Error) -> Self {
        Self::Zenoh(error.to_string())
    }
}

/// So often it is looked whether there is something to tell the others, and whether anybody still looks at them.
const LOOK_EVERY: Duration = Duration::from_millis(100);
/// How long those may take who are asked what they are and do.
const TELL_WITHIN: Duration = Duration::from_secs(1);
/// How long the others are followed after the last one here has looked.
const FOLLOW_FOR: Duration = Duration::from_secs(10);

impl Fleet {
    /// Joins, for as long as this is kept. Routers that are away are waited for meanwhile.
    ///
    /// # Errors
    ///
    /// [`FleetError`]; the station is in no fleet then.
    pub async fn join(
        config: &FleetConfig,
        id: &str,
        api: &StationApi,
    ) -> Result<Self, FleetError> {
        let zenoh = config.zenoh()?;
        let work = open_work(config, api)?;
        let mut network = None;
        let own = MemberKey {
            name: config.name.clone(),
            id: id.into(),
        };
        let opening = Network::open(
            zenoh,
            own.clone(),
            config.about.clone(),
            api.handle().clone(),
        );
        let mut opening: Opening = Box::pin(opening);
        if config.connect.is_empty() {
            // It waits for nobody, and what is wrong with this machine is told at once.
            let opened = (&mut opening).await;
            network = Some(opened.map_err(|error| FleetError::zenoh(&error))?);
        }
        let (port, end) = FleetPort::new(&config.name);
        let port = port.taking(config.about.takes_work);
        let member = Joined::new(own, config.about.clone(), api, end, network, work);
        api.join(port);
        let (leave, leaving) = oneshot::channel();
        Ok(Self {
            leave,
            joined: tokio::spawn(member.run(opening, leaving)),
        })
    }

    /// Leaves: the others are told.
    pub async fn leave(self) {
        // One that has ended has left.
        let _ = self.leave.send(());
        let _ = self.joined.await;
    }
}

/// The work that was submitted before this start.
fn open_work(config: &FleetConfig, api: &StationApi) -> Result<Working, FleetError> {
    let opened = Working::open(config.work.as_deref());
    let (work, wrong) = opened.map_err(|source| FleetError::Work {
        folder: config.work.clone().unwrap_or_default(),
        source,
    })?;
    for file in wrong {
        let text = format!("{file}; this work for the fleet is left as it is");
        api.handle().tell_trouble(text);
    }
    Ok(work)
}

/// The network, while the router is waited for.
type Opening = Pin<Box<dyn Future<Output = Result<Network, zenoh::Error>> + Send>>;

/// The way to the others.
struct Network {
    session: Session,
    alive: Subscriber<FifoChannelHandler<Sample>>,
    asked: Queryable<FifoChannelHandler<Query>>,
    /// What the others tell, while somebody looks.
    others: Option<Others>,
    /// What says that it is there, and what it is and does, for as long as this is kept.
    _declared: (LivelinessToken, Queryable<()>),
}

/// A station that has joined.
struct Joined {
    api: StationApi,
    own: MemberKey,
    about: MemberAbout,
    end: FleetEnd,
    roster: Roster,
    /// Absent while the router is waited for.
    network: Option<Network>,
    /// The work that was submitted here for any arm.
    work: Working,
    pace: Pace,
    /// When it joined, and the station's clock then.
    since: (Instant, f64),
}

/// What the others tell.
struct Others {
    told: Subscriber<FifoChannelHandler<Sample>>,
    /// When somebody looked last.
    looked: Instant,
}

/// Opens a session. That blocks while a router is away, so it has a thread of its own.
async fn open(config: zenoh::Config) -> Result<Session, zenoh::Error> {
    let (opened, session) = oneshot::channel();
    let opens = move || {
        // Whoever waited may have left.
        drop(opened.send(zenoh::open(config).wait()));
    };
    std::thread::Builder::new()
        .name("fleet".into())
        .spawn(opens)?;
    session.await?
}

impl Network {
    /// Opens the way, as soon as there is one.
    async fn open(
        config: zenoh::Config,
        own: MemberKey,
        about: MemberAbout,
        handle: Handle,
    ) -> Result<Self, zenoh::Error> {
        let session = open(config).await?;
        let liveliness = session.liveliness();
        let alive = liveliness.declare_subscriber(ALL_ALIVE).history(true);
        let alive = alive.await?;
        let asked = session.declare_queryable(own.resource(API)).await?;
        let told = session.declare_queryable(own.resource(TOLD));
        let told = told
            .callback(answers(own.resource(TOLD), about, handle))
            .await?;
        let token = liveliness.declare_token(life(&own).key()).await?;
        Ok(Self {
            session,
            alive,
            asked,
            others: None,
            _declared: (token, told),
        })
    }

    /// What comes next.
    async fn next(&self) -> Incoming {
        tokio::select! {
            Ok(sample) = self.alive.recv_async() => Incoming::Life(sample),
            Ok(query) = self.asked.recv_async() => Incoming::Asked(query),
            Ok(sample) = told(self.others.as_ref()) => Incoming::Told(sample),
            else => std::future::pending().await,
        }
    }

    /// Follows what the others tell; says whether that has just begun.
    async fn follow(&mut self) -> bool {
        let looked = Instant::now();
        if let Some(others) = &mut self.others {
            others.looked = looked;
            return false;
        }
        let told = self.session.declare_subscriber(of_all(TOLD)).await;
        // Without a network there are no others.
        self.others = told.ok().map(|told| Others { told, looked });
        true
    }

    /// Asks all at once what they are and do, and waits until those have told who are there.
    async fn ask_all(&self) -> Vec<Sample> {
        let replies = self
            .session
            .get(of_all(TOLD))
            .target(QueryTarget::All)
            .consolidation(ConsolidationMode::None)
            .timeout(TELL_WITHIN)
            .await;
        let mut heard = Vec::new();
        if let Ok(replies) = replies {
            // One who does not answer is not waited for longer than that.
            let _ = timeout(TELL_WITHIN, async {
                while let Ok(reply) = replies.recv_async().await {
                    heard.extend(reply.into_result());
                }
            })
            .await;
        }
        heard
    }
}

/// What comes from the others.
enum Incoming {
    Life(Sample),
    Asked(Query),
    Told(Sample),
}

/// What comes next from a network that is there.
async fn incoming(network: Option<&Network>) -> Incoming {
    match network {
        Some(network) => network.next().await,
        None => std::future::pending().await,
    }
}

/// What the others tell next; never while nobody looks.
async fn told(others: Option<&Others>) -> Result<Sample, zenoh::Error> {
    match others {
        Some(others) => others.told.recv_async().await,
        None => std::future::pending().await,
    }
}

/// What says that a station is there.
fn life(own: &MemberKey) -> Alive {
    Alive {
        member: own.clone(),
        messages: MESSAGES,
        version: env!("CARGO_PKG_VERSION").into(),
    }
}

impl Joined {
    fn new(
        own: MemberKey,
        about: MemberAbout,
        api: &StationApi,
        end: FleetEnd,
        network: Option<Network>,
        work: Working,
    ) -> Self {
        let mut roster = Roster::new(own.clone());
        let at_s = api.handle().state().state().at_s;
        roster.came(life(&own), at_s);
        Self {
            api: api.clone(),
            own,
            about,
            end,
            roster,
            network,
            work,
            pace: Pace::default(),
            since: (Instant::now(), at_s),
        }
    }

    async fn run(mut self, mut opening: Opening, mut leaving: oneshot::Receiver<()>) {
        let answering = Answering::new(self.api.clone());
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
                            let trouble = format!("the fleet cannot be joined: {error}");
                            self.api.handle().tell_trouble(trouble);
                        }
                    }
                }
                came = incoming(self.network.as_ref()) => match came {
                    Incoming::Life(sample) => self.hear_of_life(&sample),
                    Incoming::Asked(query) => {
                        asking.spawn(answering.clone().answer(query));
                    }
                    Incoming::Told(sample) => self.hear(&sample),
                },
                Some(wish) = self.end.wishes.recv() => match wish {
                    FleetWish::Look(seen) => self.look(seen).await,
                    FleetWish::Ask(ask) => {
                        let session = self.network.as_ref().map(|it| it.session.clone());
                        let api = self.api.clone();
                        asking.spawn(async move { asking::ask(session.as_ref(), &api, ask).await });
                    }
                    FleetWish::Work(wish) => self.work.handle(wish),
                },
                Some(_) = asking.join_next() => {}
                Some(done) = self.work.doing.join_next() => {
                    if let Some(trouble) = self.work.settle(done) {
                        self.api.handle().tell_trouble(trouble);
                    }
                }
                _ = looks.tick() => {
                    self.tick();
                    self.follow().await;
                }
                _ = &mut leaving => break,
            }
            let session = self.network.as_ref().map(|it| &it.session);
            let members = self.roster.members();
            self.work.go_on(session, &self.api, &members);
        }
        if let Some(network) = self.network {
            // Those whom it does not reach miss this station by themselves.
            let _ = network.session.close().await;
        }
    }

    /// A station came or went.
    fn hear_of_life(&mut self, sample: &Sample) {
        let Some(alive) = Alive::of(sample.key_expr().as_str()) else {
            return;
        };
        let at_s = self.at_s();
        match sample.kind() {
            SampleKind::Put => {
                let was_full = self.roster.is_full();
                self.roster.came(alive, at_s);
                if self.roster.is_full() && !was_full {
                    let many = "the fleet has more stations than this one keeps in mind; some are not shown";
                    self.api.handle().tell_trouble(many.to_owned());
                }
            }
            SampleKind::Delete if alive.member == self.own => {}
            SampleKind::Delete => self.roster.went(&alive.member),
        }
        self.show();
    }

    /// A station tells of itself.
    fn hear(&mut self, sample: &Sample) {
        let Some(member) = MemberKey::of_resource(sample.key_expr().as_str(), TOLD) else {
            return;
        };
        match serde_json::from_slice::<Told>(&sample.payload().to_bytes()) {
            Ok(told) => self.roster.told(&member, told, self.at_s()),
            Err(error) => {
                tracing::info!(name = member.name, %error, "what a station tells is not understood");
            }
        }
    }

    /// Somebody here wants to know what the others are and do.
    async fn look(&mut self, seen: oneshot::Sender<()>) {
        let mut heard = Vec::new();
        if let Some(network) = &mut self.network
            && network.follow().await
        {
            heard = network.ask_all().await;
        }
        for sample in &heard {
            self.hear(sample);
        }
        let own = telling::told(&self.about, &self.api.handle().state());
        if let Ok(told) = serde_json::from_slice(&own) {
            self.roster.told(&self.own.clone(), told, self.at_s());
        }
        self.show();
        // Whoever wanted to know may be gone.
        let _ = seen.send(());
    }

    /// Follows the others while there is work for them: each tells of itself every second.
    async fn follow(&mut self) {
        if let Some(network) = self.network.as_mut().filter(|_| self.work.needs_members()) {
            // Without a network there are no others.
            network.follow().await;
        }
    }

    fn tick(&mut self) {
        let (joined, _) = self.since;
        let state = self.api.handle().state();
        let is_due = self.pace.is_due(joined.elapsed(), state.state());
        // One end is the port's own.
        let is_watched = self.end.members.receiver_count() > 1 || self.work.needs_members();
        if is_due {
            let own = telling::told(&self.about, &state);
            if is_watched && let Ok(told) = serde_json::from_slice(&own) {
                self.roster.told(&self.own.clone(), told, self.at_s());
            }
            if let Some(network) = &self.network
                && let Err(error) = network.session.put(self.own.resource(TOLD), own).wait()
            {
                tracing::info!(%error, "the fleet is not told");
            }
        }
        if is_watched {
            self.show();
        }
        let others = self.network.as_mut().map(|it| &mut it.others);
        match others {
            Some(Some(others)) if is_watched => others.looked = Instant::now(),
            Some(others) => {
                others.take_if(|it| it.looked.elapsed() > FOLLOW_FOR);
            }
            None => {}
        }
    }

    /// Shows the members to the station as they are now.
    fn show(&self) {
        let members = self.roster.members();
        self.end.members.send_if_modified(|shown| {
            let is_same = shown.len() == members.len()
                && shown
                    .iter()
                    .zip(&*members)
                    .all(|(one, other)| std::sync::Arc::ptr_eq(one, other));
            if !is_same {
                *shown = members;
            }
            !is_same
        });
    }

    /// The station's clock.
    fn at_s(&self) -> f64 {
        let (joined, at_s) = self.since;
        at_s + joined.elapsed().as_secs_f64()
    }
}

/// Tells those who ask what this station is and does.
fn answers(key: String, about: MemberAbout, handle: Handle) -> impl Fn(Query) + Send + Sync {
    move |query| {
        let told = telling::told(&about, &handle.state());
        if let Err(error) = query.reply(&key, told).wait() {
            tracing::info!(%error, "an answer to the fleet is lost");
        }
    }
}
