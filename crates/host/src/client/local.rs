//! A client of rules that are kept in this process, for an arm at an address.

use std::path::PathBuf;
use std::sync::Arc;

use dobot_api::{
    Calibrations, ClientId, Folders, JobView, Notice, RemoteError, Reply, Request, Role,
    StationEvent,
};
use dobot_safety::Policy;
use dobot_session::{Address, OpenError};
use dobot_supervisor::Refusal;
use dobot_wire::Dialect;
use tokio::sync::broadcast::{self, error::RecvError};

use crate::host::{Host, HostError, Setup};
use crate::prepared_arm::PreparedArm;
use crate::watchdog::wait_for_watchdog;
use crate::{Client, Snapshot};

/// An arm at an address, and by which rules it is used.
#[derive(Clone, Debug)]
pub struct LocalArm {
    /// Where the arm is: a serial port or TCP.
    pub address: Address,
    /// What the arm understands. When absent, it is what was found out about this arm before, by
    /// `dobot detect`; otherwise it is undecided.
    pub dialect: Option<Dialect>,
    /// The rules.
    pub policy: Policy,
    /// Where this person's station keeps what it has to remember: the jobs of this arm get a folder
    /// of their own in it.
    pub folders: Folders,
    /// The program that guards the arm, as in [`Setup`](crate::Setup::watchdog).
    pub watchdog: Option<PathBuf>,
}

/// Why an arm cannot be used from this process.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenArmError {
    /// Its port cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The rules are not at work.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The system has no thread left for the arm.
    #[error("the system gives the arm no thread of its own")]
    Thread(#[source] std::io::Error),
    /// It ended at once.
    #[error(transparent)]
    Ended(Refusal),
}

/// A client of rules that are kept in this process.
#[derive(Debug)]
pub(super) struct Local {
    address: Address,
    client: Client,
    states: broadcast::Receiver<Arc<Snapshot>>,
    notices: broadcast::Receiver<Arc<Notice>>,
    host: Host,
}

impl Local {
    /// The port first, and laser off: an arm is dark before anything is kept of it that could fail.
    pub(super) async fn open(arm: LocalArm, name: &str) -> Result<Self, OpenArmError> {
        for folders in [&arm.folders, &arm.folders.of_arm(&arm.address.to_string())] {
            wait_for_watchdog(&folders.watchdog()).await;
        }
        let prepared_arm = PreparedArm::open(&arm.address).await?;
        let host = Host::start(prepared_arm, setup(&arm))?;
        let handle = host.handle().clone();
        for text in host.notes().iter().chain(host.of_watchdog()) {
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

    /// What happened comes before the state behind it.
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

    pub(super) fn calibrations(&self) -> Calibrations {
        self.client.handle().rules().calibrations.clone()
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
        // Whoever used the arm was told that it was gone.
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
