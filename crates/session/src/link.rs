//! The byte transport to an arm and back.

use std::io::{self, ErrorKind};
#[cfg(unix)]
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::pin::Pin;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::time::Instant;

use crate::{Address, LinkError, OpenError, Peer, open};

/// A byte transport to an arm and back, with a clock: a serial port, TCP or a peer in this process,
/// whose time passes only while the caller waits.
///
/// It does not interpret packets: [`Connection`](crate::Connection) puts a session on top of it.
#[derive(Debug)]
pub struct Link {
    transport: Transport,
    /// Bytes not sent yet. They outlive a cancelled wait, so that no packet is split.
    outgoing: Vec<u8>,
    /// Bytes received from a peer before the caller waited for them.
    early: Vec<u8>,
    /// A second handle to the port, for another process that must reach the arm if this one fails.
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

/// The medium that carries the bytes.
enum Transport {
    Stream {
        stream: Box<dyn Stream>,
        opened: Instant,
    },
    Peer(Box<dyn Peer>, Option<PeerClock>),
}

/// The clock of a peer whose time is tied to real time.
#[derive(Clone, Copy, Debug)]
struct PeerClock {
    /// The start in real time, and the peer's time at that moment.
    began: (Instant, Duration),
    /// The peer's time relative to real time.
    speed: f64,
}

/// A bidirectional byte stream.
trait Stream: AsyncRead + AsyncWrite + Unpin + Send {}

impl<T: AsyncRead + AsyncWrite + Unpin + Send> Stream for T {}

impl Link {
    /// Opens a serial port or a TCP connection.
    ///
    /// # Errors
    ///
    /// Returns an [`OpenError`], which has a hint.
    ///
    /// # Panics
    ///
    /// If called outside of a tokio runtime.
    pub async fn open(address: &Address) -> Result<Self, OpenError> {
        let opened = match address {
            Address::Virtual => Err(OpenError::Virtual),
            Address::Serial { path, baud } => Self::over_serial(path, *baud),
            Address::Tcp { host, port } => Self::over_tcp(host, *port).await,
        };
        match &opened {
            Ok(_) => tracing::debug!(%address, "the link is open"),
            Err(error) => tracing::debug!(%address, %error, "the link cannot be opened"),
        }
        opened
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

    /// Creates a link over any bidirectional byte stream.
    pub fn over_stream(stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static) -> Self {
        Self::new(Transport::Stream {
            stream: Box::new(stream),
            opened: Instant::now(),
        })
    }

    /// Creates a link to an arm in this process.
    pub fn over_peer(peer: impl Peer + 'static) -> Self {
        Self::new(Transport::Peer(Box::new(peer), None))
    }

    /// Creates a link to an arm in this process that runs at `speed` times real time if the link is
    /// polled often enough; otherwise its time and that of the link pass more slowly.
    ///
    /// # Panics
    ///
    /// If `speed` is not above 0.
    pub fn over_paced_peer(peer: impl Peer + 'static, speed: f64) -> Self {
        assert!(speed > 0.0, "the speed must be above 0");
        let began = (Instant::now(), peer.now());
        Self::new(Transport::Peer(
            Box::new(peer),
            Some(PeerClock { began, speed }),
        ))
    }

    const fn new(transport: Transport) -> Self {
        Self {
            transport,
            outgoing: Vec::new(),
            early: Vec::new(),
            #[cfg(unix)]
            port: None,
        }
    }

    /// Attaches a second handle to the port: see [`Link::port`].
    #[cfg(unix)]
    #[must_use]
    pub fn with_port(mut self, port: OwnedFd) -> Self {
        self.port = Some(port);
        self
    }

    /// The serial port or TCP connection for use by another process, which stops the arm when this
    /// one is gone; `None` for an arm in this process. Writing to it while the link is in use splits
    /// packets.
    #[cfg(unix)]
    #[must_use]
    pub fn port(&self) -> Option<BorrowedFd<'_>> {
        self.port.as_ref().map(AsFd::as_fd)
    }

    /// The time since the link was opened, on its own clock.
    #[must_use]
    pub fn now(&self) -> Duration {
        match &self.transport {
            Transport::Stream { opened, .. } => opened.elapsed(),
            Transport::Peer(peer, None) => peer.now(),
            // Time stands still until everything that is due has been received.
            Transport::Peer(peer, Some(pace)) => {
                let now = pace.now();
                if now < peer.next() { now } else { peer.now() }
            }
        }
    }

