//! State shared by all requests.

use std::collections::HashSet;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use dobot_api::problem_kinds::{NO_SUCH_FILE, TOO_MANY_CLIENTS};
use dobot_api::{Device, News, Notice, Problem, Role, StationAddress};
use dobot_host::{OwnVirtualArm, PlannedFor, StationHandle};
use tokio::sync::broadcast::Receiver;
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};
use tokio::time::Instant;

use crate::http::access::http_leases::HttpLeases;
use crate::http::access::rate::Addresses;
use crate::http::access::tokens::Tokens;
use crate::http::agents::HttpAgents;
use crate::http::fleet_routes::learners::Learners;
use crate::http::resources::custom_buttons::CustomButtons;
use crate::http::resources::drawings::Drawings;
use crate::http::resources::files::{FileView, StoredFiles};
use crate::http::resources::recordings::Recordings;
use crate::http::resources::talk::Talk;
use crate::http::resources::test_arms::TestArms;
use crate::http::serve::listen::ConnectionSlot;
use crate::{ArmsPort, FleetPort};

/// State shared by all requests.
#[derive(Debug)]
pub(super) struct App {
    pub(super) handle: StationHandle,
    tokens: Mutex<Tokens>,
    /// The role of callers without a token; none if absent.
    pub(super) without_token: Option<Role>,
    /// The names of the station, besides its addresses.
    pub(super) names: Vec<String>,
    /// The address on which it listens, and whether with TLS.
    pub(super) listens: (SocketAddr, bool),
    /// The file of the policy.
    pub(super) policy_file: PathBuf,
    /// The station's own virtual arm, if its arm is virtual.
    pub(super) virtual_arm: Option<OwnVirtualArm>,
    /// Its active faults, as requested.
    pub(super) faults: Mutex<Vec<String>>,
    pub(super) http_leases: HttpLeases,
    /// The planned drawings.
    pub(super) drawings: Drawings,
    pub(super) recordings: Recordings,
    pub(super) buttons: CustomButtons,
    /// The folder of the optional parts of the page.
    pub(super) extras: PathBuf,
    /// What people say to the listener.
    pub(super) talk: Talk,
    /// The virtual arms for the tests of other programs.
    pub(super) test_arms: TestArms,
    /// The stored drawings, photos and programs.
    pub(super) files: StoredFiles,
    /// The tools for agents.
    pub(super) agents: HttpAgents,
    learners: Mutex<Learners>,
    /// The connection to the fleet, if the station belongs to one.
    pub(super) fleet: OnceLock<FleetPort>,
    /// The host of virtual arms, if the station has one.
    pub(super) arms: OnceLock<ArmsPort>,
    /// The keys of the offers whose drawings are being planned.
    pub(super) planning: Mutex<HashSet<String>>,
    pub(super) addresses: Addresses,
    /// The remaining number of WebSockets.
    pub(super) sockets: Arc<Semaphore>,
    /// Becomes true when the station ends.
    pub(super) ending: watch::Receiver<bool>,
    /// The change count of the tokens for which long-lived callers were checked.
    refreshed: watch::Sender<u64>,
    began: Instant,
}

/// The addresses of the station.
#[derive(Debug)]
pub(super) struct Reach {
    /// Its address for itself, without a token.
    pub(super) own: StationAddress,
    /// Its names, besides its addresses.
    pub(super) names: Vec<String>,
    /// The address on which it listens, and whether with TLS.
    pub(super) listens: (SocketAddr, bool),
}

