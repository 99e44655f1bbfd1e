//! The way that bytes travel to an arm and back.

use std::io::{self, ErrorKind};
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
    transport: Transport,
    /// Bytes on their way out, so that a cancelled wait tears no packet apart.
    outgoing: Vec<u8>,
    /// Bytes that a peer said before somebody waited for them.
    early: Vec<u8>,
    /// The port once more, for those who have to reach the arm when this link cannot.
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

/// What bytes travel over.
enum Transport {
    Stream {
        stream: Box<dyn Stream>,
        opened: Instant,
    },
    Peer(Box<dyn Peer>, Option<PeerClock>),
}

/// How fast time passes for a peer that lives no faster.
#[derive(Clone, Copy, Debug)]
struct PeerClock {
    /// When that began, and what time it was for the peer.
    began: (Instant, Duration),
    /// So many times as fast as a clock.
    times: f64,
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

    /// A link over anything that carries bytes both ways.
    pub fn over_stream(stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static) -> Self {
        Self::new(Transport::Stream {
            stream: Box::new(stream),
            opened: Instant::now(),
        })
    }

    /// A link with an arm in this process.
    pub fn over_peer(peer: impl Peer + 'static) -> Self {
        Self::new(Transport::Peer(Box::new(peer), None))
    }

    /// A link with an arm in this process that lives so many times as fast as a clock, if it is looked
    /// after often enough; otherwise its time and that of the link pass more slowly.
    ///
    /// # Panics
    ///
    /// Where `times` is not above 0.
    pub fn over_paced_peer(peer: impl Peer + 'static, times: f64) -> Self {
        assert!(times > 0.0, "time passes");
        let began = (Instant::now(), peer.now());
        Self::new(Transport::Peer(
            Box::new(peer),
            Some(PeerClock { began, times }),
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
        match &self.transport {
            Transport::Stream { opened, .. } => opened.elapsed(),
            Transport::Peer(peer, None) => peer.now(),
            // Where something is due that was not heard yet, time stands still until it is.
            Transport::Peer(peer, Some(pace)) => {
                let now = pace.now();
                if now < peer.next() { now } else { peer.now() }
            }
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
        let now = self.now();
        let stream = match &mut self.transport {
            Transport::Stream { stream, .. } => stream,
            Transport::Peer(_, None) => return,
            Transport::Peer(peer, Some(_)) => {
                // Whether it is still there, the next wait tells.
                let _ = peer.receive(now, &mut self.early);
                peer.send(&self.outgoing);
                self.outgoing.clear();
                return;
            }
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
    /// [`LinkError::Broken`], or [`LinkError::Closed`] where what was sent met nobody.
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
        self.push();
        match &mut self.transport {
            Transport::Peer(peer, _) => peer.send(&self.outgoing),
            Transport::Stream { stream, .. } => {
                let sending = async {
                    stream.write_all(&self.outgoing).await?;
                    stream.flush().await
                };
                match tokio::time::timeout(FLUSH_TIMEOUT, sending).await {
                    Ok(sent) => sent.map_err(gone)?,
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
        at + began.elapsed().mul_f64(self.times)
    }

    /// When it will be that time; `None` for what is further ahead than clocks go.
    fn instant(&self, time: Duration) -> Option<Instant> {
        let (began, at) = self.began;
        let later_s = time.saturating_sub(at).as_secs_f64() / self.times;
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
                let sent = sent.map_err(gone)?;
                if sent == 0 {
                    return Ok(false);
                }
                outgoing.drain(..sent);
            }
            received = reader.read_buf(incoming) => {
                return Ok(received.map_err(gone)? > 0);
            }
            () = wait_until(deadline) => return Ok(true),
        }
    }
}

/// Why a link is gone. TCP calls a close a reset where something that the other end had not read was under way.
fn gone(error: io::Error) -> LinkError {
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

    /// Says something every 80 ms, and takes note of when it heard what.
    #[derive(Debug, Default)]
    struct Clockwork {
        now: Duration,
        heard: std::sync::Arc<std::sync::Mutex<Vec<Duration>>>,
    }

    impl Peer for Clockwork {
        fn now(&self) -> Duration {
            self.now
        }

        fn next(&self) -> Duration {
            let periods = u32::try_from(self.now.as_millis() / 80).expect("a short test");
            Duration::from_millis(80) * (periods + 1)
        }

        fn send(&mut self, bytes: &[u8]) {
            if !bytes.is_empty() {
                self.heard.lock().expect("nobody panicked").push(self.now);
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
    async fn a_paced_peer_lives_as_fast_as_told_and_hears_what_is_pushed_when_it_is_pushed() {
        let peer = Clockwork::default();
        let heard = peer.heard.clone();
        let began = Instant::now();
        let mut link = Link::over_paced_peer(peer, 1000.0);
        let mut incoming = Vec::new();
        for n in 1..=100_u32 {
            let open = link.receive(Duration::MAX, &mut incoming).await;
            assert!(open.expect("it is there"));
            assert_eq!(incoming.len(), usize::try_from(n).expect("small"));
            let said = Duration::from_millis(80) * n;
            assert!((said..said + Duration::from_millis(80)).contains(&link.now()));
        }
        // 8 s of its time; the clock of the runtime counts whole milliseconds.
        let took = began.elapsed();
        assert!((8..=10).contains(&took.as_millis()), "{took:?}");
        let mut slow = Link::over_paced_peer(
            Clockwork {
                heard: heard.clone(),
                ..Clockwork::default()
            },
            2.0,
        );
        tokio::time::advance(Duration::from_millis(15)).await;
        slow.send(b"x");
        slow.push();
        assert_eq!(
            *heard.lock().expect("nobody panicked"),
            [Duration::from_millis(30)]
        );
        assert_eq!(slow.now(), Duration::from_millis(30));
        tokio::time::advance(Duration::from_millis(5)).await;
        assert_eq!(slow.now(), Duration::from_millis(40));
        // What is not looked after does not live on.
        tokio::time::advance(Duration::from_secs(9)).await;
        assert_eq!(slow.now(), Duration::from_millis(30));
        let open = slow.receive(Duration::MAX, &mut incoming).await;
        assert!(open.expect("it is there"));
        assert_eq!(slow.now(), Duration::from_millis(80));
        assert_eq!(incoming.len(), 101);
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
