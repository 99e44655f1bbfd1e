//! A client of rules that are kept in this process, for an arm at an address.

use std::path::PathBuf;
use std::sync::Arc;

use dobot_client::{Address, Link, OpenError};
use dobot_journal::{Journal, JournalError};
use dobot_safety::Policy;
use dobot_wire::Dialect;
use tokio::sync::Mutex;
use tokio::sync::broadcast::{self, error::RecvError};

use crate::arm_thread::{ArmAtWork, ArmThread};
use crate::arms::{Arms, ArmsError};
use crate::connect::{Connecting, Source};
use crate::finder::darken;
use crate::guardian::{Heart, LastWords, take_note, wait_for_guardian};
use crate::handle::Rules;
use crate::jobs::Jobs;
use crate::keeper::Keeper;
use crate::owner::{Given, Owner};
use crate::recording::{self, Recording};
use crate::{
    Client, ClientId, Finder, Folders, Found, Handle, Heard, JobView, Notice, Refusal, RemoteError,
    Reply, Request, Role, Search, Snapshot,
};

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
    /// The program that guards the arm, as in [`Config`](crate::Config::guardian).
    pub guardian: Option<PathBuf>,
}

/// Why an arm cannot be used from this process.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenArmError {
    /// Its port cannot be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// A folder cannot be made.
    #[error("cannot make the folder {folder}")]
    Folder {
        /// The folder.
        folder: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// The journal of its jobs cannot be opened.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// What is known of arms cannot be read.
    #[error(transparent)]
    Arms(#[from] ArmsError),
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
    owner: ArmAtWork,
}

impl Local {
    /// The port first, and laser off: an arm is dark before anything is kept of it that could fail.
    pub(super) async fn open(arm: LocalArm, name: &str) -> Result<Self, OpenArmError> {
        for folders in [&arm.folders, &arm.folders.of_arm(&arm.address)] {
            wait_for_guardian(&folders.guardian()).await;
        }
        let mut link = Link::open(&arm.address).await?;
        darken(&mut link).await;
        let found = Found {
            address: arm.address.clone(),
            link,
            bytes: Vec::new(),
        };
        let (handle, owner) = start(&arm, found)?;
        let (states, notices) = (handle.every_state(), handle.notices());
        let client = handle.client(name, Role::Admin).await;
        Ok(Self {
            address: arm.address,
            client: client.map_err(OpenArmError::Ended)?,
            states,
            notices,
            owner,
        })
    }

    pub(super) async fn request(&self, request: Request) -> Result<Reply, Refusal> {
        self.client.request(request).await
    }

    /// What happened comes before the state behind it.
    pub(super) async fn next(&mut self) -> Result<Heard, RemoteError> {
        loop {
            let ended = tokio::select! {
                biased;
                notice = self.notices.recv() => match notice {
                    Ok(notice) => return Ok(Heard::Notice((*notice).clone())),
                    Err(error) => error,
                },
                state = self.states.recv() => match state {
                    Ok(state) => return Ok(Heard::State(Box::new(state.state().clone()))),
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

    pub(super) const fn id(&self) -> ClientId {
        self.client.id()
    }

    pub(super) const fn address(&self) -> &Address {
        &self.address
    }

    pub(super) async fn end(self) {
        self.client.handle().end().await;
        // Whoever used the arm was told that it was gone.
        let _ = self.owner.ended().await;
    }
}

fn start(arm: &LocalArm, found: Found) -> Result<(Handle, ArmAtWork), OpenArmError> {
    let folders = arm.folders.of_arm(&arm.address);
    folders.make_data().map_err(|source| OpenArmError::Folder {
        folder: folders.data().display().to_string(),
        source,
    })?;
    let arms = Arms::read(&arm.folders.arms())?;
    let journal = Journal::open(&folders.journal())?;
    let keeper = Keeper::new(arm.policy.clone(), arm.dialect);
    let (handle, ends) = Handle::new(keeper.state(), Rules::of(&arm.policy));
    let (recorder, trouble) = recording::start(&arm.folders);
    let finder = Finder::new(Search {
        named: vec![arm.address.clone()],
        ..Search::default()
    });
    let own = handle.messages.clone();
    let words = Arc::new(LastWords::default());
    let mut owner = Owner::new(Given {
        keeper,
        ends,
        source: Source::Port(Arc::new(Mutex::new(finder))),
        arms,
        jobs: Jobs::new(journal, Arc::new(arm.policy.clone()), own.clone()),
        recording: Recording::new(recorder, None),
        own,
        heart: Heart::new(arm.guardian.clone(), folders.guardian(), words.clone()),
    });
    let left = take_note(&folders.guardian());
    let troubles = trouble.into_iter().chain(owner.recover().err()).chain(left);
    for text in troubles {
        handle.tell_trouble(text);
    }
    let thread = ArmThread::start(words).map_err(OpenArmError::Thread)?;
    Ok((handle, thread.give(owner, Some(Connecting::Up(found)))))
}
