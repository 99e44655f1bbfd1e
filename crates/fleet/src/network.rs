//! The way to the others: Zenoh, and what it carries for one station.

use std::pin::Pin;
use std::time::{Duration, Instant};

use tokio::sync::mpsc;
use tokio::time::timeout;
use zenoh::handlers::{RingChannel, RingChannelHandler};
use zenoh::liveliness::LivelinessToken;
use zenoh::pubsub::{Publisher, Subscriber};
use zenoh::query::{ConsolidationMode, Query, QueryTarget, Queryable};
use zenoh::sample::Sample;
use zenoh::{Session, Wait};

use crate::FleetError;
use crate::asking::{self, Peers, Way};
use crate::keys::{ALL_ALIVE, API, Alive, SEALED, STOPS, TOLD, of_all};
use crate::session::FleetSession;
use crate::telling::Teller;

/// The way to the others.
pub(crate) struct Network {
    way: Way,
    /// Who came and went. Nobody waits for this station to hear it: others of this program may join by the same session.
    lives: mpsc::UnboundedReceiver<Sample>,
    /// Requests to stop, and stops of the fleet: they wait behind nothing else.
    urgent: mpsc::Receiver<Incoming>,
    /// All other requests.
    requests: mpsc::Receiver<Incoming>,
    /// What the others tell, while somebody looks.
    others: Option<Others>,
    /// What this station tells.
    telling: Publisher<'static>,
    teller: Teller,
    /// What says that it is there, and what it is and does, for as long as this is kept.
    declared: (LivelinessToken, [Queryable<()>; 4], Subscriber<()>),
}

/// The network, while the router is waited for.
pub(crate) type Opening = Pin<Box<dyn Future<Output = Result<Network, FleetError>> + Send>>;

/// What comes from the others.
pub(crate) enum Incoming {
    Life(Sample),
    Asked(Query),
    Sealed(Query),
    Stops(Query),
    /// Somebody asks what this station is and does.
    About(Query),
    Told(Sample),
}

/// How long those may take who are asked what they are and do.
const TELL_WITHIN: Duration = Duration::from_secs(1);
/// How long the others are followed after the last one here has looked.
const FOLLOW_FOR: Duration = Duration::from_secs(10);
/// So much of what the others tell waits for this station; of more the oldest is dropped, since each tells it anew every second.
const TOLD_AT_ONCE: usize = 4096;
/// How many requests wait for this station; more are left without an answer.
const REQUESTS_AT_ONCE: usize = 256;

impl Network {
    /// Opens the way, as soon as there is one. `peers` are those who are known to be asked.
    pub(crate) async fn open(
        mut session: FleetSession,
        alive: Alive,
        peers: Peers,
    ) -> Result<Self, FleetError> {
        let way = Way {
            session: session.opened().await?,
            identity: session.identity().clone(),
            peers,
        };
        let declared = Self::declare(way, alive).await;
        declared.map_err(|error| FleetError::zenoh(&error))
    }

    async fn declare(way: Way, alive: Alive) -> Result<Self, zenoh::Error> {
        let (session, own) = (&way.session, &alive.member);
        let teller = Teller::new(way.identity.clone(), own.clone(), alive.run);
        let (tells, lives) = mpsc::unbounded_channel();
        let liveliness = session.liveliness();
        let others = liveliness.declare_subscriber(ALL_ALIVE).history(true);
        // One that has left hears nothing more.
        let others = others.callback(move |it| drop(tells.send(it))).await?;
        let (to_urgent, urgent) = mpsc::channel(REQUESTS_AT_ONCE);
        let (to_requests, requests) = mpsc::channel(REQUESTS_AT_ONCE);
        // Never waits: a callback that waits keeps its link from receiving, a stop too, and a peer closes a link that takes
        // nothing for some seconds.
        let queue = async |what, put: fn(Query) -> Incoming| {
            let (to_urgent, to_requests) = (to_urgent.clone(), to_requests.clone());
            let queryable = session.declare_queryable(own.resource(what));
            let queryable = queryable.callback(move |query| {
                let is_urgent = what == STOPS || (what == API && asking::asks_to_stop(&query));
                let queue = if is_urgent { &to_urgent } else { &to_requests };
                if queue.try_send(put(query)).is_err() {
                    tracing::info!(what, "a request of the fleet is dropped: too many wait");
                }
            });
            queryable.await
        };
        let queryables = [
            queue(API, Incoming::Asked).await?,
            queue(SEALED, Incoming::Sealed).await?,
            queue(STOPS, Incoming::Stops).await?,
            queue(TOLD, Incoming::About).await?,
        ];
        let telling = session.declare_publisher(own.resource(TOLD)).await?;
        let token = liveliness.declare_token(alive.key()).await?;
        Ok(Self {
            way,
            lives,
            urgent,
            requests,
            others: None,
            telling,
            teller,
            declared: (token, queryables, others),
        })
    }

