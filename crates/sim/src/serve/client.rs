//! The client that has a served arm.

use std::io;

use tokio::io::AsyncReadExt;
use tokio::net::TcpStream;

#[cfg(unix)]
use crate::pty::PtyClient;

/// The one client that has the arm.
#[derive(Debug)]
pub(super) enum Client {
    Tcp(TcpStream),
    #[cfg(unix)]
    Pty(PtyClient),
}

impl Client {
    /// Waits for bytes; none means that it has disconnected. Cancellation safe.
    pub(super) async fn read(&mut self, buffer: &mut Vec<u8>) -> io::Result<usize> {
        buffer.reserve(READ_LEN);
        match self {
            Self::Tcp(stream) => stream.read_buf(buffer).await,
            #[cfg(unix)]
            Self::Pty(client) => client.read_buf(buffer).await,
        }
    }

    /// Writes as many bytes as fit and returns their number.
    pub(super) fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Tcp(stream) => stream.try_write(bytes),
            #[cfg(unix)]
            Self::Pty(client) => Ok(client.try_write(bytes)),
        }
    }
}

/// A few packets.
const READ_LEN: usize = 256;
