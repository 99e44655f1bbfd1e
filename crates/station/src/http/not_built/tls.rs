//! TLS, in a build without it: a station is served on loopback only.

use std::convert::Infallible;
use std::io;
use std::net::IpAddr;
use std::path::Path;

use dobot_api::NotBuilt;
use tokio::net::TcpStream;

use crate::TlsFiles;

/// A certificate, which this build cannot use.
#[derive(Debug)]
pub(super) struct Certificate {
    pub(super) acceptor: TlsAcceptor,
    pub(super) fingerprint: String,
}

/// A TLS acceptor, which this build cannot have.
#[derive(Clone, Debug)]
pub(super) struct TlsAcceptor(Infallible);

/// The error returned when a station cannot be served with TLS.
pub use dobot_api::NotBuilt as TlsError;

impl Certificate {
    /// Fails with [`NotBuilt`].
    pub(super) fn read(_: &TlsFiles) -> Result<Self, TlsError> {
        Err(NotBuilt("TLS, which addresses beyond this machine need"))
    }

    /// Fails with [`NotBuilt`].
    pub(super) fn own(_: &Path, _: &[String], _: IpAddr) -> Result<Self, TlsError> {
        Err(NotBuilt("TLS, which addresses beyond this machine need"))
    }
}

impl TlsAcceptor {
    #[expect(clippy::unused_async, reason = "with the feature `full` it waits")]
    pub(super) async fn accept(&self, _: TcpStream) -> io::Result<TcpStream> {
        match self.0 {}
    }
}
