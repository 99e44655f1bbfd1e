//! A virtual arm on TCP and on a virtual serial port, in real time or faster.

mod client;

use std::future::pending;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use dobot_controller::Refused;
use tokio::io::AsyncWriteExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep, sleep_until, timeout};

use self::client::Client;
#[cfg(unix)]
use crate::pty::Pty;
use crate::world::{Happened, World};
use crate::{Speed, Struck, VirtualArm};

/// A virtual arm that runs in real time, or faster, and serves one client at a time.
///
/// The first client has the arm until it leaves. Another one is turned away on TCP. The virtual serial
/// port cannot turn a client away: there the line is silent until the arm is free.
///
/// Nothing that the arm sent before a client came is kept for it. The virtual serial port keeps
/// this promise from the moment on that the client before has been seen to leave
/// ([`ServerEvent::Disconnected`]).
#[derive(Debug)]
pub struct Server {
    arm: VirtualArm,
    tcp: Option<TcpListener>,
    /// Whoever comes here is told the state of the world.
    world: Option<TcpListener>,
    #[cfg(unix)]
    pty: Option<Pty>,
    speed: Speed,
    client: Option<Client>,
    /// What the client sent.
    incoming: Vec<u8>,
    /// What is to be sent to it.
    outgoing: Vec<u8>,
    /// Bytes to the arm that were lost before the client came, or before it was told of some.
    told_lost: Option<u64>,
}

/// What happens while a virtual arm is served.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ServerEvent {
    /// A client came over TCP.
    TcpConnected(SocketAddr),
    /// A client was turned away, because another one has the arm.
    TcpRefused(SocketAddr),
    /// A client opened the virtual serial port.
    PtyOpened,
    /// The virtual serial port has another name now: a client that was killed left the old one
    /// locked.
    PtyMoved(PathBuf),
    /// A client was turned away, because a fault has closed the port.
    PortClosed(SocketAddr),
    /// The client left.
    Disconnected,
    /// The client sends faster than the line carries, so that bytes are lost; told once a client.
    Overrun,
    /// The controller refused something.
    Refused(Refused),
    /// Something happened in the world around the arm.
    World(Happened),
    /// A fault struck.
    Struck(Struck),
}

/// What the server waits for.
enum Happening {
    Time,
    Connect((TcpStream, SocketAddr)),
    Curious(TcpStream),
    Bytes(io::Result<usize>),
}

