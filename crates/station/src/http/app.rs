//! What all requests share.

use std::collections::HashSet;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use dobot_api::problem_kinds::TOO_MANY_CLIENTS;
use dobot_api::{Problem, Role, StationAddress};
use dobot_host::{OwnVirtualArm, PlannedFor, StationHandle};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::time::Instant;

use crate::http::access::http_leases::HttpLeases;
use crate::http::access::rate::Addresses;
use crate::http::access::tokens::Tokens;
use crate::http::agents::HttpAgents;
use crate::http::fleet_routes::learners::Learners;
use crate::http::resources::drawings::Drawings;
use crate::http::resources::recordings::Recordings;
use crate::http::serve::listen::ConnectionSlot;
use crate::{ArmsPort, FleetPort};

/// What all requests share.
#[derive(Debug)]
pub(super) struct App {
    pub(super) handle: StationHandle,
    tokens: Mutex<Tokens>,
    /// What those may do who come without a token; nobody may where there is none.
    pub(super) without_token: Option<Role>,
    /// The names that the station goes by, besides its addresses.
    pub(super) names: Vec<String>,
    /// Where the policy is kept.
    pub(super) policy_file: PathBuf,
    /// The station's own virtual arm, if the arm is that.
    pub(super) virtual_arm: Option<OwnVirtualArm>,
    /// What goes wrong with it, as it was asked for.
    pub(super) faults: Mutex<Vec<String>>,
    pub(super) http_leases: HttpLeases,
    /// The drawings that are planned.
    pub(super) drawings: Drawings,
    pub(super) recordings: Recordings,
    /// The tools for agents.
    pub(super) agents: HttpAgents,
    learners: Mutex<Learners>,
    /// The way to the fleet, once the station belongs to one.
    pub(super) fleet: OnceLock<FleetPort>,
    /// What gives virtual arms to those without one, if the station has that.
    pub(super) arms: OnceLock<ArmsPort>,
    /// The keys of the offers whose drawings are being planned.
    pub(super) planning: Mutex<HashSet<String>>,
    pub(super) addresses: Addresses,
    /// How many more WebSockets there may be.
    pub(super) sockets: Arc<Semaphore>,
    /// Turns true when the station ends.
    pub(super) ending: watch::Receiver<bool>,
    /// The changes of the tokens for which those who stay were checked.
    refreshed: watch::Sender<u64>,
    began: Instant,
}

/// By what the station is reached.
#[derive(Debug)]
pub(super) struct Reach {
    /// The address for itself, without a token.
    pub(super) own: StationAddress,
    /// The names that it goes by, besides its addresses.
    pub(super) names: Vec<String>,
}

/// Where lies what requests read and change.
#[derive(Debug)]
pub(super) struct AppFiles {
    /// The file with the policy.
    pub(super) policy: PathBuf,
    /// The folder with the recordings.
    pub(super) recordings: PathBuf,
}

impl App {
    pub(super) fn new(
        handle: StationHandle,
        tokens: Tokens,
        without_token: Option<Role>,
        reach: Reach,
        files: AppFiles,
        virtual_arm: Option<OwnVirtualArm>,
        ending: watch::Receiver<bool>,
    ) -> Arc<Self> {
        Arc::new(Self {
            handle,
            tokens: Mutex::new(tokens),
            without_token,
            names: reach.names,
            policy_file: files.policy,
            virtual_arm,
            faults: Mutex::default(),
            http_leases: HttpLeases::default(),
            drawings: Drawings::default(),
            recordings: Recordings::new(files.recordings),
            agents: HttpAgents::new(reach.own),
            learners: Mutex::default(),
            fleet: OnceLock::new(),
            arms: OnceLock::new(),
            planning: Mutex::default(),
            addresses: Addresses::default(),
            sockets: Arc::new(Semaphore::new(MOST_SOCKETS)),
            ending,
            refreshed: watch::Sender::new(0),
            began: Instant::now(),
        })
    }

    /// For which arm to plan now.
    pub(super) fn planned_for(&self) -> PlannedFor {
        PlannedFor::of(self.handle.rules(), self.handle.state().state())
    }

    /// The time since the start.
    pub(super) fn now(&self) -> Duration {
        self.began.elapsed()
    }

    /// Name and role of whoever has the token of this digest. Only for one that is not known yet the file is looked at: a stop waits
    /// for no disk.
    pub(super) fn holder(&self, token: &[u8; 32]) -> Option<(String, Role)> {
        let known = self.tokens().known(token);
        known.or_else(|| {
            self.refresh_tokens();
            self.tokens().known(token)
        })
    }

