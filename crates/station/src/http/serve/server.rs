//! The web side of the station, as a whole.

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

/// How page and API are served.
#[derive(Clone, Debug)]
pub struct Web {
    /// Where; port 0 takes a free one.
    pub address: SocketAddr,
    /// Certificate and key. When absent, there is no TLS on loopback, and a certificate that the
    /// station makes for itself elsewhere.
    pub tls: Option<TlsFiles>,
    /// Names that the station goes by, besides its addresses.
    pub names: Vec<String>,
    /// What those on loopback may do who come without a token; elsewhere nobody may do anything.
    pub without_token: Option<Role>,
    /// Where a policy is kept that a client puts in place.
    pub policy_file: PathBuf,
    /// The station's own virtual arm, if the arm is that.
    pub virtual_arm: Option<OwnVirtualArm>,
    /// Where tokens and the own certificate are, and where the station says that it runs.
    pub folders: Folders,
}

impl Web {
    /// Without TLS on loopback, where everyone may do everything; with TLS and tokens elsewhere.
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

/// Page and API, being served; they end when this is dropped.
#[derive(Debug)]
pub struct Served {
    address: SocketAddr,
    api: StationApi,
    running: Running,
    file: PathBuf,
    ends: watch::Sender<bool>,
    serving: JoinHandle<()>,
}

/// Serves page and API, and says in `station.toml` that the station runs.
///
/// # Errors
///
/// [`ServeError`]; nothing is served then.
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
        },
        AppFiles {
            policy: web.policy_file.clone(),
            recordings: web.folders.recordings(),
        },
        web.virtual_arm.clone(),
        ending,
    );
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

/// Where a program on the same machine finds the station.
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
    /// The address that it really got.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// How the fleet asks the station for something.
    #[must_use]
    pub const fn api(&self) -> &StationApi {
        &self.api
    }

    /// Where to go with a browser on the same machine.
    #[must_use]
    pub fn url(&self) -> &str {
        &self.running.address
    }

    /// The SHA-256 digest of the certificate, where there is TLS: for people to compare.
    #[must_use]
    pub fn fingerprint(&self) -> Option<&str> {
        self.running.fingerprint.as_deref()
    }

    /// Ends it: everyone is told, and what is being answered is answered, for up to three seconds.
    ///
    /// # Errors
    ///
    /// [`RunningError`] where `station.toml` cannot be removed.
    pub async fn end(mut self) -> Result<(), RunningError> {
        self.ends.send_replace(true);
        // It ends by itself, or is cancelled with everything else.
        let _ = (&mut self.serving).await;
        self.running.remove(&self.file)
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.ends.send_replace(true);
        // A file that stays is found to be stale by those who try to connect.
        let _ = self.running.remove(&self.file);
    }
}

/// Why page and API cannot be served.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The address cannot be used.
    #[error("{address} cannot be served")]
    Bind {
        /// Which address.
        address: SocketAddr,
        /// Why.
        #[source]
        source: io::Error,
    },
    /// Others could reach the station, and nobody could say who he is.
    #[error("{0} can be reached from other machines, and there are no tokens; make one first")]
    NoTokens(SocketAddr),
    /// The tokens cannot be read.
    #[error(transparent)]
    Tokens(#[from] TokensError),
    /// There is no certificate.
    #[error(transparent)]
    Tls(#[from] TlsError),
    /// The station does not reach itself.
    #[error(transparent)]
    Own(#[from] StationAddressError),
    /// It cannot be said where the station is.
    #[error(transparent)]
    Running(#[from] RunningError),
}

impl ServeError {
    fn bind(address: SocketAddr, source: io::Error) -> Self {
        Self::Bind { address, source }
    }
}
