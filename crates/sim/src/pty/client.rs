//! The program at the other end of a virtual serial port.

use std::io;
use std::os::fd::OwnedFd;
use std::pin::Pin;
use std::task::{Context, Poll, ready};

use rustix::io::Errno;
use tokio::io::unix::AsyncFd;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};

/// The client that has a virtual serial port open; its stream ends when it closes the port.
#[derive(Debug)]
pub struct PtyClient {
    master: AsyncFd<OwnedFd>,
}

impl PtyClient {
    pub(super) const fn new(master: AsyncFd<OwnedFd>) -> Self {
        Self { master }
    }

    /// Writes as many bytes as fit and returns their number.
    pub(crate) fn try_write(&self, bytes: &[u8]) -> usize {
        rustix::io::write(self.master.get_ref(), bytes).unwrap_or(0)
    }

    /// Bytes; none means that the client closed the port.
    fn poll_bytes(&self, context: &mut Context<'_>, buffer: &mut [u8]) -> Poll<io::Result<usize>> {
        loop {
            let mut guard = ready!(self.master.poll_read_ready(context))?;
            let left = guard.ready().is_read_closed();
            match rustix::io::read(self.master.get_ref(), &mut *buffer) {
                Ok(count) => return Poll::Ready(Ok(count)),
                Err(Errno::IO) => return Poll::Ready(Ok(0)),
                // It closed the port, and somebody has opened it since.
                Err(Errno::RETRY_DELAY) if left => return Poll::Ready(Ok(0)),
                Err(Errno::RETRY_DELAY) => guard.clear_ready(),
                Err(Errno::INTR) => {}
                Err(error) => return Poll::Ready(Err(error.into())),
            }
        }
    }
}

impl AsyncRead for PtyClient {
    fn poll_read(
        self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let count = ready!(self.poll_bytes(context, buffer.initialize_unfilled()))?;
        buffer.advance(count);
        Poll::Ready(Ok(()))
    }
}

impl AsyncWrite for PtyClient {
    fn poll_write(
        self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        loop {
            let mut guard = ready!(self.master.poll_write_ready(context))?;
            match rustix::io::write(self.master.get_ref(), bytes) {
                Ok(count) => return Poll::Ready(Ok(count)),
                Err(Errno::RETRY_DELAY) => guard.clear_ready(),
                Err(Errno::INTR) => {}
                Err(error) => return Poll::Ready(Err(error.into())),
            }
        }
    }

    /// What is written is at the client's end.
    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
        Poll::Ready(Ok(()))
    }

    /// The port cannot be half closed.
    fn poll_shutdown(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
        Poll::Ready(Ok(()))
    }
}
