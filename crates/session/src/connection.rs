//! The thin shell around a session: it moves bytes and provides the time.

use std::time::Duration;

use dobot_wire::{Command, Dialect, Status};
use tokio::io::{AsyncRead, AsyncWrite};

use crate::{Address, CommandId, Event, Link, LinkError, OpenError, Peer, SendError, Session};

/// A connection to an arm: a [`Session`] over a [`Link`].
///
/// The same code serves a serial port, TCP and a virtual arm in this process, whose time passes
/// only while the caller waits.
#[derive(Debug)]
pub struct Connection {
    session: Session,
    link: Link,
    incoming: Vec<u8>,
}

impl Connection {
    /// Opens a serial port or a TCP connection. No motion is sent until the pose is confirmed
    /// ([`Session::confirm_pose`]): opening the port may have reset the arm (note N35).
    ///
    /// # Errors
    ///
    /// Returns an [`OpenError`], which has a hint.
    ///
    /// # Panics
    ///
    /// If called outside of a tokio runtime.
    pub async fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        Ok(Self::new(Link::open(address).await?, Session::new(dialect)))
    }

    /// Creates a connection over any bidirectional byte stream. The pose must be confirmed, as after
    /// [`Connection::open`].
    pub fn over_stream(
        stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
        dialect: Option<Dialect>,
    ) -> Self {
        Self::new(Link::over_stream(stream), Session::new(dialect))
    }

    /// Creates a connection to an arm in this process, whose reported pose is trusted and whose laser
    /// needs no arming.
    pub fn over_peer(peer: impl Peer + 'static, dialect: Option<Dialect>) -> Self {
        Self::new(
            Link::over_peer(peer),
            Session::trusted(dialect).with_free_laser(),
        )
    }

    const fn new(link: Link, session: Session) -> Self {
        Self {
            session,
            link,
            incoming: Vec::new(),
        }
    }

    /// Queues a command, see [`Session::send`]. It is sent while the caller waits for an event.
    ///
    /// # Errors
    ///
    /// See [`Session::send`].
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        self.session.send(command)
    }

    /// Arms the laser for `time`, after everyone present has put on goggles. See [`Session::arm_laser`].
    pub fn arm_laser(&mut self, time: Duration) {
        let until = self.now().saturating_add(time);
        self.session.arm_laser(until);
    }

    /// The session.
    #[must_use]
    pub const fn session(&self) -> &Session {
        &self.session
    }

    /// The session, mutable.
    pub const fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The time since the link was opened, on its clock.
    #[must_use]
    pub fn now(&self) -> Duration {
        self.link.now()
    }

    /// Waits for the next event. Cancellation safe.
    ///
    /// # Errors
    ///
    /// Returns [`LinkError::Closed`] or [`LinkError::Broken`] if the link is lost.
    pub async fn next_event(&mut self) -> Result<Event, LinkError> {
        loop {
            if let Some(event) = self.session.poll_event() {
                return Ok(event);
            }
            let open = self.step(self.session.poll_wakeup()).await?;
            if !open && !self.session.has_event() {
                return Err(LinkError::Closed);
            }
        }
    }

    /// Runs the link for `time`; [`Connection::next_event`] returns the events afterwards. A stock arm
    /// needs a gap between packets that no permit separates (note N26).
    ///
    /// # Errors
    ///
    /// See [`Connection::next_event`].
    pub async fn pass(&mut self, time: Duration) -> Result<(), LinkError> {
        let until = self.now() + time;
        while self.now() < until {
            if !self.step(until).await? {
                return Err(LinkError::Closed);
            }
        }
        Ok(())
    }

    /// Sends due packets and receives until `until`; returns whether the link is open.
    async fn step(&mut self, until: Duration) -> Result<bool, LinkError> {
        while let Some(packet) = self.session.poll_bytes() {
            self.link.send(&packet.to_bytes());
            self.session.note_left(self.link.now());
        }
        let open = self.link.receive(until, &mut self.incoming).await?;
        let now = self.now();
        self.session.handle_bytes(now, &self.incoming);
        self.incoming.clear();
        self.session.handle_time(now);
        Ok(open)
    }

    /// Waits for the next status.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if none arrives.
    pub async fn next_status(&mut self) -> Result<Status, LinkError> {
        loop {
            if let Event::Status(status) = self.next_event().await?.or_failed()? {
                return Ok(status);
            }
        }
    }

    /// Waits until a command and all commands before it are completed.
    ///
    /// # Errors
    ///
    /// Returns [`LinkError::NotReached`] if the arm stops elsewhere, or the [`LinkError`] of the link.
    pub async fn completed(&mut self, command: CommandId) -> Result<(), LinkError> {
        loop {
            if let Event::Completed(id) = self.next_event().await?.or_failed()?
                && id >= command
            {
                return Ok(());
            }
        }
    }

    /// Sends the packets of [`Session::send_now`] without waiting for the arm to respond.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if the link does not accept them.
    pub async fn flush(&mut self) -> Result<(), LinkError> {
        while let Some(packet) = self.session.poll_bytes() {
            self.link.send(&packet.to_bytes());
        }
        self.link.flush().await
    }
}
