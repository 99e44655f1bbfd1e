//! The bytes between a station and its client, encrypted or not.

use std::io;
use std::sync::Arc;
use std::time::Duration;

use rustls::pki_types::ServerName;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_rustls::TlsConnector;

use super::trust::{TrustError, client_config};
use super::{CertificateTrust, StationAddress};
use crate::Problem;

/// Bytes both ways.
pub(super) trait Bytes: AsyncRead + AsyncWrite + Send + Unpin {}
impl<T: AsyncRead + AsyncWrite + Send + Unpin> Bytes for T {}

/// Why a station cannot be reached.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ConnectError {
    /// Nobody answers there.
    #[error("there is no station at {address}")]
    Unreachable {
        /// Where.
        address: String,
        /// What the system says.
        #[source]
        source: io::Error,
    },
    /// Somebody is there, and says nothing.
    #[error("{address} does not answer within {} s", PATIENCE.as_secs())]
    Silent {
        /// Where.
        address: String,
    },
    /// Over https it has to be said why one may trust what answers.
    #[error("nothing says why the certificate of {address} may be trusted")]
    NoTrust {
        /// Where.
        address: String,
    },
    /// The token cannot be sent.
    #[error("the token is not one: it has characters that no token has")]
    Token,
    /// The reason to trust it makes no sense.
    #[error(transparent)]
    Trust(#[from] TrustError),
    /// What answers is not who it should be.
    #[error("{address} is not trusted")]
    Untrusted {
        /// Where.
        address: String,
        /// What TLS says.
        #[source]
        source: io::Error,
    },
    /// What answers is no station.
    #[error("what answers at {address} is no station: {why}")]
    NoStation {
        /// Where.
        address: String,
        /// What it did.
        why: String,
    },
    /// The station does not let this client in.
    #[error("{}", .0.detail)]
    Refused(Box<Problem>),
}

impl ConnectError {
    /// Whether no station runs there, rather than one that cannot be talked to.
    #[must_use]
    pub const fn is_nobody(&self) -> bool {
        matches!(self, Self::Unreachable { .. })
    }

    /// What to do about it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Unreachable { .. } => Some("`dobot up` starts one".into()),
            Self::NoTrust { .. } => Some(
                "give `--fingerprint`, which the station prints when it starts, or `--ca FILE`"
                    .into(),
            ),
            Self::Untrusted { .. } => Some(
                "compare the fingerprint with the one that the station printed when it started"
                    .into(),
            ),
            Self::NoStation { .. } | Self::Silent { .. } => {
                Some("is it https rather than http, or another port? 8642 is usual".into())
            }
            Self::Refused(problem) => problem.hint.clone(),
            Self::Trust(_) | Self::Token => None,
        }
    }

    #[expect(
        clippy::needless_pass_by_value,
        reason = "errors come here and end here"
    )]
    pub(super) fn no_station(address: &StationAddress, why: impl ToString) -> Self {
        Self::NoStation {
            address: address.to_string(),
            why: why.to_string(),
        }
    }
}

/// Does something that takes a station no time.
pub(super) async fn soon<T>(
    address: &StationAddress,
    action: impl Future<Output = Result<T, ConnectError>>,
) -> Result<T, ConnectError> {
    let done = timeout(PATIENCE, action).await;
    done.unwrap_or_else(|_| {
        Err(ConnectError::Silent {
            address: address.to_string(),
        })
    })
}

/// Opens the way to a station.
pub(super) async fn open(address: &StationAddress) -> Result<Box<dyn Bytes>, ConnectError> {
    let unreachable = |source| ConnectError::Unreachable {
        address: address.to_string(),
        source,
    };
    let tcp = TcpStream::connect((address.host(), address.port())).await;
    let tcp = tcp.map_err(unreachable)?;
    // A held button says so every few milliseconds; none of it may wait for the next.
    tcp.set_nodelay(true).map_err(unreachable)?;
    if !address.is_encrypted() {
        return Ok(Box::new(tcp));
    }
    let no_trust = || ConnectError::NoTrust {
        address: address.to_string(),
    };
    encrypt(address, address.trust.as_ref().ok_or_else(no_trust)?, tcp).await
}

async fn encrypt(
    address: &StationAddress,
    trust: &CertificateTrust,
    tcp: TcpStream,
) -> Result<Box<dyn Bytes>, ConnectError> {
    let connector = TlsConnector::from(Arc::new(client_config(trust)?));
    let name = ServerName::try_from(address.host().to_owned());
    let name = name.map_err(|it| ConnectError::no_station(address, it))?;
    match connector.connect(name, tcp).await {
        Ok(stream) => Ok(Box::new(stream)),
        Err(source) if is_certificate(&source) => Err(ConnectError::Untrusted {
            address: address.to_string(),
            source,
        }),
        Err(source) => Err(ConnectError::no_station(address, source)),
    }
}

fn is_certificate(error: &io::Error) -> bool {
    let tls = error.get_ref().and_then(|it| it.downcast_ref());
    matches!(tls, Some(rustls::Error::InvalidCertificate(_)))
}

const PATIENCE: Duration = Duration::from_secs(5);
