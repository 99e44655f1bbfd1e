//! The way that bytes travel to an arm and back.

#[cfg(unix)]
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::pin::Pin;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::time::Instant;

use crate::{Address, LinkError, OpenError, Peer, open};

/// The way that bytes travel to an arm and back, with a clock: a serial port, TCP or a peer in this
/// process, whose time passes only when somebody waits for it.
///
/// It knows nothing about packets: [`Connection`](crate::Connection) puts a session on top of it.
#[derive(Debug)]
pub struct Link {
    way: Way,
    /// Bytes on their way out, so that a cancelled wait tears no packet apart.
    outgoing: Vec<u8>,
    /// The port once more, for those who have to reach the arm when this link cannot.
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

/// What bytes travel over.
enum Way {
    Stream {
        stream: Box<dyn Stream>,
        opened: Instant,
    },
    Peer(Box<dyn Peer>),
}

/// Anything that carries bytes both ways.
trait Stream: AsyncRead + AsyncWrite + Unpin + Send {}

impl<T: AsyncRead + AsyncWrite + Unpin + Send> Stream for T {}

impl Link {
    /// Opens a serial port or a TCP connection.
    ///
    /// # Errors
    ///
    /// [`OpenError`], with what to do about it.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn open(address: &Address) -> Result<Self, OpenError> {
        match address {
            Address::Virtual => Err(OpenError::Virtual),
            Address::Serial { path, baud } => Self::over_serial(path, *baud),
            Address::Tcp { host, port } => Self::over_tcp(host, *port).await,
        }
    }

    #[cfg(unix)]
    fn over_serial(path: &str, baud: u32) -> Result<Self, OpenError> {
        let (stream, port) = open::serial(path, baud)?;
        Ok(Self::over_stream(stream).with_port(port.into()))
    }

    #[cfg(not(unix))]
    fn over_serial(path: &str, baud: u32) -> Result<Self, OpenError> {
        Ok(Self::over_stream(open::serial(path, baud)?))
    }

    async fn over_tcp(host: &str, port: u16) -> Result<Self, OpenError> {
        let stream = open::tcp(host, port).await?;
        #[cfg(unix)]
        if let Ok(again) = stream.as_fd().try_clone_to_owned() {
            return Ok(Self::over_stream(stream).with_port(again));
        }
        Ok(Self::over_stream(stream))
    }

    /// A link over anything that carries bytes both ways.
    pub fn over_stream(stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static) -> Self {
        Self::new(Way::Stream {
            stream: Box::new(stream),
            opened: Instant::now(),
        })
    }

    /// A link with an arm in this process.
    pub fn over_peer(peer: impl Peer + 'static) -> Self {
        Self::new(Way::Peer(Box::new(peer)))
    }

    const fn new(way: Way) -> Self {
        Self {
            way,
            outgoing: Vec::new(),
            #[cfg(unix)]
            port: None,
        }
    }

    /// The same, with the port that its bytes go through: see [`Link::port`].
    #[cfg(unix)]
    #[must_use]
    pub fn with_port(mut self, port: OwnedFd) -> Self {
        self.port = Some(port);
        self
    }

