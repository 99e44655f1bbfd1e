//! The way of a program into its fleet.

use std::path::PathBuf;
use std::sync::{Arc, Weak};
use std::time::Duration;

use tokio::sync::watch;
use tokio::task::spawn_blocking;
use tokio::time::{MissedTickBehavior, interval};
use zenoh::{Session, Wait};

use crate::credentials::read_revoked;
use crate::identity::Identity;
use crate::{Credentials, FleetError, config};

/// The way of a program into its fleet: a session of Zenoh, by which all stations of the program join.
///
/// It is closed by [`FleetSession::close`], or when the last of these and the last station that joined by it are dropped.
#[derive(Clone, Debug)]
pub struct FleetSession {
    opened: watch::Receiver<Option<Result<Session, String>>>,
    identity: Arc<Identity>,
    is_on_one_machine: bool,
}

/// How often it is looked whether more certificates are revoked.
const LOOK_EVERY: Duration = Duration::from_millis(100);

impl FleetSession {
    /// Opens a session by routers, each as in `quic/router.school:7447`; it does not wait for them. Without any it looks
    /// for other stations by itself: on its network, or on this machine where the credentials are those of a person.
    ///
    /// # Errors
    ///
    /// [`FleetError`].
    pub async fn open(connect: &[String], credentials: &Credentials) -> Result<Self, FleetError> {
        let config = config::session(connect, credentials)?;
        let identity = Arc::new(credentials.identity()?);
        let (tells, opened) = watch::channel(None);
        // It blocks while a router is away, so it has a thread of its own.
        let opens = move || {
            let session = zenoh::open(config).wait();
            // Whoever waited may have left.
            drop(tells.send(Some(session.map_err(|error| error.to_string()))));
        };
        std::thread::Builder::new()
            .name("fleet".into())
            .spawn(opens)
            .map_err(|error| FleetError::Zenoh(error.to_string()))?;
        if let Some(file) = credentials.revoked_file() {
            tokio::spawn(follow_revoked(file.to_owned(), Arc::downgrade(&identity)));
        }
        let mut session = Self {
            opened,
            identity,
            is_on_one_machine: credentials.is_local(),
        };
        if connect.is_empty() {
            // It waits for nobody, and what is wrong with this machine is told at once.
            session.opened().await?;
        }
        Ok(session)
    }

    /// Closes it: stations that have joined by it are missed by the others.
    pub async fn close(self) {
        let session = self.opened.borrow().clone();
        if let Some(Ok(session)) = session {
            // Those whom it does not reach miss its stations by themselves.
            let _ = session.close().await;
        }
    }

    /// By what the program signs.
    pub(crate) const fn identity(&self) -> &Arc<Identity> {
        &self.identity
    }

    /// Whether nobody on another machine can join: that takes credentials.
    pub(crate) const fn is_on_one_machine(&self) -> bool {
        self.is_on_one_machine
    }

    /// Whether a router is waited for no longer.
    pub(crate) fn is_open(&self) -> bool {
        self.opened.borrow().is_some()
    }

    /// The session, as soon as it is open.
    pub(crate) async fn opened(&mut self) -> Result<Session, FleetError> {
        let opened = self.opened.wait_for(Option::is_some).await;
        let opened = opened.map_err(|error| FleetError::Zenoh(error.to_string()))?;
        let opened = opened.clone().expect("it is waited for until it is there");
        opened.map_err(FleetError::Zenoh)
    }
}

/// Revokes what is revoked while the program runs.
async fn follow_revoked(file: PathBuf, identity: Weak<Identity>) {
    let mut looks = interval(LOOK_EVERY);
    looks.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut seen = None;
    loop {
        looks.tick().await;
        let (path, before) = (file.clone(), seen);
        let read = spawn_blocking(move || read_revoked(&path, before)).await;
        let Some(identity) = identity.upgrade() else {
            return;
        };
        if let Ok(Some((changed, revoked))) = read {
            seen = Some(changed);
            identity.revoke(revoked);
        }
    }
}