impl Server {
    /// Serves `arm`; it has nowhere to be reached yet.
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
            told_lost: None,
        }
    }

    /// Lets clients come over TCP.
    #[must_use]
    pub fn on_tcp(mut self, listener: TcpListener) -> Self {
        self.tcp = Some(listener);
        self
    }

    /// Tells the state of the world to whoever comes here, as many as come: each gets one JSON
    /// document, a [`WorldState`](crate::world::WorldState), or `null` where the arm has no world.
    #[must_use]
    pub fn on_world(mut self, listener: TcpListener) -> Self {
        self.world = Some(listener);
        self
    }

    /// Lets a client open a virtual serial port.
    #[cfg(unix)]
    #[must_use]
    pub fn on_pty(mut self, pty: Pty) -> Self {
        self.pty = Some(pty);
        self
    }

    /// Lets time pass at another speed.
    #[must_use]
    pub const fn at_speed(mut self, speed: Speed) -> Self {
        self.speed = speed;
        self
    }

    /// The arm, to look at.
    #[must_use]
    pub const fn arm(&self) -> &VirtualArm {
        &self.arm
    }

    /// Runs the arm and tells what happens; never returns of its own accord. When it is cancelled
    /// and called again, the arm goes on where it was.
    ///
    /// # Errors
    ///
    /// When no more clients can be served.
    pub async fn run(&mut self, mut tell: impl FnMut(ServerEvent)) -> io::Result<()> {
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
            self.upload(&mut tell)?;
            self.happen(happening, &mut tell)?;
            #[cfg(unix)]
            self.notice_pty(&mut tell)?;
            self.tell_news(&mut tell);
        }
    }

    /// When somebody has to look at the arm, by its own time.
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

    /// At the greatest speed: how long to wait for an answer before time goes on.
    fn patience(&self, answered: bool) -> Duration {
        match self.client {
            None => LOOK_AT_PTY,
            Some(_) if answered => Duration::ZERO,
            Some(_) => PATIENCE,
        }
    }

    /// At the greatest speed: the time that it is for the arm now. It goes on when the client has
    /// taken all that there was, or when a fault keeps all clients away.
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
            (stream, _) = accept(self.world.as_ref()) => Happening::Curious(stream),
            count = read(self.client.as_mut(), &mut self.incoming) => Happening::Bytes(count),
        }
    }

    fn happen(
        &mut self,
        happening: Happening,
        tell: &mut impl FnMut(ServerEvent),
    ) -> io::Result<()> {
        match happening {
            Happening::Time => Ok(()),
            Happening::Connect((stream, from)) => {
                self.admit(stream, from, tell);
                Ok(())
            }
            Happening::Curious(stream) => self.show_world(stream),
            Happening::Bytes(Ok(1..)) => {
                self.download(tell);
                Ok(())
            }
            // It may have been dismissed just now, for another reason.
            Happening::Bytes(_) if self.client.is_none() => Ok(()),
            Happening::Bytes(_) => self.dismiss(tell),
        }
    }

    fn tell_news(&mut self, tell: &mut impl FnMut(ServerEvent)) {
        while let Some(refused) = self.arm.poll_refused() {
            tell(ServerEvent::Refused(refused));
        }
        while let Some(struck) = self.arm.poll_struck() {
            tell(ServerEvent::Struck(struck));
        }
        while let Some(happened) = self.arm.poll_world() {
            tell(ServerEvent::World(happened));
        }
    }

    fn admit(&mut self, stream: TcpStream, from: SocketAddr, tell: &mut impl FnMut(ServerEvent)) {
        if !self.arm.has_port() {
            tell(ServerEvent::PortClosed(from));
        } else if self.client.is_some() {
            tell(ServerEvent::TcpRefused(from));
        } else {
            // Small packets at once; without it they are only later.
            let _ = stream.set_nodelay(true);
            self.welcome(Client::Tcp(stream));
            tell(ServerEvent::TcpConnected(from));
        }
    }

    /// Tells the state of the world; the arm goes on while it is written.
    fn show_world(&self, mut stream: TcpStream) -> io::Result<()> {
        let state = self.arm.world().map(World::state);
        let document = serde_json::to_vec(&state).map_err(io::Error::other)?;
        tokio::spawn(async move {
            // Whoever does not read it does without.
            let told = async {
                stream.write_all(&document).await?;
                stream.shutdown().await
            };
            let _ = timeout(TIME_TO_READ, told).await;
        });
        Ok(())
    }

    fn welcome(&mut self, client: Client) {
        self.client = Some(client);
        self.arm.handle_open(self.arm.now());
        self.told_lost = Some(self.arm.lost_bytes());
    }

    fn dismiss(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let left = self.client.take();
        self.outgoing.clear();
        #[cfg(unix)]
        if matches!(left, Some(Client::Pty(_)))
            && let Some(pty) = &mut self.pty
            && let Some(path) = pty.renew()?
        {
            tell(ServerEvent::PtyMoved(path.to_owned()));
        }
        drop(left);
        tell(ServerEvent::Disconnected);
        Ok(())
    }

    /// Passes on what the client sends.
    fn download(&mut self, tell: &mut impl FnMut(ServerEvent)) {
        self.arm.handle_bytes(self.arm.now(), &self.incoming);
        if self.told_lost.is_some_and(|it| it < self.arm.lost_bytes()) {
            self.told_lost = None;
            tell(ServerEvent::Overrun);
        }
    }

    /// Passes on what arrived from the arm. A client that does not read loses bytes, as on a
    /// serial line, unless time waits for it; nobody listening loses all.
    fn upload(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        self.arm.poll_bytes(&mut self.outgoing);
        let sent = match &mut self.client {
            _ if self.outgoing.is_empty() => Ok(0),
            Some(client) => client.write(&self.outgoing),
            None => Ok(self.outgoing.len()),
        };
        match sent {
            Ok(count) if self.speed.is_max() => drop(self.outgoing.drain(..count)),
            Err(error) if error.kind() != io::ErrorKind::WouldBlock => self.dismiss(tell)?,
            Err(_) if self.speed.is_max() => {}
            _ => self.outgoing.clear(),
        }
        if !self.arm.has_port() && self.client.is_some() {
            self.hang_up(tell)?;
        }
        Ok(())
    }

    /// Takes the port away from the client.
    fn hang_up(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let left = self.client.take();
        #[cfg(unix)]
        if matches!(left, Some(Client::Pty(_)))
            && let Some(pty) = &mut self.pty
        {
            pty.replace()?;
            tell(ServerEvent::PtyMoved(pty.path().to_owned()));
        }
        drop(left);
        self.outgoing.clear();
        tell(ServerEvent::Disconnected);
        Ok(())
    }

    /// A virtual serial port does not say that it was opened: somebody has to look.
    #[cfg(unix)]
    fn notice_pty(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let Some(pty) = &self.pty else {
            return Ok(());
        };
        match &self.client {
            None if !self.arm.has_port() => pty.ignore_client(),
            None => {
                if let Some(client) = pty.client()? {
                    self.welcome(Client::Pty(client));
                    tell(ServerEvent::PtyOpened);
                }
            }
            Some(Client::Tcp(_)) => pty.ignore_client(),
            Some(Client::Pty(_)) => {}
        }
        Ok(())
    }
}

/// The next client over TCP. What one meets who left before, or a system that has no more connections
/// to give at the moment, ends nothing: the next one may come.
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

/// Where the world around a virtual arm is told, unless told otherwise.
pub const DEFAULT_WORLD: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 5556);

/// How often a moving arm is recorded: once a control tick. Corners are recorded besides, and what is
/// drawn is straight between them.
pub const RECORDING_PERIOD: Duration = Duration::from_millis(20);

/// Without anything to do the arm is still looked at so often.
const LOOK_AT_LEAST: Duration = Duration::from_secs(1);
/// Whoever opens the virtual serial port is noticed so soon.
const LOOK_AT_PTY: Duration = Duration::from_millis(50);
/// At the greatest speed a client has so long to answer a status.
const PATIENCE: Duration = Duration::from_millis(1);
/// How long to wait when the system has no more connections to give.
const BREATH: Duration = Duration::from_millis(50);
/// How long one who asked for the world may take to read it.
const TIME_TO_READ: Duration = Duration::from_secs(10);
