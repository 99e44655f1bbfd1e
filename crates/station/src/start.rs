//! Starting a station: everything is opened, and told where.

use std::io::ErrorKind;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};

use dobot_host::{Host, HostError, PreparedArm, ServiceManager, Setup, StationHandle};
use dobot_safety::{Policy, PolicyError};
use dobot_session::Address;

#[cfg(unix)]
use crate::VirtualPort;
use crate::http;
use crate::{
    Config, FoxglovePort, FoxglovePortError, ProgramNews, RawPort, RawPortError, ServeError,
    Served, StationApi, Web,
};

/// A station that runs.
#[derive(Debug)]
pub struct Station {
    host: Host,
    http: Served,
    arm: Option<Address>,
    raw: Option<SocketAddr>,
    pty: Option<PathBuf>,
    foxglove: Option<SocketAddr>,
    /// What a person should know, a line each.
    notes: Vec<String>,
}

/// Why a station does not start.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
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
    /// The rules are not at work.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The raw port cannot be served.
    #[error(transparent)]
    Raw(#[from] RawPortError),
    /// Foxglove cannot look on.
    #[error(transparent)]
    Foxglove(#[from] FoxglovePortError),
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
        let approach = Box::pin(config.approach()).await?;
        Self::begin(config, approach).await
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
    pub async fn begin(config: Config, approach: PreparedArm) -> Result<Self, StartError> {
        Box::pin(Self::open(config, approach)).await
    }

    async fn open(config: Config, approach: PreparedArm) -> Result<Self, StartError> {
        let policy = read_policy(&config)?;
        // The raw port first: where another station has it, nothing of its journal is touched.
        let raw = match config.raw {
            Some(address) => Some(RawPort::bind(address).await?),
            None => None,
        };
        let foxglove = match config.foxglove {
            Some(address) => Some(FoxglovePort::bind(address).await?),
            None => None,
        };
        let virtual_port = open_pty(&config)?;
        let arm = approach.address();
        let host = Host::start(approach, setup(&config, policy))?;
        for line in host.watchdog_reports() {
            host.handle().try_report_trouble(line.clone());
        }
        let raw = raw.map(|port| serve_raw(port, &host));
        let pty = virtual_port.map(|port| serve_pty(port, &host));
        let foxglove = foxglove.map(|port| serve_foxglove(port, &host));
        match http::serve(&web(&config, &host), host.handle().clone()).await {
            Ok(http) => Ok(Self {
                notes: [host.notes(), host.watchdog_reports()].concat(),
                host,
                http,
                arm,
                raw,
                pty,
                foxglove,
            }),
            Err(error) => {
                // Why it does not start is what counts.
                let _ = host.end().await;
                Err(error.into())
            }
        }
    }

    /// How to talk to it in this process.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        self.host.handle()
    }

    /// How its fleet asks it for something.
    #[must_use]
    pub const fn api(&self) -> &StationApi {
        self.http.api()
    }

    /// The address at which page and API are served.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.http.address()
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

    /// Where Foxglove looks on.
    #[must_use]
    pub const fn foxglove(&self) -> Option<SocketAddr> {
        self.foxglove
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
        let outcome = self.host.end().await;
        // The file that says where it runs is found to be stale by those who try to connect.
        let _ = self.http.end().await;
        outcome.map_err(Failed)
    }
}

/// Something that the arm depends on failed; the laser was switched off and the button let go.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}: the laser was switched off and the button let go")]
pub struct Failed(String);

fn web(config: &Config, host: &Host) -> Web {
    Web {
        address: config.http,
        tls: config.tls.clone(),
        names: config.names.clone(),
        without_token: config.without_token,
        policy_file: policy_file(config),
        virtual_arm: host.virtual_arm().cloned(),
        folders: config.folders.clone(),
    }
}

/// The policy of the file that is named, or else the one that a client has put in place before.
fn read_policy(config: &Config) -> Result<Policy, StartError> {
    let path = policy_file(config);
    let file = path.display().to_string();
    match std::fs::read_to_string(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound && config.policy.is_none() => {
            Ok(Policy::default())
        }
        Err(source) => Err(StartError::PolicyFile { file, source }),
        Ok(text) => Policy::from_toml(&text).map_err(|source| StartError::Policy { file, source }),
    }
}

fn policy_file(config: &Config) -> PathBuf {
    let named = config.policy.clone();
    named.unwrap_or_else(|| config.folders.policy())
}

fn serve_raw(port: RawPort, host: &Host) -> SocketAddr {
    let (address, handle) = (port.address(), host.handle().clone());
    host.spawn(async move {
        port.serve(&handle, |news| tell(&handle, &news)).await;
    });
    address
}

fn serve_foxglove(port: FoxglovePort, host: &Host) -> SocketAddr {
    let (address, handle) = (port.address(), host.handle().clone());
    host.spawn(async move {
        if let Err(error) = port.serve(&handle).await {
            handle
                .report_trouble(format!("Foxglove is told nothing: {error}"))
                .await;
        }
    });
    address
}

/// Lets those who watch know what goes wrong with an old program.
fn tell(handle: &StationHandle, news: &ProgramNews) {
    if let Some(trouble) = news.trouble() {
        handle.try_report_trouble(trouble);
    }
}

fn setup(config: &Config, policy: Policy) -> Setup {
    Setup {
        policy,
        dialect: config.dialect,
        folders: config.folders.clone(),
        common: config.folders.clone(),
        stop: Some(config.folders.stop()),
        watchdog: config.watchdog.clone(),
        service_manager: config.is_service.then(ServiceManager::of_environment),
    }
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
fn serve_pty(port: VirtualPort, host: &Host) -> PathBuf {
    let (path, handle) = (port.path().to_owned(), host.handle().clone());
    host.spawn(async move {
        let served = port.serve(&handle, |news| tell(&handle, &news)).await;
        if let Err(error) = served {
            let text = format!("the virtual serial port cannot be served any more: {error}");
            handle.report_trouble(text).await;
        }
    });
    path
}

#[cfg(not(unix))]
fn open_pty(_: &Config) -> Result<Option<std::convert::Infallible>, StartError> {
    Ok(None)
}

#[cfg(not(unix))]
fn serve_pty(port: std::convert::Infallible, _: &Host) -> PathBuf {
    match port {}
}
