//! Starting a station: everything is opened, and told where.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dobot_client::Address;
use dobot_journal::{Journal, JournalError};
use dobot_safety::{Policy, PolicyError};
use dobot_sim::Speed;

#[cfg(unix)]
use crate::VirtualPort;
use crate::approach::Approach;
use crate::arm_thread::ArmAtWork;
use crate::arms::{Arms, ArmsError};
use crate::connect::{Connecting, Source};
use crate::guardian::{Heart, LastWords, take_note};
use crate::handle::Rules;
use crate::http;
use crate::jobs::Jobs;
use crate::keeper::Keeper;
use crate::owner::{Given, Owner};
use crate::recording::{self, Recording};
use crate::{
    Config, Folders, Handle, ProgramNews, RawPort, RawPortError, ServeError, Served, Supervisor,
    Web,
};

/// A station that runs.
#[derive(Debug)]
pub struct Station {
    handle: Handle,
    owner: ArmAtWork,
    http: Served,
    arm: Option<Address>,
    raw: Option<SocketAddr>,
    pty: Option<PathBuf>,
    /// What a person should know, a line each.
    notes: Vec<String>,
}

/// Why a station does not start.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
    /// A folder of the station cannot be made.
    #[error("cannot make the folder {folder}")]
    Folder {
        /// The folder.
        folder: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// The policy cannot be read.
    #[error("cannot read the policy {file}")]
    PolicyFile {
        /// The file.
        file: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// The policy is not one.
    #[error("the policy {file} is not one")]
    Policy {
        /// The file.
        file: String,
        /// What is wrong with it.
        #[source]
        source: PolicyError,
    },
    /// The journal of jobs cannot be opened.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// What is known of arms cannot be read.
    #[error(transparent)]
    Arms(#[from] ArmsError),
    /// The raw port cannot be served.
    #[error(transparent)]
    Raw(#[from] RawPortError),
    /// The virtual serial port cannot be made.
    #[error("cannot make the virtual serial port")]
    Pty(#[source] std::io::Error),
    /// The system has no thread left for the arm.
    #[error("the system gives the arm no thread of its own")]
    Thread(#[source] std::io::Error),
    /// Page and API cannot be served.
    #[error(transparent)]
    Http(#[from] ServeError),
}

impl Station {
    /// Starts a station: its arm, its journal, its recording, its page and API, its raw port.
    ///
    /// # Errors
    ///
    /// [`StartError`]; nothing is left running then.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn start(config: Config) -> Result<Self, StartError> {
        Self::begin(Box::pin(Approach::new(config)).await?).await
    }

    /// Starts a station whose arm has been told to switch its laser off already.
    ///
    /// # Errors
    ///
    /// [`StartError`]; nothing is left running then.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn begin(approach: Approach) -> Result<Self, StartError> {
        Box::pin(Self::open(approach)).await
    }

    async fn open(approach: Approach) -> Result<Self, StartError> {
        let config = approach.config;
        make_folder(&config.folders)?;
        let policy = read_policy(config.policy.as_deref())?;
        let arms = Arms::read(&config.folders.arms())?;
        // The raw port first: where another station has it, nothing of its journal is touched.
        let raw = match config.raw {
            Some(address) => Some(RawPort::bind(address).await?),
            None => None,
        };
        let journal = Journal::open(&config.folders.journal())?;
        let mut notes = approach.notes;
        let source = approach.source;
        let arm = source.is_virtual().then_some(Address::Virtual);
        let keeper = keeper(&config, &policy, &source);
        let (handle, ends) = Handle::new(keeper.state(), Rules::of(&policy));
        let own = handle.messages.clone();
        let mut owner = Owner::new(Given {
            keeper,
            ends,
            arms,
            jobs: Jobs::new(journal, Arc::new(policy), own.clone()),
            recording: recording(&config, &source, &mut notes),
            source,
            own,
            heart: heart(&config, approach.words),
        });
        notes.extend(owner.recover().err());
        for line in take_note(&config.folders.guardian()) {
            handle.tell_trouble(line.clone());
            notes.push(line);
        }
        let virtual_port = open_pty(&config)?;
        let arm = arm.or_else(|| approach.first.as_ref().and_then(Connecting::address));
        let owner = approach.thread.give(owner, approach.first);
        let raw = raw.map(|port| serve_raw(port, &handle, &owner));
        let pty = virtual_port.map(|port| serve_pty(port, &handle, &owner));
        match http::serve(&web(&config), handle.clone()).await {
            Ok(http) => Ok(Self {
                handle,
                owner,
                http,
                arm,
                raw,
                pty,
                notes,
            }),
            Err(error) => {
                handle.end().await;
                // Why it does not start is what counts.
                let _ = owner.ended().await;
                Err(error.into())
            }
        }
    }

    /// How to talk to it in this process.
    #[must_use]
    pub const fn handle(&self) -> &Handle {
        &self.handle
    }

    /// Where page and API are served, as in `http://127.0.0.1:8642`.
    #[must_use]
    pub fn url(&self) -> &str {
        self.http.url()
    }

    /// The digest of the certificate, where page and API are served with TLS.
    #[must_use]
    pub fn fingerprint(&self) -> Option<&str> {
        self.http.fingerprint()
    }

    /// The arm, where one was named or is the station's own; otherwise it is looked for.
    #[must_use]
    pub const fn arm(&self) -> Option<&Address> {
        self.arm.as_ref()
    }

    /// Where raw packets are served over TCP.
    #[must_use]
    pub const fn raw(&self) -> Option<SocketAddr> {
        self.raw
    }

    /// The virtual serial port with raw packets.
    #[must_use]
    pub fn pty(&self) -> Option<&Path> {
        self.pty.as_deref()
    }

    /// What a person should know, a line each: why no arm was found, what cannot be recorded.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Ends the station: laser off first, then what is under way comes to its end, then the journal
    /// and the recording are closed.
    ///
    /// # Errors
    ///
    /// [`Failed`] where something that the arm depends on had failed.
    pub async fn end(self) -> Result<(), Failed> {
        self.handle.end().await;
        let outcome = self.owner.ended().await;
        // The file that says where it runs is found to be stale by those who try to connect.
        let _ = self.http.end().await;
        outcome.map_err(Failed)
    }
}

/// Something that the arm depends on failed; the laser was switched off and the button let go.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}: the laser was switched off and the button let go")]
pub struct Failed(String);

fn web(config: &Config) -> Web {
    Web {
        address: config.http,
        tls: config.tls.clone(),
        names: config.names.clone(),
        without_token: config.without_token,
        folders: config.folders.clone(),
    }
}

fn make_folder(folders: &Folders) -> Result<(), StartError> {
    folders.make_data().map_err(|source| StartError::Folder {
        folder: folders.data().display().to_string(),
        source,
    })
}

fn read_policy(file: Option<&Path>) -> Result<Policy, StartError> {
    let Some(path) = file else {
        return Ok(Policy::default());
    };
    let file = path.display().to_string();
    match std::fs::read_to_string(path) {
        Err(source) => Err(StartError::PolicyFile { file, source }),
        Ok(text) => Policy::from_toml(&text).map_err(|source| StartError::Policy { file, source }),
    }
}

fn serve_raw(port: RawPort, handle: &Handle, thread: &ArmAtWork) -> SocketAddr {
    let (address, handle) = (port.address(), handle.clone());
    thread.spawn(async move {
        port.serve(&handle, |news| tell(&handle, &news)).await;
    });
    address
}

/// Lets those who watch know what goes wrong with an old program.
fn tell(handle: &Handle, news: &ProgramNews) {
    if let Some(trouble) = news.trouble() {
        handle.tell_trouble(trouble);
    }
}

fn keeper(config: &Config, policy: &Policy, source: &Source) -> Keeper {
    let own = source.is_virtual().then(|| config.personality.dialect());
    let dialect = config.dialect.or(own);
    let mut policy = policy.clone();
    if source.is_virtual() {
        in_time_of_arm(&mut policy, config.speed);
    }
    Keeper::new(policy, dialect)
}

/// A hand on a button is as fast as ever, however fast the arm lives.
fn in_time_of_arm(policy: &mut Policy, speed: Speed) {
    policy.jog.dead_man_s *= speed.times();
    policy.jog.raw_dead_man_s *= speed.times();
}

fn recording(config: &Config, source: &Source, notes: &mut Vec<String>) -> Recording {
    let personality = source.is_virtual().then(|| config.personality.to_string());
    let (recorder, trouble) = recording::start(&config.folders);
    notes.extend(trouble);
    Recording::new(recorder, personality)
}

fn heart(config: &Config, words: Arc<LastWords>) -> Heart {
    let heart = Heart::new(config.guardian.clone(), config.folders.guardian(), words);
    if config.is_service {
        return heart.supervised(Supervisor::of_environment());
    }
    heart
}

/// A virtual serial port for programs that speak nothing else.
#[cfg(unix)]
fn open_pty(config: &Config) -> Result<Option<VirtualPort>, StartError> {
    let Some(link) = &config.pty else {
        return Ok(None);
    };
    let link = Some(link.as_path()).filter(|it| !it.as_os_str().is_empty());
    VirtualPort::open(link).map(Some).map_err(StartError::Pty)
}

#[cfg(unix)]
fn serve_pty(port: VirtualPort, handle: &Handle, thread: &ArmAtWork) -> PathBuf {
    let (path, handle) = (port.path().to_owned(), handle.clone());
    thread.spawn(async move {
        let served = port.serve(&handle, |news| tell(&handle, &news)).await;
        if let Err(error) = served {
            let text = format!("the virtual serial port cannot be served any more: {error}");
            handle.trouble(text).await;
        }
    });
    path
}

#[cfg(not(unix))]
fn open_pty(_: &Config) -> Result<Option<std::convert::Infallible>, StartError> {
    Ok(None)
}

#[cfg(not(unix))]
fn serve_pty(port: std::convert::Infallible, _: &Handle, _: &ArmThread) -> PathBuf {
    match port {}
}
