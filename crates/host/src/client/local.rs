//! A client of a supervisor in this process, for an arm at an address.

use std::path::PathBuf;
use std::sync::Arc;

use dobot_api::{
    ClientId, Folders, JobView, Notice, RemoteError, Reply, Request, Role, StationEvent,
};
use dobot_safety::Policy;
use dobot_session::{Address, OpenError};
use dobot_supervisor::Refusal;
use dobot_wire::Dialect;
use tokio::sync::broadcast::{self, error::RecvError};

use crate::host::{Host, HostError, Setup};
use crate::prepared_arm::PreparedArm;
use crate::watchdog::wait_for_watchdog;
use crate::{Client, Rules, Snapshot};

/// An arm at an address and the rules for it.
#[derive(Clone, Debug)]
pub struct LocalArm {
    /// The address of the arm: a serial port or TCP.
    pub address: Address,
    /// The dialect. If absent, the one detected for this arm earlier by `dobot detect`; otherwise
    /// it is undecided.
    pub dialect: Option<Dialect>,
    /// The policy.
    pub policy: Policy,
    /// The data folders of this user's station: the jobs of this arm get a subfolder.
    pub folders: Folders,
    /// The watchdog program, as in [`Setup`](crate::Setup::watchdog).
    pub watchdog: Option<PathBuf>,
}

/// Why an arm cannot be used from this process.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenArmError {
    /// Its port cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The host could not be started.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The system has no thread left for the arm.
    #[error("the system has no thread left for the arm")]
    Thread(#[source] std::io::Error),
    /// The host ended immediately.
    #[error(transparent)]
    Ended(Refusal),
}

/// A client of a supervisor in this process.
#[derive(Debug)]
pub(super) struct Local {
    address: Address,
    client: Client,
    states: broadcast::Receiver<Arc<Snapshot>>,
    notices: broadcast::Receiver<Arc<Notice>>,
    host: Host,
}

impl Local {
    /// Opens the port and switches the laser off first, before anything that could fail.
    pub(super) async fn open(arm: LocalArm, name: &str) -> Result<Self, OpenArmError> {
        for folders in [&arm.folders, &arm.folders.of_arm(&arm.address.to_string())] {
            wait_for_watchdog(&folders.watchdog()).await;
        }
        let prepared_arm = PreparedArm::open(&arm.address).await?;
        let host = Host::start(prepared_arm, setup(&arm))?;
        let handle = host.handle().clone();
        for text in host.notes().iter().chain(host.watchdog_reports()) {
            handle.try_report_trouble(text.clone());
        }
        let (states, notices) = (handle.every_state(), handle.notices());
        let client = handle.client(name, Role::Admin).await;
        Ok(Self {
            address: arm.address,
            client: client.map_err(OpenArmError::Ended)?,
            states,
            notices,
            host,
        })
    }

    pub(super) async fn request(&self, request: Request) -> Result<Reply, Refusal> {
        self.client.request(request).await
    }

    /// A notice comes before the state that follows it.
    pub(super) async fn next(&mut self) -> Result<StationEvent, RemoteError> {
        loop {
            let ended = tokio::select! {
                biased;
                notice = self.notices.recv() => match notice {
                    Ok(notice) => return Ok(StationEvent::Notice((*notice).clone())),
                    Err(error) => error,
                },
                state = self.states.recv() => match state {
                    Ok(state) => return Ok(StationEvent::State(Box::new(state.state().clone()))),
                    Err(error) => error,
                },
            };
            if ended == RecvError::Closed {
                return Err(RemoteError::Closed(None));
            }
        }
    }

    pub(super) async fn jobs(&self) -> Result<Vec<JobView>, Refusal> {
        self.client.handle().jobs().await
    }

    pub(super) fn rules(&self) -> Arc<Rules> {
        self.client.handle().rules()
    }

    pub(super) const fn id(&self) -> ClientId {
        self.client.id()
    }

    pub(super) fn dead_man_s(&self) -> f64 {
        self.client.handle().rules().dead_man_s
    }

    pub(super) const fn address(&self) -> &Address {
        &self.address
    }

    pub(super) async fn end(self) {
        // The client already knows that the arm is gone.
        let _ = self.host.end().await;
    }
}

fn setup(arm: &LocalArm) -> Setup {
    Setup {
        policy: arm.policy.clone(),
        dialect: arm.dialect,
        folders: arm.folders.of_arm(&arm.address.to_string()),
        common: arm.folders.clone(),
        stop: None,
        watchdog: arm.watchdog.clone(),
        service_manager: None,
    }
}
