//! A virtual arm on TCP and on a virtual serial port, in real time or faster.

mod client;
#[cfg(feature = "world")]
mod surroundings;

use std::future::pending;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use dobot_controller::Refused;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep, sleep_until};

use self::client::Client;
#[cfg(unix)]
use crate::pty::Pty;
#[cfg(feature = "world")]
use crate::world::Happened;
use crate::{Speed, Struck, VirtualArm};

/// A virtual arm that runs in real time, or faster, and serves one client at a time.
///
/// The first client has the arm until it disconnects. Further clients are rejected on TCP. The virtual
/// serial port cannot reject a client: its line is silent until the arm is free.
///
/// Bytes sent before a client connected are not kept for it; on the virtual serial port this holds once
/// the previous client's disconnection was detected ([`ServerEvent::Disconnected`]).
#[derive(Debug)]
pub struct Server {
    arm: VirtualArm,
    tcp: Option<TcpListener>,
    /// The listener that serves the state of the world.
    world: Option<TcpListener>,
    #[cfg(unix)]
    pty: Option<Pty>,
    speed: Speed,
    client: Option<Client>,
    /// Bytes from the client.
    incoming: Vec<u8>,
    /// Bytes to the client.
    outgoing: Vec<u8>,
    /// Lost bytes to the arm that were already reported or predate the client.
    reported_lost: Option<u64>,
}

/// An event of a served virtual arm.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ServerEvent {
    /// A client connected over TCP.
    TcpConnected(SocketAddr),
    /// A client was rejected because another one has the arm.
    TcpRefused(SocketAddr),
    /// A client opened the virtual serial port.
    PtyOpened,
    /// The virtual serial port has a new name because a killed client left the old one locked.
    PtyMoved(PathBuf),
    /// A client was rejected because a fault has closed the port.
    PortClosed(SocketAddr),
    /// The client disconnected.
    Disconnected,
    /// Bytes are lost because the client sends faster than the line; reported once per client.
    Overrun,
    /// The controller refused a packet or command.
    Refused(Refused),
    /// An event in the world around the arm.
    #[cfg(feature = "world")]
    World(Happened),
    /// An event of a fault.
    Struck(Struck),
}

/// A wakeup of the server.
enum Happening {
    Time,
    Connect((TcpStream, SocketAddr)),
    /// A client that asks for the world.
    AskWorld(
        #[cfg_attr(
            not(feature = "world"),
            expect(dead_code, reason = "there is no world to show")
        )]
        TcpStream,
    ),
    Bytes(io::Result<usize>),
}

impl Server {
    /// Creates a server for `arm` without a listener.
    #[must_use]
    pub const fn new(arm: VirtualArm) -> Self {
        Self {
            arm,
            tcp: None,
            world: None,
            #[cfg(unix)]
            pty: None,
            speed: Speed::REAL,
            client: None,
            incoming: Vec::new(),
            outgoing: Vec::new(),
            reported_lost: None,
        }
    }

    /// Accepts clients over TCP.
    #[must_use]
    pub fn on_tcp(mut self, listener: TcpListener) -> Self {
        self.tcp = Some(listener);
        self
    }

    /// Accepts a client on a virtual serial port.
    #[cfg(unix)]
    #[must_use]
    pub fn on_pty(mut self, pty: Pty) -> Self {
        self.pty = Some(pty);
        self
    }

    /// Sets the simulation speed.
    #[must_use]
    pub const fn at_speed(mut self, speed: Speed) -> Self {
        self.speed = speed;
        self
    }

    /// The arm.
    #[must_use]
    pub const fn arm(&self) -> &VirtualArm {
        &self.arm
    }

    /// Runs the arm and reports its events; returns only on an error. After cancellation, another call
    /// continues.
    ///
    /// # Errors
    ///
    /// Returns an error if no more clients can be served.
    pub async fn run(&mut self, mut report: impl FnMut(ServerEvent)) -> io::Result<()> {
        let (start, offset) = (Instant::now(), self.arm.now());
        let mut answered = false;
        loop {
            let wakeup = if self.speed.is_max() {
                Instant::now() + self.patience(answered)
            } else {
                start + self.speed.of_arm(self.wakeup().saturating_sub(offset))
            };
            let happening = self.wait(wakeup).await;
            let now = if self.speed.is_max() {
                self.next_moment(&happening)
            } else {
                offset + self.speed.of_clock(start.elapsed())
            };
            answered = matches!(happening, Happening::Bytes(Ok(1..)));
            self.arm.handle_time(now);
            self.upload(&mut report)?;
            self.happen(happening, &mut report)?;
            #[cfg(unix)]
            self.notice_pty(&mut report)?;
            self.report_events(&mut report);
        }
    }