    /// The digest of the token of which this is a proof. Only for one that is not known yet the file is looked at.
    #[cfg(feature = "proofs")]
    pub(super) fn proved(&self, statement: &[u8], proof: &[u8]) -> Option<[u8; 32]> {
        let proved = self.tokens().proved(statement, proof);
        proved.or_else(|| {
            self.refresh_tokens();
            self.tokens().proved(statement, proof)
        })
    }

    /// Reads the tokens anew if they have changed. Whoever may do less than before loses what he holds.
    pub(super) fn refresh_tokens(&self) {
        let file = self.tokens().source();
        let read = file.read();
        let changes = {
            let mut tokens = self.tokens();
            tokens.apply(read);
            tokens.changes()
        };
        if *self.refreshed.borrow() != changes {
            self.refreshed.send_replace(changes);
            self.http_leases.end_where(|caller| !self.may_still(caller));
        }
    }

    /// Whether a caller may still do what he was let in for.
    fn may_still(&self, caller: &Caller) -> bool {
        let known = |token| self.tokens().known(token);
        caller
            .token
            .as_ref()
            .is_none_or(|token| known(token).is_some_and(|(_, role)| role >= caller.role))
    }

    /// Waits until a caller may not do any more what he was let in for.
    pub(super) async fn revoked(&self, caller: &Caller) {
        let mut refreshed = self.refreshed.subscribe();
        while self.may_still(caller) {
            if refreshed.changed().await.is_err() {
                return;
            }
        }
    }

    /// A place for one who stays: on a WebSocket, or to listen to events.
    pub(super) fn place(&self) -> Result<OwnedSemaphorePermit, Problem> {
        let place = self.sockets.clone().try_acquire_owned();
        place.map_err(|_| {
            let many = format!("{MOST_SOCKETS} connections are open already");
            TOO_MANY_CLIENTS.problem(many)
        })
    }

    /// The students in lessons; nobody else changes them meanwhile.
    pub(super) fn learners(&self) -> MutexGuard<'_, Learners> {
        self.learners.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The tokens; nobody else changes them meanwhile.
    pub(super) fn tokens(&self) -> MutexGuard<'_, Tokens> {
        self.tokens.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// How often the tokens are looked at while somebody may hold something by one.
pub(super) const REFRESH_EVERY: Duration = Duration::from_millis(100);
/// How many WebSockets there may be at once.
pub(super) const MOST_SOCKETS: usize = 2000;

/// The two ends of a connection.
#[derive(Clone, Debug)]
pub(super) struct Peer {
    pub(super) from: SocketAddr,
    pub(super) to: SocketAddr,
    /// Whether it is encrypted.
    pub(super) secure: bool,
    /// Whether it is the fleet: whoever comes so without a token may watch and stop, wherever the station is served.
    pub(super) by_fleet: bool,
    /// Its place among all connections, for as long as any part of it is there; the fleet has none.
    pub(super) _slot: Option<Arc<ConnectionSlot>>,
}

/// Who asks.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Caller {
    /// What it is called until it says better.
    pub(super) name: String,
    pub(super) role: Role,
    /// Its token is that of one person, whose name that of the token is.
    pub(super) is_person: bool,
    /// The digest of its token, if it came with one.
    pub(super) token: Option<[u8; 32]>,
}

impl std::fmt::Debug for Caller {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut shown = f.debug_struct("Caller");
        shown.field("name", &self.name).field("role", &self.role);
        shown.finish_non_exhaustive()
    }
}

/// How long a caller stays: until the station ends, or he may not do any more what he was let in for.
pub(super) struct Stay {
    pub(super) app: Arc<App>,
    pub(super) caller: Caller,
}

impl Stay {
    /// Waits until it is over.
    pub(super) async fn is_over(&self) {
        tokio::select! {
            () = ended(self.app.ending.clone()) => {}
            () = self.app.revoked(&self.caller) => {}
        }
    }
}

impl Caller {
    /// By which name time slots know it, when it calls itself so.
    pub(super) fn person<'a>(&'a self, name: &'a str) -> &'a str {
        if self.is_person { &self.name } else { name }
    }
}

/// Waits until the station ends, or nobody is left who could end it.
pub(super) async fn ended(mut ending: watch::Receiver<bool>) {
    drop(ending.wait_for(|&ends| ends).await);
}
