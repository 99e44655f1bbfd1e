//! The thin shell around a session: it moves bytes and tells the time.

use std::io;
use std::time::Duration;

use dobot_wire::{Command, Dialect, Status};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt};
use tokio::time::Instant;

use crate::{Address, CommandId, Event, OpenError, Peer, SendError, Session, open};

/// A connection with an arm: a [`Session`] and the way its bytes travel.
///
/// The same code serves a serial port, TCP and a virtual arm in this process, whose time passes
/// only when somebody waits for it.
#[derive(Debug)]
pub struct Connection {
    session: Session,
    link: Link,
    /// Bytes on their way out, so that a cancelled wait tears no packet apart.
    outgoing: Vec<u8>,
    incoming: Vec<u8>,
}

/// What bytes travel over.
enum Link {
    Stream {
        stream: Box<dyn Stream>,
        opened: Instant,
    },
    Peer(Box<dyn Peer>),
}

/// Anything that carries bytes both ways.
trait Stream: AsyncRead + AsyncWrite + Unpin + Send {}

impl<T: AsyncRead + AsyncWrite + Unpin + Send> Stream for T {}

/// Why a conversation with an arm failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LinkError {
    /// No status came any more.
    #[error(
        "the arm has sent no valid status for {:.1} s{}",
        silent_for.as_secs_f64(),
        if *noise > 0 { format!(", only {noise} bytes that belong to none") } else { String::new() }
    )]
    Silent {
        /// How long.
        silent_for: Duration,
        /// Bytes that came all the same.
        noise: u64,
    },
    /// The other end closed the link.
    #[error("the other end closed the link")]
    Closed,
    /// The link broke.
    #[error("the link broke")]
    Broken(#[source] io::Error),
    /// The arm rests elsewhere than a command leads.
    #[error(
        "the arm rests at {found}, not at {expected}, where the command leads: it was refused or stopped at a limit"
    )]
    NotReached {
        /// Where the command leads.
        expected: String,
        /// Where the arm is.
        found: String,
    },
    /// A command is not allowed.
    #[error(transparent)]
    Send(#[from] SendError),
}

impl Connection {
    /// Opens a serial port or a TCP connection.
    ///
    /// # Errors
    ///
    /// [`OpenError`], with what to do about it.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        Ok(match address {
            Address::Virtual => return Err(OpenError::Virtual),
            Address::Serial { path, baud } => {
                Self::over_stream(open::serial(path, *baud)?, dialect)
            }
            Address::Tcp { host, port } => {
                Self::over_stream(open::tcp(host, *port).await?, dialect)
            }
        })
    }

    /// A connection over anything that carries bytes both ways.
    pub fn over_stream(
        stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
        dialect: Option<Dialect>,
    ) -> Self {
        Self::new(
            Link::Stream {
                stream: Box::new(stream),
                opened: Instant::now(),
            },
            dialect,
        )
    }

    /// A connection with an arm in this process.
    pub fn over_peer(peer: impl Peer + 'static, dialect: Option<Dialect>) -> Self {
        Self::new(Link::Peer(Box::new(peer)), dialect)
    }

    fn new(link: Link, dialect: Option<Dialect>) -> Self {
        Self {
            session: Session::new(dialect),
            link,
            outgoing: Vec::new(),
            incoming: Vec::new(),
        }
    }

    /// Takes a command, as [`Session::send`]; it leaves while somebody waits for an event.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        self.session.send(command)
    }

    /// The session, to look at.
    #[must_use]
    pub const fn session(&self) -> &Session {
        &self.session
    }

    /// The session.
    pub const fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The time since the connect, by the clock of the link.
    #[must_use]
    pub fn now(&self) -> Duration {
        match &self.link {
            Link::Stream { opened, .. } => opened.elapsed(),
            Link::Peer(peer) => peer.now(),
        }
    }

    /// Waits for the next thing that happens. A wait that is cancelled loses nothing.
    ///
    /// # Errors
    ///
    /// [`LinkError::Closed`] or [`LinkError::Broken`] when there is no link any more.
    pub async fn next_event(&mut self) -> Result<Event, LinkError> {
        loop {
            if let Some(event) = self.session.poll_event() {
                return Ok(event);
            }
            while let Some(packet) = self.session.poll_bytes() {
                self.outgoing.extend_from_slice(&packet.to_bytes());
            }
            let wakeup = self.session.poll_wakeup();
            let open = self
                .link
                .carry(&mut self.outgoing, &mut self.incoming, wakeup)
                .await?;
            let now = self.now();
            self.session.handle_bytes(now, &self.incoming);
            self.incoming.clear();
            self.session.handle_time(now);
            if !open && !self.session.has_event() {
                return Err(LinkError::Closed);
            }
        }
    }

    /// Waits for the next status.
    ///
    /// # Errors
    ///
    /// [`LinkError`] when none comes.
    pub async fn next_status(&mut self) -> Result<Status, LinkError> {
        loop {
            if let Event::Status(status) = self.next_event().await?.or_failed()? {
                return Ok(status);
            }
        }
    }

    /// Waits until a command, and with it all before it, is over.
    ///
    /// # Errors
    ///
    /// [`LinkError::NotReached`] where the arm rests elsewhere; [`LinkError`] when the link fails.
    pub async fn completed(&mut self, command: CommandId) -> Result<(), LinkError> {
        loop {
            if let Event::Completed(id) = self.next_event().await?.or_failed()?
                && id >= command
            {
                return Ok(());
            }
        }
    }

    /// Sends what was given to [`Session::send_now`], without waiting for anything from the arm.
    ///
    /// # Errors
    ///
    /// [`LinkError`] when the link does not take it.
    pub async fn flush(&mut self) -> Result<(), LinkError> {
        while let Some(packet) = self.session.poll_bytes() {
            self.outgoing.extend_from_slice(&packet.to_bytes());
        }
        match &mut self.link {
            Link::Peer(peer) => peer.send(&self.outgoing),
            Link::Stream { stream, .. } => {
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

impl Event {
    /// The event, or the failure that it is.
    ///
    /// # Errors
    ///
    /// [`LinkError::Silent`] for a lost link, [`LinkError::NotReached`] for a move that fell short.
    pub fn or_failed(self) -> Result<Self, LinkError> {
        match self {
            Self::LinkLost { silent_for, noise } => Err(LinkError::Silent { silent_for, noise }),
            Self::NotReached {
                expected, found, ..
            } => Err(LinkError::NotReached {
                expected: point(expected),
                found: point(found),
            }),
            event => Ok(event),
        }
    }
}

impl Link {
    /// Sends and receives until bytes came or the time has come; returns whether the link is open.
    async fn carry(
        &mut self,
        outgoing: &mut Vec<u8>,
        incoming: &mut Vec<u8>,
        until: Duration,
    ) -> Result<bool, LinkError> {
        match self {
            Self::Peer(peer) => {
                peer.send(outgoing);
                outgoing.clear();
                Ok(peer.receive(until, incoming))
            }
            Self::Stream { stream, opened } => {
                let deadline = opened.checked_add(until);
                carry_stream(stream, outgoing, incoming, deadline).await
            }
        }
    }
}

impl std::fmt::Debug for Link {
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

async fn carry_stream(
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

fn point(position: dobot_arm::Position) -> String {
    format!(
        "{:.2}, {:.2}, {:.2} mm",
        position.x.0, position.y.0, position.z.0
    )
}

/// Longer than a packet takes at 9600 baud; a port that takes none by then is dead.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(1);