    /// The time of the next poll, on the arm's clock.
    fn wakeup(&self) -> Duration {
        let latest = self.arm.now() + LOOK_AT_LEAST;
        if self.client.is_some() {
            return self.arm.poll_delivery().min(latest);
        }
        #[cfg(unix)]
        if self.pty.is_some() {
            return self.arm.poll_fault().min(self.arm.now() + LOOK_AT_PTY);
        }
        self.arm.poll_fault().min(latest)
    }

    /// At maximum speed: the time to wait for a response before time continues.
    fn patience(&self, answered: bool) -> Duration {
        match self.client {
            None => LOOK_AT_PTY,
            Some(_) if answered => Duration::ZERO,
            Some(_) => PATIENCE,
        }
    }

    /// At maximum speed: the current time of the arm. It advances when the client has received all
    /// bytes, or when a fault keeps all clients away.
    fn next_moment(&self, happening: &Happening) -> Duration {
        let waits_for_nobody = match self.client {
            Some(_) => self.outgoing.is_empty(),
            None => !self.arm.has_port(),
        };
        if matches!(happening, Happening::Time) && waits_for_nobody {
            self.wakeup()
        } else {
            self.arm.now()
        }
    }

    async fn wait(&mut self, wakeup: Instant) -> Happening {
        self.incoming.clear();
        tokio::select! {
            () = sleep_until(wakeup) => Happening::Time,
            connection = accept(self.tcp.as_ref()) => Happening::Connect(connection),
            (stream, _) = accept(self.world.as_ref()) => Happening::AskWorld(stream),
            count = read(self.client.as_mut(), &mut self.incoming) => Happening::Bytes(count),
        }
    }

    fn happen(
        &mut self,
        happening: Happening,
        report: &mut impl FnMut(ServerEvent),
    ) -> io::Result<()> {
        match happening {
            Happening::Time => Ok(()),
            Happening::Connect((stream, from)) => {
                self.admit(stream, from, report);
                Ok(())
            }
            #[cfg(feature = "world")]
            Happening::AskWorld(stream) => self.show_world(stream),
            #[cfg(not(feature = "world"))]
            Happening::AskWorld(_) => Ok(()),
            Happening::Bytes(Ok(1..)) => {
                self.download(report);
                Ok(())
            }
            // It may have been dismissed just now, for another reason.
            Happening::Bytes(_) if self.client.is_none() => Ok(()),
            Happening::Bytes(_) => self.dismiss(report),
        }
    }

    fn report_events(&mut self, report: &mut impl FnMut(ServerEvent)) {
        while let Some(refused) = self.arm.poll_refused() {
            report(ServerEvent::Refused(refused));
        }
        while let Some(struck) = self.arm.poll_struck() {
            report(ServerEvent::Struck(struck));
        }
        #[cfg(feature = "world")]
        while let Some(happened) = self.arm.poll_world() {
            report(ServerEvent::World(happened));
        }
    }

    fn admit(&mut self, stream: TcpStream, from: SocketAddr, report: &mut impl FnMut(ServerEvent)) {
        if !self.arm.has_port() {
            report(ServerEvent::PortClosed(from));
        } else if self.client.is_some() {
            report(ServerEvent::TcpRefused(from));
        } else {
            // Small packets at once; without it they are only later.
            let _ = stream.set_nodelay(true);
            self.welcome(Client::Tcp(stream));
            report(ServerEvent::TcpConnected(from));
        }
    }

    fn welcome(&mut self, client: Client) {
        self.client = Some(client);
        self.arm.handle_open(self.arm.now());
        self.reported_lost = Some(self.arm.lost_bytes());
    }