    /// By which others are asked.
    pub(crate) const fn way(&self) -> &Way {
        &self.way
    }

    /// What comes next.
    async fn next(&mut self) -> Incoming {
        tokio::select! {
            Some(request) = self.urgent.recv() => request,
            Some(sample) = self.lives.recv() => Incoming::Life(sample),
            Some(request) = self.requests.recv() => request,
            Ok(sample) = told(self.others.as_ref()) => Incoming::Told(sample),
            else => std::future::pending().await,
        }
    }

    /// Who else came or went, where that is known already.
    pub(crate) fn poll_life(&mut self) -> Option<Sample> {
        self.lives.try_recv().ok()
    }

    /// Follows what the others tell; says whether that has just begun.
    pub(crate) async fn follow(&mut self) -> bool {
        let looked = Instant::now();
        if let Some(others) = &mut self.others {
            others.looked = looked;
            return false;
        }
        let told = self.way.session.declare_subscriber(of_all(TOLD));
        let told = told.with(RingChannel::new(TOLD_AT_ONCE)).await;
        // Without a network there are no others.
        self.others = told.ok().map(|told| Others { told, looked });
        true
    }

    /// Follows the others no longer when nobody has looked for a while.
    pub(crate) fn follow_on(&mut self, is_watched: bool) {
        if let Some(others) = self.others.as_mut().filter(|_| is_watched) {
            others.looked = Instant::now();
        }
        self.others.take_if(|it| it.looked.elapsed() > FOLLOW_FOR);
    }

    /// Whether anybody follows this station.
    pub(crate) fn is_followed(&self) -> bool {
        let status = self.telling.matching_status().wait();
        // Where that is not known, somebody may.
        status.map_or(true, |it| it.matching())
    }

    /// Tells the others what this station is and does.
    pub(crate) fn tell(&self, told: Vec<u8>) {
        let signed = self.teller.sign(&told);
        if let Err(error) = self.telling.put(told).attachment(signed).wait() {
            tracing::info!(%error, "the fleet is not told");
        }
    }

    /// Answers one who asks what this station is and does.
    pub(crate) fn answer_about(
        &self,
        query: Query,
        told: Vec<u8>,
    ) -> impl Future<Output = ()> + Send + 'static {
        let signed = self.teller.sign(&told);
        let key = self.telling.key_expr().clone();
        async move {
            let reply = query.reply(key, told).attachment(signed);
            if let Err(error) = reply.await {
                tracing::info!(%error, "an answer to the fleet is lost");
            }
        }
    }

    /// Leaves. The session may be that of others, too.
    pub(crate) async fn leave(self) {
        let (alive, ..) = self.declared;
        // Those whom it does not reach miss this station by themselves.
        let _ = alive.undeclare().await;
    }
}

/// What the others tell.
struct Others {
    told: Subscriber<RingChannelHandler<Sample>>,
    /// When somebody looked last.
    looked: Instant,
}

/// Asks all at once what they are and do, and waits until those have told who are there.
pub(crate) async fn ask_all(session: Session) -> Vec<Sample> {
    let replies = session
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

/// What comes next from a network that is there.
pub(crate) async fn incoming(network: Option<&mut Network>) -> Incoming {
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
