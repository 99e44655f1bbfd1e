//! The client that has a served arm.

use std::io;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use tokio::io::{AsyncReadExt, AsyncWriteExt, DuplexStream};
use tokio::net::TcpStream;
use tokio::task::unconstrained;

#[cfg(unix)]
use crate::pty::PtyClient;

/// The one client that has the arm.
#[derive(Debug)]
pub(super) enum Client {
    Tcp(TcpStream),
    #[cfg(unix)]
    Pty(PtyClient),
    InProcess(DuplexStream),
}

impl Client {
    /// Waits for bytes; none means that it has left. Safe to cancel.
    pub(super) async fn read(&mut self, buffer: &mut Vec<u8>) -> io::Result<usize> {
        buffer.reserve(READ_LEN);
        match self {
            Self::Tcp(stream) => stream.read_buf(buffer).await,
            #[cfg(unix)]
            Self::Pty(client) => client.read_buf(buffer).await,
            Self::InProcess(stream) => stream.read_buf(buffer).await,
        }
    }

    /// Writes what fits, and says how much that is.
    pub(super) fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Tcp(stream) => stream.try_write(bytes),
            #[cfg(unix)]
            Self::Pty(client) => Ok(client.try_write(bytes)),
            Self::InProcess(stream) => at_once(stream.write(bytes)).unwrap_or(Ok(0)),
        }
    }
}

/// What a future has ready, if it has; whoever else is interested in it has to ask again.
pub(super) fn at_once<F: Future>(future: F) -> Option<F::Output> {
    // Without regard to what the task has done so far: "not now" would be taken for "never".
    let mut future = pin!(unconstrained(future));
    match future
        .as_mut()
        .poll(&mut Context::from_waker(Waker::noop()))
    {
        Poll::Ready(output) => Some(output),
        Poll::Pending => None,
    }
}

/// A few packets.
const READ_LEN: usize = 256;
