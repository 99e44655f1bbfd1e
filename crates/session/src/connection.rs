//! The thin shell around a session: it moves bytes and tells the time.

use std::time::Duration;

use dobot_wire::{Command, Dialect, Status};
use tokio::io::{AsyncRead, AsyncWrite};

use crate::{Address, CommandId, Event, Link, LinkError, OpenError, Peer, SendError, Session};

/// A connection with an arm: a [`Session`] and the way its bytes travel.
///
/// The same code serves a serial port, TCP and a virtual arm in this process, whose time passes
/// only when somebody waits for it.
#[derive(Debug)]
pub struct Connection {
    session: Session,
    link: Link,
    incoming: Vec<u8>,
}

impl Connection {
    /// Opens a serial port or a TCP connection. The arm is sent nothing that moves it until its pose is
    /// confirmed ([`Session::confirm_pose`]): opening its port may have reset it (note N35).
    ///
    /// # Errors
    ///
    /// [`OpenError`], with what to do about it.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn open(address: &Address, dialect: Option<Dialect>) -> Result<Self, OpenError> {
        Ok(Self::new(Link::open(address).await?, Session::new(dialect)))
    }

    /// A connection over anything that carries bytes both ways; the arm's pose has to be confirmed, as
    /// of [`Connection::open`].
    pub fn over_stream(
        stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
        dialect: Option<Dialect>,
    ) -> Self {
        Self::new(Link::over_stream(stream), Session::new(dialect))
    }

    /// A connection with an arm in this process, which is trusted to stand where it says, and whose laser
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

    /// Takes a command, as [`Session::send`]; it leaves while somebody waits for an event.
    ///
    /// # Errors
    ///
    /// As [`Session::send`].
    pub fn send(&mut self, command: impl Into<Command>) -> Result<CommandId, SendError> {
        self.session.send(command)
    }

    /// Lets the laser be lit for so long: a person has put the goggles on. See [`Session::arm_laser`].
    pub fn arm_laser(&mut self, time: Duration) {
        let until = self.now().saturating_add(time);
        self.session.arm_laser(until);
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
        self.link.now()
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
            let open = self.step(self.session.poll_wakeup()).await?;
            if !open && !self.session.has_event() {
                return Err(LinkError::Closed);
            }
        }
    }

    /// Lets so much time pass on the link; what happens meanwhile is told by
    /// [`Connection::next_event`] afterwards. A stock arm wants a gap between packets that no permit
    /// separates (note N26).
    ///
    /// # Errors
    ///
    /// As of [`Connection::next_event`].
    pub async fn pass(&mut self, time: Duration) -> Result<(), LinkError> {
        let until = self.now() + time;
        while self.now() < until {
            if !self.step(until).await? {
                return Err(LinkError::Closed);
            }
        }
        Ok(())
    }

    /// Sends what is to be sent, and takes what comes until then; tells whether the link is open.
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
            self.link.send(&packet.to_bytes());
        }
        self.link.flush().await
    }
}