    /// The serial port or the TCP connection as another process can have it, to say the last words
    /// to an arm whose program is gone; none for an arm in this process. Whoever writes to it while
    /// the link is in use tears packets apart.
    #[cfg(unix)]
    #[must_use]
    pub fn port(&self) -> Option<BorrowedFd<'_>> {
        self.port.as_ref().map(AsFd::as_fd)
    }

    /// The time since the link was opened, by its own clock.
    #[must_use]
    pub fn now(&self) -> Duration {
        match &self.way {
            Way::Stream { opened, .. } => opened.elapsed(),
            Way::Peer(peer) => peer.now(),
        }
    }

    /// Takes bytes; they leave while somebody waits in [`Link::receive`] or [`Link::flush`], or with
    /// [`Link::push`].
    pub fn send(&mut self, bytes: &[u8]) {
        self.outgoing.extend_from_slice(bytes);
    }

    /// Sends at once what the link takes without waiting; the rest leaves as after [`Link::send`].
    /// What goes wrong is told by whoever waits next.
    pub fn push(&mut self) {
        let Way::Stream { stream, .. } = &mut self.way else {
            return;
        };
        let mut nobody = Context::from_waker(Waker::noop());
        while !self.outgoing.is_empty() {
            match Pin::new(&mut **stream).poll_write(&mut nobody, &self.outgoing) {
                Poll::Ready(Ok(sent @ 1..)) => drop(self.outgoing.drain(..sent)),
                _ => break,
            }
        }
    }

    /// Sends and receives until bytes came, which are appended to `incoming`, or until `until`.
    /// Returns whether the link is still open. A wait that is cancelled loses nothing.
    ///
    /// # Errors
    ///
    /// [`LinkError::Broken`].
    pub async fn receive(
        &mut self,
        until: Duration,
        incoming: &mut Vec<u8>,
    ) -> Result<bool, LinkError> {
        match &mut self.way {
            Way::Peer(peer) => {
                peer.send(&self.outgoing);
                self.outgoing.clear();
                Ok(peer.receive(until, incoming))
            }
            Way::Stream { stream, opened } => {
                let deadline = opened.checked_add(until);
                carry(stream, &mut self.outgoing, incoming, deadline).await
            }
        }
    }

    /// Sends what waits, without waiting for anything from the arm.
    ///
    /// # Errors
    ///
    /// [`LinkError`] when the link does not take it.
    pub async fn flush(&mut self) -> Result<(), LinkError> {
        match &mut self.way {
            Way::Peer(peer) => peer.send(&self.outgoing),
            Way::Stream { stream, .. } => {
                let sending = async {
                    stream.write_all(&self.outgoing).await?;
                    stream.flush().await
                };
                match tokio::time::timeout(FLUSH_TIMEOUT, sending).await {
                    Ok(sent) => sent.map_err(LinkError::Broken)?,
                    Err(_) => return Err(LinkError::Closed),
                }
            }
        }
        self.outgoing.clear();
        Ok(())
    }
}

impl std::fmt::Debug for Way {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Stream { opened, .. } => f
                .debug_struct("Stream")
                .field("opened", opened)
                .finish_non_exhaustive(),
            Self::Peer(peer) => f.debug_tuple("Peer").field(peer).finish(),
        }
    }
}

async fn carry(
    stream: &mut Box<dyn Stream>,
    outgoing: &mut Vec<u8>,
    incoming: &mut Vec<u8>,
    deadline: Option<Instant>,
) -> Result<bool, LinkError> {
    let (mut reader, mut writer) = tokio::io::split(stream);
    loop {
        tokio::select! {
            sent = writer.write(outgoing), if !outgoing.is_empty() => {
                let sent = sent.map_err(LinkError::Broken)?;
                if sent == 0 {
                    return Ok(false);
                }
                outgoing.drain(..sent);
            }
            received = reader.read_buf(incoming) => {
                return Ok(received.map_err(LinkError::Broken)? > 0);
            }
            () = wait_until(deadline) => return Ok(true),
        }
    }
}

async fn wait_until(deadline: Option<Instant>) {
    match deadline {
        Some(deadline) => tokio::time::sleep_until(deadline).await,
        None => std::future::pending().await,
    }
}

/// Longer than a packet takes at 9600 baud; a port that takes none by then is dead.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn what_is_pushed_leaves_before_anybody_waits() {
        let (near, mut far) = tokio::io::duplex(64);
        let mut link = Link::over_stream(near);
        link.send(b"abc");
        link.push();
        let mut bytes = [0; 3];
        far.read_exact(&mut bytes).await.expect("it has left");
        assert_eq!(&bytes, b"abc");
    }

    #[tokio::test]
    async fn what_the_link_does_not_take_at_once_leaves_later_in_order() {
        let (near, mut far) = tokio::io::duplex(2);
        let mut link = Link::over_stream(near);
        link.send(b"abcde");
        link.push();
        let mut bytes = [0; 5];
        let (read, flushed) = tokio::join!(far.read_exact(&mut bytes), link.flush());
        read.expect("all of it leaves");
        flushed.expect("the other end reads");
        assert_eq!(&bytes, b"abcde");
    }
}
