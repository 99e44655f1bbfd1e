//! The Zenoh declarations of one station.

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
use crate::key_expressions::{ALL_ALIVE, API, Alive, SEALED, STATE, STOPS, of_all};
use crate::publisher::StateSigner;
use crate::requests::{self, Peers, Requester};
use crate::session::FleetSession;

/// The connection to the other members.
pub(crate) struct Network {
    requester: Requester,
    /// Arrivals and departures. Unbounded, since stations of this program may share the session.
    lives: mpsc::UnboundedReceiver<Sample>,
    /// Stops, and stops of the fleet: they do not wait for other requests.
    urgent: mpsc::Receiver<Incoming>,
    /// All other requests.
    requests: mpsc::Receiver<Incoming>,
    /// The published states of the members, while somebody watches.
    others: Option<Others>,
    /// Publishes this station's state.
    publisher: Publisher<'static>,
    signer: StateSigner,
    /// The liveliness token and the resources of this station.
    declared: (LivelinessToken, [Queryable<()>; 4], Subscriber<()>),
}

/// The network, until the router is connected.
pub(crate) type Opening = Pin<Box<dyn Future<Output = Result<Network, FleetError>> + Send>>;

/// A message from the other members.
pub(crate) enum Incoming {
    Life(Sample),
    Asked(Query),
    Sealed(Query),
    Stops(Query),
    /// A query for this station's state.
    About(Query),
    State(Sample),
}

/// The timeout for state queries.
const QUERY_TIMEOUT: Duration = Duration::from_secs(1);
/// How long the subscription lasts after the last use.
const FOLLOW_FOR: Duration = Duration::from_secs(10);
/// The capacity of the queue of published states; beyond it the oldest is dropped, since each
/// member publishes every second.
const STATES_AT_ONCE: usize = 4096;
/// The capacity of the request queue; requests beyond it get no response.
const REQUESTS_AT_ONCE: usize = 256;

impl Network {
    /// Opens the network when the router is connected. `peers` are the members that accept
    /// requests.
    pub(crate) async fn open(
        mut session: FleetSession,
        alive: Alive,
        peers: Peers,
    ) -> Result<Self, FleetError> {
        let requester = Requester {
            session: session.opened().await?,
            identity: session.identity().clone(),
            peers,
        };
        let declared = Self::declare(requester, alive).await;
        declared.map_err(|error| FleetError::zenoh(&error))
    }

    async fn declare(requester: Requester, alive: Alive) -> Result<Self, zenoh::Error> {
        let (session, own) = (&requester.session, &alive.member);
        let signer = StateSigner::new(requester.identity.clone(), own.clone(), alive.run);
        let (sender, lives) = mpsc::unbounded_channel();
        let liveliness = session.liveliness();
        let others = liveliness.declare_subscriber(ALL_ALIVE).history(true);
        // A receiver that has left gets nothing.
        let others = others
            .callback(move |member| drop(sender.send(member)))
            .await?;
        let (to_urgent, urgent) = mpsc::channel(REQUESTS_AT_ONCE);
        let (to_requests, requests) = mpsc::channel(REQUESTS_AT_ONCE);
        // Never blocks: a callback that blocks keeps its link from receiving, stops too, and a peer
        // closes a link that receives nothing for some seconds.
        let queue = async |what, put: fn(Query) -> Incoming| {
            let (to_urgent, to_requests) = (to_urgent.clone(), to_requests.clone());
            let queryable = session.declare_queryable(own.resource(what));
            let queryable = queryable.callback(move |query| {
                let is_urgent = what == STOPS || (what == API && requests::asks_to_stop(&query));
                let queue = if is_urgent { &to_urgent } else { &to_requests };
                if queue.try_send(put(query)).is_err() {
                    tracing::info!(what, "dropped a request of the fleet: the queue is full");
                }
            });
            queryable.await
        };
        let queryables = [
            queue(API, Incoming::Asked).await?,
            queue(SEALED, Incoming::Sealed).await?,
            queue(STOPS, Incoming::Stops).await?,
            queue(STATE, Incoming::About).await?,
        ];
        let publisher = session.declare_publisher(own.resource(STATE)).await?;
        let token = liveliness.declare_token(alive.key()).await?;
        Ok(Self {
            requester,
            lives,
            urgent,
            requests,
            others: None,
            publisher,
            signer,
            declared: (token, queryables, others),
        })
    }

