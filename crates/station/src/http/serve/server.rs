//! The web side of the station.

use std::io;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;

use dobot_api::{Folders, Role, Running, RunningError, StationAddress, StationAddressError};
use dobot_host::{OwnVirtualArm, StationHandle};
use tokio::net::TcpListener;
use tokio::sync::watch;
use tokio::task::JoinHandle;

use crate::TlsFiles;
use crate::http::access::tokens::{Tokens, TokensError};
use crate::http::app::{App, AppFiles, Reach};
use crate::http::exchange::internal_api::StationApi;
use crate::http::serve::listen;
use crate::http::tls::{Certificate, TlsError};

/// Configuration of the web side.
#[derive(Clone, Debug)]
pub struct Web {
    /// The address; port 0 selects a free one.
    pub address: SocketAddr,
    /// The certificate and key. If absent, there is no TLS on loopback, and a self-signed
    /// certificate elsewhere.
    pub tls: Option<TlsFiles>,
    /// The names of the station, besides its addresses.
    pub names: Vec<String>,
    /// The role of callers on loopback without a token; elsewhere they have no rights.
    pub without_token: Option<Role>,
    /// The file in which a new policy is stored.
    pub policy_file: PathBuf,
    /// The station's own virtual arm, if its arm is virtual.
    pub virtual_arm: Option<OwnVirtualArm>,
    /// The folders of the tokens, the own certificate and `station.toml`.
    pub folders: Folders,
}

impl Web {
    /// Without TLS on loopback, where everyone has all rights; with TLS and tokens elsewhere.
    #[must_use]
    pub fn new(address: SocketAddr, folders: Folders) -> Self {
        Self {
            address,
            tls: None,
            names: Vec::new(),
            without_token: Some(Role::Admin),
            policy_file: folders.policy(),
            virtual_arm: None,
            folders,
        }
    }

    fn is_near(&self) -> bool {
        self.address.ip().to_canonical().is_loopback()
    }

    fn certificate(&self) -> Result<Option<Certificate>, TlsError> {
        match &self.tls {
            Some(files) => Certificate::read(files).map(Some),
            None if self.is_near() => Ok(None),
            None => Certificate::own(&self.folders.tls(), &self.names, self.address.ip()).map(Some),
        }
    }
}

/// The running web side; ends when it is dropped.
#[derive(Debug)]
pub struct Served {
    address: SocketAddr,
    api: StationApi,
    running: Running,
    file: PathBuf,
    ends: watch::Sender<bool>,
    serving: JoinHandle<()>,
}

/// Serves page and API, and writes `station.toml`.
///
/// # Errors
///
/// [`ServeError`]; then nothing is served.
pub async fn serve(web: &Web, handle: StationHandle) -> Result<Served, ServeError> {
    let mut tokens = Tokens::open(&web.folders.tokens())?;
    if !web.is_near() && tokens.list().next().is_none() {
        return Err(ServeError::NoTokens(web.address));
    }
    let certificate = web.certificate()?;
    let listener = bind(web.address).await?;
    let address = listener
        .local_addr()
        .map_err(|source| ServeError::bind(web.address, source))?;
    let running = Running {
        address: url(address, certificate.is_some()),
        pid: std::process::id(),
        token: Some(tokens.make_local()?.secret().into()),
        fingerprint: certificate
            .as_ref()
            .map(|certificate| certificate.fingerprint.clone()),
    };
    let mut own = StationAddress::of(&running)?;
    own.token = None;
    let file = web.folders.running();
    running.write(&file)?;
    let (ends, ending) = watch::channel(false);
    let without_token = web.without_token.filter(|_| web.is_near());
    let app = App::new(
        handle,
        tokens,
        without_token,
        Reach {
            own,
            names: web.names.clone(),
            listens: (address, certificate.is_some()),
        },
        AppFiles {
            policy: web.policy_file.clone(),
            recordings: web.folders.recordings(),
            buttons: web.folders.buttons(),
            stored: web.folders.files(),
            extras: web.folders.extras(),
        },
        web.virtual_arm.clone(),
        ending,
    );
    tokio::spawn(app.clone().follow_jobs(app.handle.notices()));
    let tls = certificate.map(|certificate| certificate.acceptor);
    Ok(Served {
        address,
        api: StationApi::new(app.clone(), address),
        running,
        file,
        ends,
        serving: tokio::spawn(listen::serve(listener, tls, app)),
    })
}

async fn bind(address: SocketAddr) -> Result<TcpListener, ServeError> {
    let bound = TcpListener::bind(address).await;
    bound.map_err(|source| ServeError::bind(address, source))
}

/// Returns the address for a program on the same machine.
fn url(address: SocketAddr, secure: bool) -> String {
    let scheme = if secure { "https" } else { "http" };
    let ip = match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => Ipv4Addr::LOCALHOST.into(),
        IpAddr::V6(ip) if ip.is_unspecified() => Ipv6Addr::LOCALHOST.into(),
        ip => ip,
    };
    format!("{scheme}://{}", SocketAddr::new(ip, address.port()))
}

impl Served {
    /// Returns the actual address.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Returns the API for the fleet.
    #[must_use]
    pub const fn api(&self) -> &StationApi {
        &self.api
    }

    /// Returns the address for a browser on the same machine.
    #[must_use]
    pub fn url(&self) -> &str {
        &self.running.address
    }

    /// Returns the SHA-256 digest of the certificate, if there is TLS, for people to compare.
    #[must_use]
    pub fn fingerprint(&self) -> Option<&str> {
        self.running.fingerprint.as_deref()
    }

    /// Ends it: notifies all clients and finishes pending responses, within three seconds.
    ///
    /// # Errors
    ///
    /// [`RunningError`] if `station.toml` cannot be removed.
    pub async fn end(mut self) -> Result<(), RunningError> {
        self.ends.send_replace(true);
        // The task ends by itself, or is cancelled with the runtime.
        let _ = (&mut self.serving).await;
        self.running.remove(&self.file)
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.ends.send_replace(true);
        // A remaining file is recognised as stale when a connection fails.
        let _ = self.running.remove(&self.file);
    }
}

/// The error returned when page and API cannot be served.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The address cannot be used.
    #[error("cannot listen on {address}")]
    Bind {
        /// The address.
        address: SocketAddr,
        /// The cause.
        #[source]
        source: io::Error,
    },
    /// Other machines can reach the station, and there are no tokens.
    #[error(
        "{0} is reachable from other machines, but there are no tokens; create one first with `dobot token add`"
    )]
    NoTokens(SocketAddr),
    /// The tokens cannot be read.
    #[error(transparent)]
    Tokens(#[from] TokensError),
    /// There is no certificate.
    #[error(transparent)]
    Tls(#[from] TlsError),
    /// The station's own address is invalid.
    #[error(transparent)]
    Own(#[from] StationAddressError),
    /// `station.toml` cannot be written.
    #[error(transparent)]
    Running(#[from] RunningError),
}

impl ServeError {
    fn bind(address: SocketAddr, source: io::Error) -> Self {
        Self::Bind { address, source }
    }
}