    /// Queues bytes. They are sent by [`Link::receive`], [`Link::flush`] or [`Link::push`].
    pub fn send(&mut self, bytes: &[u8]) {
        self.outgoing.extend_from_slice(bytes);
    }

    /// Sends as much as the link accepts without waiting; the rest stays queued. Errors are returned by
    /// the next call that waits.
    pub fn push(&mut self) {
        let now = self.now();
        let stream = match &mut self.transport {
            Transport::Stream { stream, .. } => stream,
            Transport::Peer(_, None) => return,
            Transport::Peer(peer, Some(_)) => {
                // The next wait reports whether the peer is still there.
                let _ = peer.receive(now, &mut self.early);
                peer.send(&self.outgoing);
                self.outgoing.clear();
                return;
            }
        };
        let mut context = Context::from_waker(Waker::noop());
        while !self.outgoing.is_empty() {
            match Pin::new(&mut **stream).poll_write(&mut context, &self.outgoing) {
                Poll::Ready(Ok(sent @ 1..)) => drop(self.outgoing.drain(..sent)),
                _ => break,
            }
        }
    }

    /// Sends and receives until bytes arrive, which are appended to `incoming`, or until `until`.
    /// Returns whether the link is still open. Cancellation safe.
    ///
    /// # Errors
    ///
    /// Returns [`LinkError::Broken`], or [`LinkError::Closed`] if the other end is gone while sending.
    pub async fn receive(
        &mut self,
        until: Duration,
        incoming: &mut Vec<u8>,
    ) -> Result<bool, LinkError> {
        self.push();
        if !self.early.is_empty() {
            incoming.append(&mut self.early);
            return Ok(true);
        }
        match &mut self.transport {
            Transport::Peer(peer, None) => {
                peer.send(&self.outgoing);
                self.outgoing.clear();
                Ok(peer.receive(until, incoming))
            }
            Transport::Peer(peer, Some(pace)) => {
                let until = until.min(peer.next());
                wait_until(pace.instant(until)).await;
                Ok(peer.receive(until, incoming))
            }
            Transport::Stream { stream, opened } => {
                transfer(
                    stream,
                    &mut self.outgoing,
                    incoming,
                    opened.checked_add(until),
                )
                .await
            }
        }
    }

    /// Sends the queued bytes without waiting for the arm to respond.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if the link does not accept them.
    pub async fn flush(&mut self) -> Result<(), LinkError> {
        self.push();
        match &mut self.transport {
            Transport::Peer(peer, _) => peer.send(&self.outgoing),
            Transport::Stream { stream, .. } => {
                let sending = async {
                    stream.write_all(&self.outgoing).await?;
                    stream.flush().await
                };
                match tokio::time::timeout(FLUSH_TIMEOUT, sending).await {
                    Ok(sent) => sent.map_err(link_error)?,
                    Err(_) => return Err(LinkError::Closed),
                }
            }
        }
        self.outgoing.clear();
        Ok(())
    }
}

impl PeerClock {
    fn now(&self) -> Duration {
        let (began, at) = self.began;
        at + began.elapsed().mul_f64(self.speed)
    }

    /// The real time of a peer time; `None` if it is beyond the clock's range.
    fn instant(&self, time: Duration) -> Option<Instant> {
        let (began, at) = self.began;
        let later_s = time.saturating_sub(at).as_secs_f64() / self.speed;
        let later = Duration::try_from_secs_f64(later_s).ok()?;
        began.checked_add(later)
    }
}

impl std::fmt::Debug for Transport {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Stream { opened, .. } => f
                .debug_struct("Stream")
                .field("opened", opened)
                .finish_non_exhaustive(),
            Self::Peer(peer, pace) => f.debug_tuple("Peer").field(peer).field(pace).finish(),
        }
    }
}

async fn transfer(
    stream: &mut Box<dyn Stream>,
    outgoing: &mut Vec<u8>,
    incoming: &mut Vec<u8>,
    deadline: Option<Instant>,
) -> Result<bool, LinkError> {
    let (mut reader, mut writer) = tokio::io::split(stream);
    loop {
        tokio::select! {
            sent = writer.write(outgoing), if !outgoing.is_empty() => {
                let sent = sent.map_err(link_error)?;
                if sent == 0 {
                    return Ok(false);
                }
                outgoing.drain(..sent);
            }
            received = reader.read_buf(incoming) => {
                return Ok(received.map_err(link_error)? > 0);
            }
            () = wait_until(deadline) => return Ok(true),
        }
    }
}