    /// Returns the session and identity for requests.
    pub(crate) const fn requester(&self) -> &Requester {
        &self.requester
    }

    /// Returns the next message.
    async fn next(&mut self) -> Incoming {
        tokio::select! {
            Some(request) = self.urgent.recv() => request,
            Some(sample) = self.lives.recv() => Incoming::Life(sample),
            Some(request) = self.requests.recv() => request,
            Ok(sample) = next_state(self.others.as_ref()) => Incoming::State(sample),
            else => std::future::pending().await,
        }
    }

    /// Returns the next arrival or departure that is already queued.
    pub(crate) fn poll_life(&mut self) -> Option<Sample> {
        self.lives.try_recv().ok()
    }

    /// Subscribes to the members' states; returns whether the subscription is new.
    pub(crate) async fn follow(&mut self) -> bool {
        let looked = Instant::now();
        if let Some(others) = &mut self.others {
            others.looked = looked;
            return false;
        }
        let states = self.requester.session.declare_subscriber(of_all(STATE));
        let states = states.with(RingChannel::new(STATES_AT_ONCE)).await;
        // Without a network there are no other members.
        self.others = states.ok().map(|states| Others { states, looked });
        true
    }

    /// Unsubscribes when nobody has watched for a while.
    pub(crate) fn follow_on(&mut self, is_watched: bool) {
        if let Some(others) = self.others.as_mut().filter(|_| is_watched) {
            others.looked = Instant::now();
        }
        self.others
            .take_if(|others| others.looked.elapsed() > FOLLOW_FOR);
    }

    /// Whether anybody subscribes to this station's state.
    pub(crate) fn is_followed(&self) -> bool {
        let status = self.publisher.matching_status().wait();
        // If that is unknown, assume a subscriber.
        status.map_or(true, |status| status.matching())
    }

    /// Publishes this station's state.
    pub(crate) fn publish(&self, state: Vec<u8>) {
        let signature = self.signer.sign(&state);
        if let Err(error) = self.publisher.put(state).attachment(signature).wait() {
            tracing::info!(%error, "cannot publish the state to the fleet");
        }
    }

    /// Answers a query for this station's state.
    pub(crate) fn answer_about(
        &self,
        query: Query,
        state: Vec<u8>,
    ) -> impl Future<Output = ()> + Send + 'static {
        let signature = self.signer.sign(&state);
        let key = self.publisher.key_expr().clone();
        async move {
            let reply = query.reply(key, state).attachment(signature);
            if let Err(error) = reply.await {
                tracing::info!(%error, "cannot send a response to the fleet");
            }
        }
    }

    /// Leaves the fleet. The session may be shared.
    pub(crate) async fn leave(self) {
        let (alive, ..) = self.declared;
        // Members that this does not reach notice by the lease of the link.
        let _ = alive.undeclare().await;
    }
}

/// The subscription to the members' states.
struct Others {
    states: Subscriber<RingChannelHandler<Sample>>,
    /// When it was last used.
    looked: Instant,
}

/// Queries the state of all members, and waits until those present have answered.
pub(crate) async fn ask_all(session: Session) -> Vec<Sample> {
    let replies = session
        .get(of_all(STATE))
        .target(QueryTarget::All)
        .consolidation(ConsolidationMode::None)
        .timeout(QUERY_TIMEOUT)
        .await;
    let mut samples = Vec::new();
    if let Ok(replies) = replies {
        // A member that does not answer delays the others no longer than this.
        let _ = timeout(QUERY_TIMEOUT, async {
            while let Ok(reply) = replies.recv_async().await {
                samples.extend(reply.into_result());
            }
        })
        .await;
    }
    samples
}

/// Returns the next message of a connected network.
pub(crate) async fn incoming(network: Option<&mut Network>) -> Incoming {
    match network {
        Some(network) => network.next().await,
        None => std::future::pending().await,
    }
}

/// Returns the next published state; never, without a subscription.
async fn next_state(others: Option<&Others>) -> Result<Sample, zenoh::Error> {
    match others {
        Some(others) => others.states.recv_async().await,
        None => std::future::pending().await,
    }
}
