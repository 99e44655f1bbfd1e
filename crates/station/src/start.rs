//! Starting a station: everything is opened, and told where.

use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dobot_client::Address;
use dobot_controller::{Controller, PowerUp};
use dobot_journal::{Journal, JournalError};
use dobot_record::{Limits, Recorder};
use dobot_safety::{Policy, PolicyError};
use dobot_sim::{Line, Server, VirtualArm};
use tokio::net::TcpListener;
use tokio::task::JoinHandle;
use tokio::time::Instant;

use crate::arms::{Arms, ArmsError};
use crate::connect::Source;
use crate::handle::Rules;
use crate::http;
use crate::jobs::{self, Jobs};
use crate::keeper::Keeper;
use crate::owner::Owner;
use crate::raw;
use crate::recording::Recording;
use crate::{Config, Folders, Handle};

/// A station that runs.
#[derive(Debug)]
pub struct Station {
    handle: Handle,
    owner: JoinHandle<()>,
    http: http::Server,
    arm: Option<Address>,
    raw: Option<SocketAddr>,
    pty: Option<PathBuf>,
    /// What went wrong and can be done without.
    warnings: Vec<String>,
    /// What ends with the station.
    tasks: Vec<JoinHandle<()>>,
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
    /// Another station runs already, or another program has the address.
    #[error("cannot serve {what} on {address}")]
    Bind {
        /// What was to be served.
        what: &'static str,
        /// Where.
        address: String,
        /// Why not.
        #[source]
        source: std::io::Error,
    },
    /// Page and API cannot be served.
    #[error(transparent)]
    Http(#[from] http::ServeError),
}

impl Station {
    /// Starts a station: its journal, its recording, its arm, its page and API, its raw port.
    ///
    /// # Errors
    ///
    /// [`StartError`]; nothing is left running then.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn start(config: Config) -> Result<Self, StartError> {
        make_folder(config.folders.data())?;
        let policy = read_policy(config.policy.as_deref())?;
        let arms = Arms::read(&config.folders.arms())?;
        // The doors first: where another station has them, nothing of its journal is touched.
        let web = http::Door::open(&config).await?;
        let raw = open_raw(config.raw).await?;
        let journal = Journal::open(&config.folders.journal())?;

        let started = Instant::now();
        let mut tasks = Vec::new();
        let source = source(&config, &mut tasks);
        let dialect = config
            .dialect
            .or_else(|| source.is_virtual().then(|| config.personality.dialect()));
        let mut keeper = Keeper::new(policy.clone(), dialect);
        let rules = Rules::of(&policy);
        let jobs = Jobs::new(journal, Arc::new(policy));
        let mut warnings = Vec::new();
        if let Err(why) = recover(&jobs, &mut keeper) {
            warnings.push(why);
        }
        let recorder = match record(&config.folders) {
            Ok(recorder) => Some(recorder),
            Err(why) => {
                warnings.push(why);
                None
            }
        };
        let personality = source
            .is_virtual()
            .then(|| config.personality.to_string());
        let recording = Recording::new(recorder, personality);
        let (handle, ends) = Handle::new(keeper.state(), rules);
        let arm = source.address();
        let owner = Owner::new(
            keeper,
            ends,
            source,
            arms,
            jobs,
            recording,
            handle.messages.clone(),
            started,
        );
        let owner = tokio::spawn(owner.run());
        let raw_address = raw.as_ref().and_then(|it| it.local_addr().ok());
        if let Some(listener) = raw {
            tasks.push(tokio::spawn(raw::serve(listener, handle.clone())));
        }
        let pty = open_pty(&config, &handle, &mut tasks)?;
        Ok(Self {
            http: web.serve(handle.clone()),
            handle,
            owner,
            arm,
            raw: raw_address,
            pty,
            warnings,
            tasks,
        })
    }

    /// How to talk to it in this process.
    #[must_use]
    pub const fn handle(&self) -> &Handle {
        &self.handle
    }

    /// Where page and API are served, as in `http://127.0.0.1:8642`.
    #[must_use]
    pub fn url(&self) -> String {
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

    /// What went wrong and can be done without.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Ends the station: laser off first, then what is under way comes to its end, then the journal
    /// and the recording are closed.
    pub async fn end(self) {
        self.http.end().await;
        self.handle.end().await;
        // A task that was torn down has nothing to say.
        let _ = self.owner.await;
        for task in self.tasks {
            task.abort();
        }
    }
}

fn make_folder(folder: &Path) -> Result<(), StartError> {
    std::fs::create_dir_all(folder).map_err(|source| StartError::Folder {
        folder: folder.display().to_string(),
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
        Ok(text) => {
            Policy::from_toml(&text).map_err(|source| StartError::Policy { file, source })
        }
    }
}

async fn open_raw(address: Option<SocketAddr>) -> Result<Option<TcpListener>, StartError> {
    let Some(address) = address else {
        return Ok(None);
    };
    let listener = TcpListener::bind(address).await;
    listener.map(Some).map_err(|source| StartError::Bind {
        what: "raw packets",
        address: address.to_string(),
        source,
    })
}

/// Where the arm comes from; a virtual one begins to live here.
fn source(config: &Config, tasks: &mut Vec<JoinHandle<()>>) -> Source {
    match &config.arm {
        Some(Address::Virtual) => {
            let controller = Controller::power_up(PowerUp::new(config.personality));
            let arm = VirtualArm::new(controller, Line::STOCK);
            let mut server = Server::new(arm).at_speed(config.speed);
            let connector = server.connector();
            tasks.push(tokio::spawn(async move {
                // In this process there is no port that could not be served any more.
                let _ = server.run(|_| ()).await;
            }));
            Source::Virtual(connector)
        }
        Some(address) => Source::Named(address.clone()),
        None => Source::Search,
    }
}

/// Takes up a job that was at work when the station before this one was killed.
fn recover(jobs: &Jobs, keeper: &mut Keeper) -> Result<(), String> {
    let interrupted = jobs.interrupted().map_err(|error| error.to_string())?;
    let Some(job) = interrupted else {
        return Ok(());
    };
    match jobs.begun(&job, jobs::recovery_model(&job)) {
        Ok(begun) => {
            keeper.handle_recovered(std::time::Duration::ZERO, begun, job.window);
            Ok(())
        }
        Err(refusal) => {
            jobs.give_up(&job, &refusal.to_string());
            Err(format!("job {} cannot be gone on with: {refusal}", job.id))
        }
    }
}

fn record(folders: &Folders) -> Result<Recorder, String> {
    let folder = folders.recordings();
    let started = Recorder::start(
        folder,
        Limits::default(),
        dobot_record::About::default(),
        jiff::Timestamp::now(),
    );
    started.map_err(|error| format!("nothing is recorded: {error}"))
}

/// A virtual serial port for programs that speak nothing else.
fn open_pty(
    config: &Config,
    handle: &Handle,
    tasks: &mut Vec<JoinHandle<()>>,
) -> Result<Option<PathBuf>, StartError> {
    let Some(link) = &config.pty else {
        return Ok(None);
    };
    let port = crate::virtual_port::open(link).map_err(|source| StartError::Bind {
        what: "a virtual serial port",
        address: link.display().to_string(),
        source,
    })?;
    let path = port.path().to_owned();
    tasks.push(tokio::spawn(port.serve(handle.clone())));
    Ok(Some(path))
}
