//! The byte stream between a station and its client, encrypted or not.

use std::io;
use std::time::Duration;

use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio::time::timeout;

#[cfg(not(feature = "tls"))]
use super::CertificateTrust;
use super::StationAddress;
#[cfg(feature = "tls")]
use super::tls::encrypt;
use crate::{NotBuilt, Problem};

/// A bidirectional byte stream.
pub(super) trait Bytes: AsyncRead + AsyncWrite + Send + Unpin {}
impl<T: AsyncRead + AsyncWrite + Send + Unpin> Bytes for T {}

/// The error returned when a station cannot be reached.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ConnectError {
    /// Nothing answers.
    #[error("there is no station at {address}")]
    Unreachable {
        /// The address.
        address: String,
        /// The operating system's error.
        #[source]
        source: io::Error,
    },
    /// The connection was accepted, but no answer came.
    #[error("{address} did not respond within {} s", PATIENCE.as_secs())]
    Silent {
        /// The address.
        address: String,
    },
    /// Over https, the reason to trust the certificate is required.
    #[error("there is no reason to trust the certificate of {address}")]
    NoTrust {
        /// The address.
        address: String,
    },
    /// The station is served over https, and this program is built without TLS.
    #[error("{address} is encrypted, and {part}")]
    NotBuilt {
        /// The address.
        address: String,
        /// The missing part.
        part: NotBuilt,
    },
    /// The token cannot be sent in a header.
    #[error("the token has characters that are not allowed")]
    Token,
    /// The file of certificates is unusable.
    #[error(transparent)]
    Trust(#[from] TrustError),
    /// The certificate is not the trusted one.
    #[error("{address} is not trusted")]
    Untrusted {
        /// The address.
        address: String,
        /// The TLS error.
        #[source]
        source: io::Error,
    },
    /// The server is not a station.
    #[error("the server at {address} is not a station: {why}")]
    NoStation {
        /// The address.
        address: String,
        /// What it answered.
        why: String,
    },
    /// The station refused access.
    #[error("{}", .0.detail)]
    Refused(Box<Problem>),
}

impl ConnectError {
    /// Returns whether no station runs there (as opposed to one that cannot be used).
    #[must_use]
    pub const fn is_not_running(&self) -> bool {
        matches!(self, Self::Unreachable { .. })
    }

    /// Returns a hint on how to fix it.
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
                Some("check the scheme (https or http) and the port (default 8642)".into())
            }
            Self::NotBuilt { .. } => Some(NotBuilt::HINT.into()),
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

/// The error returned for an unusable file of certificates.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TrustError {
    /// The file cannot be read.
    #[error("cannot read certificates from {file}: {why}")]
    Unreadable {
        /// The file.
        file: String,
        /// The reason.
        why: String,
    },
    /// The file has no certificate.
    #[error("there is no certificate in {file}; a PEM file needs at least one")]
    Empty {
        /// The file.
        file: String,
    },
}

/// Applies the timeout of a quick operation.
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

/// Opens a connection to a station.
pub(super) async fn open(address: &StationAddress) -> Result<Box<dyn Bytes>, ConnectError> {
    let unreachable = |source| ConnectError::Unreachable {
        address: address.to_string(),
        source,
    };
    let tcp = TcpStream::connect((address.host(), address.port())).await;
    let tcp = tcp.map_err(unreachable)?;
    // A held button repeats every few milliseconds; none may wait for the next.
    tcp.set_nodelay(true).map_err(unreachable)?;
    if !address.is_encrypted() {
        return Ok(Box::new(tcp));
    }
    let no_trust = || ConnectError::NoTrust {
        address: address.to_string(),
    };
    encrypt(address, address.trust.as_ref().ok_or_else(no_trust)?, tcp).await
}

#[cfg(not(feature = "tls"))]
#[expect(clippy::unused_async, reason = "with the feature `tls` it waits")]
async fn encrypt(
    address: &StationAddress,
    _: &CertificateTrust,
    _: TcpStream,
) -> Result<Box<dyn Bytes>, ConnectError> {
    Err(ConnectError::NotBuilt {
        address: address.to_string(),
        part: NotBuilt("TLS"),
    })
}

const PATIENCE: Duration = Duration::from_secs(5);
