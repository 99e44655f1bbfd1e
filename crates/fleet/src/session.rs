//! Sessions: the connection of a program to its fleet.

use std::path::PathBuf;
use std::sync::{Arc, Weak};
use std::time::Duration;

use tokio::sync::watch;
use tokio::task::spawn_blocking;
use tokio::time::{MissedTickBehavior, interval};
use zenoh::{Config, Session, Wait};

use crate::credentials::read_revoked;
use crate::identity::Identity;
use crate::{Credentials, FleetError, config};

/// The connection of a program to its fleet: a Zenoh session that all stations of the program
/// share.
///
/// It is closed by [`FleetSession::close`], or when its last copy and the last station that joined
/// through it are dropped.
#[derive(Clone, Debug)]
pub struct FleetSession {
    opened: watch::Receiver<Option<Result<Session, String>>>,
    identity: Arc<Identity>,
    is_on_one_machine: bool,
}

/// The interval at which the list of revoked certificates is checked.
const LOOK_EVERY: Duration = Duration::from_millis(100);

impl FleetSession {
    /// Opens a session through routers, as in `quic/router.school:7447`, without waiting for them.
    /// Without routers it discovers other stations on its network, or on this machine if the
    /// credentials are local.
    ///
    /// # Errors
    ///
    /// [`FleetError`].
    pub async fn open(connect: &[String], credentials: &Credentials) -> Result<Self, FleetError> {
        let config = config::session(connect, credentials)?;
        let identity = Arc::new(credentials.identity()?);
        let (sender, opened) = watch::channel(None);
        open_in_thread(config, sender)?;
        if let Some(file) = credentials.revoked_file() {
            tokio::spawn(follow_revoked(file.to_owned(), Arc::downgrade(&identity)));
        }
        let mut session = Self {
            opened,
            identity,
            is_on_one_machine: credentials.is_local(),
        };
        if connect.is_empty() {
            // There is no router to wait for, and errors of this machine are reported immediately.
            session.opened().await?;
        }
        Ok(session)
    }

    /// Closes the session; the stations that joined through it appear as away.
    pub async fn close(self) {
        let session = self.opened.borrow().clone();
        if let Some(Ok(session)) = session {
            // The other members notice by themselves.
            let _ = session.close().await;
        }
    }

    /// Returns the identity that signs messages.
    pub(crate) const fn identity(&self) -> &Arc<Identity> {
        &self.identity
    }

    /// Whether only programs of this machine can join: others need credentials.
    pub(crate) const fn is_on_one_machine(&self) -> bool {
        self.is_on_one_machine
    }

    /// Whether the session is open.
    pub(crate) fn is_open(&self) -> bool {
        self.opened.borrow().is_some()
    }

    /// Returns the session when it is open.
    pub(crate) async fn opened(&mut self) -> Result<Session, FleetError> {
        let opened = self.opened.wait_for(Option::is_some).await;
        let opened = opened.map_err(|error| FleetError::Zenoh(error.to_string()))?;
        let opened = opened.clone().expect("awaited above");
        opened.map_err(FleetError::Zenoh)
    }
}

/// Applies revocations while the program runs.
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

/// Opening blocks while a router is unreachable, so it runs in its own thread.
fn open_in_thread(
    config: Config,
    sender: watch::Sender<Option<Result<Session, String>>>,
) -> Result<(), FleetError> {
    let opens = move || {
        let session = zenoh::open(config).wait();
        // The receiver may be gone.
        drop(sender.send(Some(session.map_err(|error| error.to_string()))));
    };
    let thread = std::thread::Builder::new().name("fleet".into());
    let thread = thread.spawn(opens);
    thread.map_err(|error| FleetError::Zenoh(error.to_string()))?;
    Ok(())
}
