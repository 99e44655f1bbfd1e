//! Starting a station.

use std::io::ErrorKind;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};

use dobot_host::{Host, HostError, PreparedArm, ServiceManager, Setup, StationHandle};
use dobot_safety::{Policy, PolicyError};
use dobot_session::Address;

#[cfg(unix)]
use crate::VirtualPort;
use crate::{
    Config, FoxglovePort, FoxglovePortError, HooksError, ProgramNews, RawPort, RawPortError,
    ServeError, Served, StationApi, Web,
};
use crate::{hooks, http};

/// A running station.
#[derive(Debug)]
pub struct Station {
    host: Host,
    http: Served,
    arm: Option<Address>,
    raw: Option<SocketAddr>,
    pty: Option<PathBuf>,
    foxglove: Option<SocketAddr>,
    /// Messages for the user, a line each.
    notes: Vec<String>,
}

/// The error returned when a station cannot be started.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
    /// The policy cannot be read.
    #[error("cannot read the policy {file}")]
    PolicyFile {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: std::io::Error,
    },
    /// The policy is invalid.
    #[error("the policy {file} is invalid")]
    Policy {
        /// The file.
        file: String,
        /// The problem.
        #[source]
        source: PolicyError,
    },
    /// The hooks are invalid.
    #[error(transparent)]
    Hooks(#[from] HooksError),
    /// The rules cannot be started.
    #[error(transparent)]
    Host(#[from] HostError),
    /// The raw port cannot be opened.
    #[error(transparent)]
    Raw(#[from] RawPortError),
    /// The port for Foxglove cannot be opened.
    #[error(transparent)]
    Foxglove(#[from] FoxglovePortError),
    /// The virtual serial port cannot be created.
    #[error("cannot create the virtual serial port")]
    Pty(#[source] std::io::Error),
    /// The system has no thread left for the arm.
    #[error("the system cannot create a thread for the arm")]
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
    /// [`StartError`]; then nothing is left running.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn start(config: Config) -> Result<Self, StartError> {
        let approach = Box::pin(config.approach()).await?;
        Self::begin(config, approach).await
    }

    /// Starts a station whose arm has already been sent the command to switch its laser off.
    ///
    /// # Errors
    ///
    /// [`StartError`]; then nothing is left running.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn begin(config: Config, approach: PreparedArm) -> Result<Self, StartError> {
        Box::pin(Self::open(config, approach)).await
    }

    async fn open(config: Config, approach: PreparedArm) -> Result<Self, StartError> {
        let policy = read_policy(&config)?;
        let hooks = hooks::read(&config.folders.hooks())?;
        // The raw port first: if another station has it, its journal is not touched.
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
            Ok(http) => {
                let page = http.url().to_owned();
                hooks::start(hooks, host.handle().clone(), page).map_err(StartError::Thread)?;
                Ok(Self {
                    notes: [host.notes(), host.watchdog_reports()].concat(),
                    host,
                    http,
                    arm,
                    raw,
                    pty,
                    foxglove,
                })
            }
            Err(error) => {
                // Report the cause, not a failed shutdown.
                let _ = host.end().await;
                Err(error.into())
            }
        }
    }

    /// Returns the handle for requests in this process.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        self.host.handle()
    }

    /// Returns the API for the fleet.
    #[must_use]
    pub const fn api(&self) -> &StationApi {
        self.http.api()
    }

    /// Returns the address of page and API.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.http.address()
    }

    /// Returns the URL of page and API, as in `http://127.0.0.1:8642`.
    #[must_use]
    pub fn url(&self) -> &str {
        self.http.url()
    }

    /// Returns the digest of the certificate, if page and API are served with TLS.
    #[must_use]
    pub fn fingerprint(&self) -> Option<&str> {
        self.http.fingerprint()
    }

    /// Returns the arm, if it was given or is the station's own; otherwise it is being searched.
    #[must_use]
    pub const fn arm(&self) -> Option<&Address> {
        self.arm.as_ref()
    }

    /// Returns the TCP address for raw packets.
    #[must_use]
    pub const fn raw(&self) -> Option<SocketAddr> {
        self.raw
    }

    /// Returns the path of the virtual serial port for raw packets.
    #[must_use]
    pub fn pty(&self) -> Option<&Path> {
        self.pty.as_deref()
    }

    /// Returns the address for Foxglove.
    #[must_use]
    pub const fn foxglove(&self) -> Option<SocketAddr> {
        self.foxglove
    }

    /// Returns the messages for the user, a line each: why no arm was found, what cannot be
    /// recorded.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Ends the station: switches the laser off first, finishes the in-flight commands, then closes
    /// the journal and the recording.
    ///
    /// # Errors
    ///
    /// [`Failed`] if something that the arm depends on had failed.
    pub async fn end(self) -> Result<(), Failed> {
        let outcome = self.host.end().await;
        // The file with its address is recognised as stale when a connection fails.
        let _ = self.http.end().await;
        outcome.map_err(Failed)
    }
}

/// Something that the arm depends on failed; the laser was switched off and the jog button
/// released.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}: the laser was switched off and the jog button released")]
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

/// Reads the given policy file, or else the policy that a client has stored.
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
        port.serve(&handle, |news| report(&handle, &news)).await;
    });
    address
}

fn serve_foxglove(port: FoxglovePort, host: &Host) -> SocketAddr {
    let (address, handle) = (port.address(), host.handle().clone());
    host.spawn(async move {
        if let Err(error) = port.serve(&handle).await {
            handle
                .report_trouble(format!("Foxglove gets no data: {error}"))
                .await;
        }
    });
    address
}

/// Reports the problem of a legacy program to the observers.
fn report(handle: &StationHandle, news: &ProgramNews) {
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

/// Opens a virtual serial port for programs that only support serial ports.
#[cfg(unix)]
fn open_pty(config: &Config) -> Result<Option<VirtualPort>, StartError> {
    let Some(link) = &config.pty else {
        return Ok(None);
    };
    let link = Some(link.as_path()).filter(|path| !path.as_os_str().is_empty());
    VirtualPort::open(link).map(Some).map_err(StartError::Pty)
}

#[cfg(unix)]
fn serve_pty(port: VirtualPort, host: &Host) -> PathBuf {
    let (path, handle) = (port.path().to_owned(), host.handle().clone());
    host.spawn(async move {
        let served = port.serve(&handle, |news| report(&handle, &news)).await;
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
