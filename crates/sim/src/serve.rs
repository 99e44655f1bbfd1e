//! A virtual arm in real time, on TCP and on a virtual serial port.

use std::future::pending;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use dobot_controller::Refused;
use tokio::io::AsyncReadExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep_until};

use crate::VirtualArm;
#[cfg(unix)]
use crate::pty::{Pty, PtyClient};

/// A virtual arm that runs in real time and serves one client at a time.
///
/// Whoever comes first has the arm until he leaves. Another one is turned away on TCP; on the
/// virtual serial port, which cannot turn anybody away, he meets a line where nobody speaks or
/// listens until the arm is free.
///
/// Nothing that the arm sent before a client came is kept for him. The virtual serial port keeps
/// this promise from the moment on that the client before has been seen to leave
/// ([`ServerEvent::Disconnected`]).
#[derive(Debug)]
pub struct Server {
    arm: VirtualArm,
    tcp: Option<TcpListener>,
    #[cfg(unix)]
    pty: Option<Pty>,
    client: Option<Client>,
    buffer: Vec<u8>,
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
    /// The client left.
    Disconnected,
    /// The client sends faster than the line carries, so that bytes are lost; told once a client.
    Overrun,
    /// The controller refused something.
    Refused(Refused),
}

/// The one client that has the arm.
#[derive(Debug)]
enum Client {
    Tcp(TcpStream),
    #[cfg(unix)]
    Pty(PtyClient),
}

/// What the server waits for.
enum Happening {
    Time,
    Connect(io::Result<(TcpStream, SocketAddr)>),
    Bytes(io::Result<usize>),
}

impl Server {
    /// Serves `arm`; it has nowhere to be reached yet.
    #[must_use]
    pub const fn new(arm: VirtualArm) -> Self {
        Self {
            arm,
            tcp: None,
            #[cfg(unix)]
            pty: None,
            client: None,
            buffer: Vec::new(),
            told_lost: None,
        }
    }

    /// Lets clients come over TCP.
    #[must_use]
    pub fn on_tcp(mut self, listener: TcpListener) -> Self {
        self.tcp = Some(listener);
        self
    }

    /// Lets a client open a virtual serial port.
    #[cfg(unix)]
    #[must_use]
    pub fn on_pty(mut self, pty: Pty) -> Self {
        self.pty = Some(pty);
        self
    }

    /// The arm, to look at.
    #[must_use]
    pub const fn arm(&self) -> &VirtualArm {
        &self.arm
    }

    /// Runs the arm, in real time, and tells what happens; never returns of its own accord. When
    /// it is cancelled and called again, the arm goes on where it was.
    ///
    /// # Errors
    ///
    /// When no more clients can be served.
    pub async fn run(&mut self, mut tell: impl FnMut(ServerEvent)) -> io::Result<()> {
        let (start, offset) = (Instant::now(), self.arm.now());
        loop {
            let wakeup = start + self.arm.poll_wakeup().saturating_sub(offset);
            let happening = self.wait(wakeup).await;
            let now = offset + start.elapsed();
            self.arm.handle_time(now);
            match happening {
                Happening::Time => {}
                Happening::Connect(connection) => self.admit(connection, &mut tell)?,
                Happening::Bytes(Ok(1..)) => self.download(now, &mut tell),
                Happening::Bytes(_) => self.dismiss(&mut tell)?,
            }
            self.upload(&mut tell)?;
            #[cfg(unix)]
            self.notice_pty(&mut tell)?;
            while let Some(refused) = self.arm.poll_refused() {
                tell(ServerEvent::Refused(refused));
            }
        }
    }

    async fn wait(&mut self, wakeup: Instant) -> Happening {
        self.buffer.clear();
        tokio::select! {
            () = sleep_until(wakeup) => Happening::Time,
            connection = accept(self.tcp.as_ref()) => Happening::Connect(connection),
            count = read(self.client.as_mut(), &mut self.buffer) => Happening::Bytes(count),
        }
    }

    fn admit(
        &mut self,
        connection: io::Result<(TcpStream, SocketAddr)>,
        tell: &mut impl FnMut(ServerEvent),
    ) -> io::Result<()> {
        let (stream, from) = match connection {
            Ok(connection) => connection,
            // It left before it was met; the next one may come.
            Err(error) if error.kind() == io::ErrorKind::ConnectionAborted => return Ok(()),
            Err(error) => return Err(error),
        };
        if self.client.is_some() {
            tell(ServerEvent::TcpRefused(from));
        } else {
            // Small packets at once; without it they are only later.
            let _ = stream.set_nodelay(true);
            self.welcome(Client::Tcp(stream));
            tell(ServerEvent::TcpConnected(from));
        }
        Ok(())
    }

    fn welcome(&mut self, client: Client) {
        self.client = Some(client);
        self.told_lost = Some(self.arm.lost_bytes());
    }

    fn dismiss(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let left = self.client.take();
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
    fn download(&mut self, now: Duration, tell: &mut impl FnMut(ServerEvent)) {
        self.arm.handle_bytes(now, &self.buffer);
        if self.told_lost.is_some_and(|it| it < self.arm.lost_bytes()) {
            self.told_lost = None;
            tell(ServerEvent::Overrun);
        }
    }

    /// Passes on what arrived from the arm. A client that does not read loses bytes, as on a
    /// serial line; nobody listening loses all.
    fn upload(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        self.buffer.clear();
        self.arm.poll_bytes(&mut self.buffer);
        if self.buffer.is_empty() {
            return Ok(());
        }
        match &self.client {
            Some(Client::Tcp(stream)) => {
                let gone = |error: io::Error| error.kind() != io::ErrorKind::WouldBlock;
                if stream.try_write(&self.buffer).is_err_and(gone) {
                    self.dismiss(tell)?;
                }
            }
            #[cfg(unix)]
            Some(Client::Pty(client)) => client.write(&self.buffer),
            None => {}
        }
        Ok(())
    }

    /// A virtual serial port does not say that it was opened: somebody has to look.
    #[cfg(unix)]
    fn notice_pty(&mut self, tell: &mut impl FnMut(ServerEvent)) -> io::Result<()> {
        let Some(pty) = &self.pty else {
            return Ok(());
        };
        match &self.client {
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

async fn accept(listener: Option<&TcpListener>) -> io::Result<(TcpStream, SocketAddr)> {
    match listener {
        Some(listener) => listener.accept().await,
        None => pending().await,
    }
}

/// Reads from whoever has the arm.
async fn read(client: Option<&mut Client>, buffer: &mut Vec<u8>) -> io::Result<usize> {
    buffer.reserve(READ_LEN);
    match client {
        Some(Client::Tcp(stream)) => stream.read_buf(buffer).await,
        #[cfg(unix)]
        Some(Client::Pty(client)) => {
            let mut bytes = [0; READ_LEN];
            let count = client.read(&mut bytes).await?;
            buffer.extend_from_slice(&bytes[..count]);
            Ok(count)
        }
        None => pending().await,
    }
}

/// The vendor's bridge listens here, so old programs find the virtual arm (note N26).
pub const DEFAULT_TCP: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 5555);

/// How often a moving arm is recorded: once a control tick. Corners are recorded besides, and what is
/// drawn is straight between them.
pub const RECORDING_PERIOD: Duration = Duration::from_millis(20);

/// A few packets.
const READ_LEN: usize = 256;