/// The files that requests read and change.
#[derive(Debug)]
pub(super) struct AppFiles {
    /// The file of the policy.
    pub(super) policy: PathBuf,
    /// The folder of the recordings.
    pub(super) recordings: PathBuf,
    /// The file of the buttons that people have added to the page.
    pub(super) buttons: PathBuf,
    /// The folder of the stored files.
    pub(super) stored: PathBuf,
    /// The folder of the optional parts of the page.
    pub(super) extras: PathBuf,
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
            listens: reach.listens,
            policy_file: files.policy,
            virtual_arm,
            faults: Mutex::default(),
            http_leases: HttpLeases::default(),
            drawings: Drawings::default(),
            recordings: Recordings::new(files.recordings),
            buttons: CustomButtons::at(files.buttons),
            talk: Talk::default(),
            extras: files.extras,
            test_arms: TestArms::default(),
            files: StoredFiles::new(files.stored),
            agents: HttpAgents::new(reach.own),
            learners: Mutex::default(),
            fleet: OnceLock::new(),
            arms: OnceLock::new(),
            planning: Mutex::default(),
            addresses: Addresses::default(),
            sockets: Arc::new(Semaphore::new(MAX_SOCKETS)),
            ending,
            refreshed: watch::Sender::new(0),
            began: Instant::now(),
        })
    }

    /// Returns the arm for which to plan now.
    pub(super) fn planned_for(&self) -> PlannedFor {
        PlannedFor::of(self.handle.rules(), self.handle.state().state())
    }

    /// Returns the time since the start.
    pub(super) fn now(&self) -> Duration {
        self.began.elapsed()
    }

    /// Returns name and role of the token with this digest. The file is only checked for an unknown
    /// one: a stop must not wait for the disk.
    pub(super) fn holder(&self, token: &[u8; 32]) -> Option<(String, Role)> {
        let known = self.tokens().known(token);
        known.or_else(|| {
            self.refresh_tokens();
            self.tokens().known(token)
        })
    }

    /// Returns the digest of the token that this proof is made with. The file is only checked for
    /// an unknown one.
    #[cfg(feature = "proofs")]
    pub(super) fn proved(&self, statement: &[u8], proof: &[u8]) -> Option<[u8; 32]> {
        let proved = self.tokens().proved(statement, proof);
        proved.or_else(|| {
            self.refresh_tokens();
            self.tokens().proved(statement, proof)
        })
    }

    /// Reads the tokens again if they have changed. Callers whose role was reduced lose what they
    /// hold.
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

    /// Whether a caller still has the rights with which it was admitted.
    fn may_still(&self, caller: &Caller) -> bool {
        let known = |token| self.tokens().known(token);
        caller
            .token
            .as_ref()
            .is_none_or(|token| known(token).is_some_and(|(_, role)| role >= caller.role))
    }

    /// Waits until a caller loses the rights with which it was admitted.
    pub(super) async fn revoked(&self, caller: &Caller) {
        let mut refreshed = self.refreshed.subscribe();
        while self.may_still(caller) {
            if refreshed.changed().await.is_err() {
                return;
            }
        }
    }

    /// Makes the picture of a stored file.
    pub(super) async fn sketch_file(self: Arc<Self>, file: FileView) {
        let Ok(content) = self.files.content(file.file).await else {
            return;
        };
        let sketch = self.drawings.sketch(file.name, content).await;
        let sketch = sketch.map_err(|problem| problem.detail);
        let saved = self.files.set_sketch(file.file, file.sha256, sketch).await;
        self.report_unsaved(saved);
    }

    /// Saves the results of jobs made from stored files, until the station ends.
    pub(super) async fn follow_jobs(self: Arc<Self>, mut notices: Receiver<Arc<Notice>>) {
        loop {
            let (job, phase) = match notices.recv().await.map(|notice| notice.news.clone()) {
                Ok(News::Job { job, phase }) => (job, phase),
                Ok(_) | Err(RecvError::Lagged(_)) => continue,
                Err(RecvError::Closed) => return,
            };
            let jobs = self.handle.jobs().await.unwrap_or_default();
            let took_s = jobs.iter().find(|view| view.job == job);
            let took_s = took_s.and_then(|view| view.took_s);
            self.report_unsaved(self.files.finish_job(job, phase, took_s).await);
        }
    }

    /// Reports that something about a stored file could not be saved; it may have been deleted.
    pub(super) fn report_unsaved(&self, saved: Result<(), Problem>) {
        if let Err(problem) = saved
            && problem.name() != NO_SUCH_FILE.name
        {
            self.handle.try_report_trouble(problem.detail);
        }
    }

    /// Reserves a place for a long-lived connection: a WebSocket or an event stream.
    pub(super) fn place(&self) -> Result<OwnedSemaphorePermit, Problem> {
        let place = self.sockets.clone().try_acquire_owned();
        place.map_err(|_| {
            let many = format!("{MAX_SOCKETS} connections are already open");
            TOO_MANY_CLIENTS.problem(many)
        })
    }

    /// Locks the students in lessons.
    pub(super) fn learners(&self) -> MutexGuard<'_, Learners> {
        self.learners.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Locks the tokens.
    pub(super) fn tokens(&self) -> MutexGuard<'_, Tokens> {
        self.tokens.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The interval at which the tokens are checked while a caller may hold something.