/// Converts an I/O error. TCP reports a close as a reset if the other end had unread data.
fn link_error(error: io::Error) -> LinkError {
    match error.kind() {
        ErrorKind::ConnectionReset | ErrorKind::ConnectionAborted | ErrorKind::BrokenPipe => {
            LinkError::Closed
        }
        _ => LinkError::Broken(error),
    }
}

async fn wait_until(deadline: Option<Instant>) {
    match deadline {
        Some(deadline) => tokio::time::sleep_until(deadline).await,
        None => std::future::pending().await,
    }
}

/// Longer than a packet takes at 9600 baud; a port that accepts none in this time is dead.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn pushed_bytes_are_sent_before_any_wait() {
        let (near, mut far) = tokio::io::duplex(64);
        let mut link = Link::over_stream(near);
        link.send(b"abc");
        link.push();
        let mut bytes = [0; 3];
        far.read_exact(&mut bytes)
            .await
            .expect("the bytes were sent");
        assert_eq!(&bytes, b"abc");
    }

    /// Sends a byte every 80 ms and records when it receives bytes.
    #[derive(Debug, Default)]
    struct PeriodicPeer {
        now: Duration,
        received: std::sync::Arc<std::sync::Mutex<Vec<Duration>>>,
    }

    impl Peer for PeriodicPeer {
        fn now(&self) -> Duration {
            self.now
        }

        fn next(&self) -> Duration {
            let periods = u32::try_from(self.now.as_millis() / 80).expect("a short test");
            Duration::from_millis(80) * (periods + 1)
        }

        fn send(&mut self, bytes: &[u8]) {
            if !bytes.is_empty() {
                self.received
                    .lock()
                    .expect("the lock is not poisoned")
                    .push(self.now);
            }
        }

        fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
            let next = self.next();
            self.now = self.now.max(until.min(next));
            if self.now == next {
                bytes.push(0xA5);
            }
            true
        }
    }

    #[tokio::test(start_paused = true)]
    async fn a_paced_peer_runs_at_its_speed_and_receives_pushed_bytes_immediately() {
        let peer = PeriodicPeer::default();
        let received = peer.received.clone();
        let began = Instant::now();
        let mut link = Link::over_paced_peer(peer, 1000.0);
        let mut incoming = Vec::new();
        for n in 1..=100_u32 {
            let open = link.receive(Duration::MAX, &mut incoming).await;
            assert!(open.expect("the peer is there"));
            assert_eq!(incoming.len(), usize::try_from(n).expect("small"));
            let sent = Duration::from_millis(80) * n;
            assert!((sent..sent + Duration::from_millis(80)).contains(&link.now()));
        }
        // 8 s of its time; the clock of the runtime counts whole milliseconds.
        let took = began.elapsed();
        assert!((8..=10).contains(&took.as_millis()), "{took:?}");
        let mut slow = Link::over_paced_peer(
            PeriodicPeer {
                received: received.clone(),
                ..PeriodicPeer::default()
            },
            2.0,
        );
        tokio::time::advance(Duration::from_millis(15)).await;
        slow.send(b"x");
        slow.push();
        assert_eq!(
            *received.lock().expect("the lock is not poisoned"),
            [Duration::from_millis(30)]
        );
        assert_eq!(slow.now(), Duration::from_millis(30));
        tokio::time::advance(Duration::from_millis(5)).await;
        assert_eq!(slow.now(), Duration::from_millis(40));
        // The time of a peer that is not polled does not advance.
        tokio::time::advance(Duration::from_secs(9)).await;
        assert_eq!(slow.now(), Duration::from_millis(30));
        let open = slow.receive(Duration::MAX, &mut incoming).await;
        assert!(open.expect("the peer is there"));
        assert_eq!(slow.now(), Duration::from_millis(80));
        assert_eq!(incoming.len(), 101);
    }

    #[tokio::test]
    async fn bytes_that_the_link_does_not_accept_are_sent_later_in_order() {
        let (near, mut far) = tokio::io::duplex(2);
        let mut link = Link::over_stream(near);
        link.send(b"abcde");
        link.push();
        let mut bytes = [0; 5];
        let (read, flushed) = tokio::join!(far.read_exact(&mut bytes), link.flush());
        read.expect("all bytes are sent");
        flushed.expect("the other end reads");
        assert_eq!(&bytes, b"abcde");
    }
}
