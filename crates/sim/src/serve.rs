//! A virtual arm in real time, on TCP and on a virtual serial port.

use std::future::pending;
use std::io;
use std::net::SocketAddr;
use std::time::Duration;

use dobot_controller::Refused;
use tokio::io::AsyncReadExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep_until};

#[cfg(unix)]
use crate::Pty;
use crate::VirtualArm;

/// A virtual arm that runs in real time and serves one client at a time.
#[derive(Debug)]
pub struct Server {
    arm: VirtualArm,
    tcp: Option<TcpListener>,
    #[cfg(unix)]
    pty: Option<Pty>,
    client: Option<Client>,
    buffer: Vec<u8>,
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
    /// The client left.
    Disconnected,
    /// The controller refused something.
    Refused(Refused),
}

/// The one client that has the arm.
#[derive(Debug)]
enum Client {
    Tcp(TcpStream),
    #[cfg(unix)]
    Pty,
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

    /// Runs the arm, in real time, and tells what happens; never returns of its own accord.
    ///
    /// # Errors
    ///
    /// When no more clients can be accepted.
    pub async fn run(&mut self, mut tell: impl FnMut(ServerEvent)) -> io::Result<()> {
        let power_up = Instant::now();
        loop {
            let wakeup = power_up + self.arm.poll_wakeup();
            let happening = self.wait(wakeup).await;
            let now = power_up.elapsed();
            self.arm.handle_time(now);
            match happening {
                Happening::Time => {}
                Happening::Connect(connection) => self.admit(connection?, &mut tell),
                Happening::Bytes(Ok(1..)) => self.arm.handle_bytes(now, &self.buffer),
                Happening::Bytes(_) => self.dismiss(&mut tell),
            }
            self.upload(&mut tell);
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
            count = read(
                self.client.as_mut(),
                #[cfg(unix)]
                self.pty.as_ref(),
                &mut self.buffer,
            ) => Happening::Bytes(count),
        }
    }

    fn admit(
        &mut self,
        (stream, from): (TcpStream, SocketAddr),
        tell: &mut impl FnMut(ServerEvent),
    ) {
        if self.client.is_some() {
            tell(ServerEvent::TcpRefused(from));
        } else {
            // Small packets at once; without it they are only later.
            let _ = stream.set_nodelay(true);
            self.client = Some(Client::Tcp(stream));
            tell(ServerEvent::TcpConnected(from));
        }
    }

    fn dismiss(&mut self, tell: &mut impl FnMut(ServerEvent)) {
        self.client = None;
        tell(ServerEvent::Disconnected);
    }

    /// Passes on what arrived from the arm. A client that does not read loses bytes, as on a
    /// serial line; nobody listening loses all.
    fn upload(&mut self, tell: &mut impl FnMut(ServerEvent)) {
        self.buffer.clear();
        self.arm.poll_bytes(&mut self.buffer);
        #[cfg(unix)]
        self.notice_pty(tell);
        match &self.client {
            None => {}
            Some(Client::Tcp(stream)) => {
                let gone = |error: io::Error| error.kind() != io::ErrorKind::WouldBlock;
                if !self.buffer.is_empty() && stream.try_write(&self.buffer).is_err_and(gone) {
                    self.dismiss(tell);
                }
            }
            #[cfg(unix)]
            Some(Client::Pty) => {
                if let Some(pty) = &self.pty
                    && !self.buffer.is_empty()
                {
                    pty.write(&self.buffer);
                }
            }
        }
    }

    /// A virtual serial port does not say that it was opened or closed: somebody has to look.
    #[cfg(unix)]
    fn notice_pty(&mut self, tell: &mut impl FnMut(ServerEvent)) {
        let Some(pty) = &self.pty else {
            return;
        };
        match (&self.client, pty.is_open()) {
            (None, true) => {
                self.client = Some(Client::Pty);
                tell(ServerEvent::PtyOpened);
            }
            (Some(Client::Pty), false) => self.dismiss(tell),
            _ => {}
        }
    }
}

async fn accept(listener: Option<&TcpListener>) -> io::Result<(TcpStream, SocketAddr)> {
    match listener {
        Some(listener) => listener.accept().await,
        None => pending().await,
    }
}

/// Reads from whoever has the arm.
async fn read(
    client: Option<&mut Client>,
    #[cfg(unix)] pty: Option<&Pty>,
    buffer: &mut Vec<u8>,
) -> io::Result<usize> {
    match client {
        Some(Client::Tcp(stream)) => stream.read_buf(buffer).await,
        #[cfg(unix)]
        Some(Client::Pty) => match pty {
            Some(pty) => read_pty(pty, buffer).await,
            None => pending().await,
        },
        None => pending().await,
    }
}

#[cfg(unix)]
async fn read_pty(pty: &Pty, buffer: &mut Vec<u8>) -> io::Result<usize> {
    let mut bytes = [0; 256];
    let count = pty.read(&mut bytes).await?;
    buffer.extend_from_slice(&bytes[..count]);
    Ok(count)
}

/// The vendor's bridge listens here, so old programs find the virtual arm (note N26).
pub const DEFAULT_TCP: SocketAddr =
    SocketAddr::new(std::net::IpAddr::V4(std::net::Ipv4Addr::LOCALHOST), 5555);

/// How often a moving arm is recorded.
pub const RECORDING_PERIOD: Duration = Duration::from_millis(5);