pub(super) const REFRESH_EVERY: Duration = Duration::from_millis(100);
/// The maximum number of WebSockets.
pub(super) const MAX_SOCKETS: usize = 2000;

/// The two ends of a connection.
#[derive(Clone, Debug)]
pub(super) struct Peer {
    pub(super) from: SocketAddr,
    pub(super) to: SocketAddr,
    /// Whether it is encrypted.
    pub(super) secure: bool,
    /// Whether it is the fleet: callers without a token may then watch and stop, wherever the
    /// station is served.
    pub(super) by_fleet: bool,
    /// Its slot among all connections, while any part of it exists; the fleet has none.
    pub(super) _slot: Option<Arc<ConnectionSlot>>,
}

/// The caller of a request.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Caller {
    /// Its default name.
    pub(super) name: String,
    pub(super) role: Role,
    /// Whether its token belongs to one person, identified by the token's name.
    pub(super) is_person: bool,
    /// The digest of its token, if any.
    pub(super) token: Option<[u8; 32]>,
}

impl std::fmt::Debug for Caller {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut shown = f.debug_struct("Caller");
        shown.field("name", &self.name).field("role", &self.role);
        shown.finish_non_exhaustive()
    }
}

/// The lifetime of a caller: until the station ends, or the caller loses its rights.
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
    /// Returns the name of a client that gives this name, if any: on a page the name of a personal
    /// token counts.
    pub(super) fn name_of(&self, given: Option<&str>, device: Option<Device>) -> String {
        match (given, device) {
            (_, Some(_)) if self.is_person => self.name.clone(),
            (Some(given), _) => given.to_owned(),
            (None, Some(_)) => NAMELESS_PAGE.to_owned(),
            (None, None) => self.name.clone(),
        }
    }

    /// Returns the name by which time slots identify the caller, if it gives this name.
    pub(super) fn person<'a>(&'a self, name: &'a str) -> &'a str {
        if self.is_person { &self.name } else { name }
    }
}

/// The name of a page whose user gives none.
const NAMELESS_PAGE: &str = "page";

/// Waits until the station ends.
pub(super) async fn ended(mut ending: watch::Receiver<bool>) {
    drop(ending.wait_for(|&ends| ends).await);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_has_the_name_that_its_user_gives_unless_the_token_says_who_it_is() {
        let mut caller = Caller {
            name: "a program on this computer".into(),
            role: Role::Control,
            is_person: false,
            token: None,
        };
        let phone = Some(Device::Phone);
        assert_eq!(caller.name_of(None, None), "a program on this computer");
        assert_eq!(caller.name_of(Some("blink.py"), None), "blink.py");
        assert_eq!(caller.name_of(Some("Anna"), phone), "Anna");
        assert_eq!(caller.name_of(None, phone), "page");
        caller.name = "Ben".into();
        caller.is_person = true;
        assert_eq!(caller.name_of(Some("Anna"), phone), "Ben");
    }
}