    fn dismiss(&mut self, report: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let left = self.client.take();
        self.outgoing.clear();
        #[cfg(unix)]
        if matches!(left, Some(Client::Pty(_)))
            && let Some(pty) = &mut self.pty
            && let Some(path) = pty.renew()?
        {
            report(ServerEvent::PtyMoved(path.to_owned()));
        }
        drop(left);
        report(ServerEvent::Disconnected);
        Ok(())
    }

    /// Forwards bytes from the client.
    fn download(&mut self, report: &mut impl FnMut(ServerEvent)) {
        self.arm.handle_bytes(self.arm.now(), &self.incoming);
        if self
            .reported_lost
            .is_some_and(|lost| lost < self.arm.lost_bytes())
        {
            self.reported_lost = None;
            report(ServerEvent::Overrun);
        }
    }

    /// Forwards bytes from the arm. A client that does not read loses bytes, as on a serial line,
    /// unless time waits for it; without a client all are lost.
    fn upload(&mut self, report: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        self.arm.poll_bytes(&mut self.outgoing);
        let sent = match &mut self.client {
            _ if self.outgoing.is_empty() => Ok(0),
            Some(client) => client.write(&self.outgoing),
            None => Ok(self.outgoing.len()),
        };
        match sent {
            Ok(count) if self.speed.is_max() => drop(self.outgoing.drain(..count)),
            Err(error) if error.kind() != io::ErrorKind::WouldBlock => self.dismiss(report)?,
            Err(_) if self.speed.is_max() => {}
            _ => self.outgoing.clear(),
        }
        if !self.arm.has_port() && self.client.is_some() {
            self.hang_up(report)?;
        }
        Ok(())
    }

    /// Disconnects the client.
    fn hang_up(&mut self, report: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let left = self.client.take();
        #[cfg(unix)]
        if matches!(left, Some(Client::Pty(_)))
            && let Some(pty) = &mut self.pty
        {
            pty.replace()?;
            report(ServerEvent::PtyMoved(pty.path().to_owned()));
        }
        drop(left);
        self.outgoing.clear();
        report(ServerEvent::Disconnected);
        Ok(())
    }

    /// Polls the virtual serial port, which does not report its opening.
    #[cfg(unix)]
    fn notice_pty(&mut self, report: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let Some(pty) = &self.pty else {
            return Ok(());
        };
        match &self.client {
            None if !self.arm.has_port() => pty.ignore_client(),
            None => {
                if let Some(client) = pty.client()? {
                    self.welcome(Client::Pty(client));
                    report(ServerEvent::PtyOpened);
                }
            }
            Some(Client::Tcp(_)) => pty.ignore_client(),
            Some(Client::Pty(_)) => {}
        }
        Ok(())
    }
}

/// Accepts the next client over TCP. Errors of a client that has left, and a temporary lack of
/// connections, are ignored.
async fn accept(listener: Option<&TcpListener>) -> (TcpStream, SocketAddr) {
    let Some(listener) = listener else {
        return pending().await;
    };
    loop {
        match listener.accept().await {
            Ok(come) => return come,
            Err(_) => sleep(BREATH).await,
        }
    }
}

/// Reads from the client that has the arm.
async fn read(client: Option<&mut Client>, buffer: &mut Vec<u8>) -> io::Result<usize> {
    match client {
        Some(client) => client.read(buffer).await,
        None => pending().await,
    }
}

/// The vendor's bridge listens here, so old programs find the virtual arm (note N26).
pub const DEFAULT_TCP: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 5555);

/// The default port for the state of the world around a virtual arm.
pub const DEFAULT_WORLD: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 5556);

/// The recording period of a moving arm: one control tick. Corners are recorded as well, with straight
/// lines in between.
pub const RECORDING_PERIOD: Duration = Duration::from_millis(20);

/// The poll interval of an idle arm.
const LOOK_AT_LEAST: Duration = Duration::from_secs(1);
/// The poll interval for the opening of the virtual serial port.
const LOOK_AT_PTY: Duration = Duration::from_millis(50);
/// The time for a client to respond to a status at maximum speed.
const PATIENCE: Duration = Duration::from_millis(1);
/// The delay after a lack of connections.
const BREATH: Duration = Duration::from_millis(50);
