//! The raw port: the arm's own packets over TCP, through the rules of the station.

use std::io;
use std::net::SocketAddr;
use std::pin::{Pin, pin};
use std::time::Duration;

use dobot_api::Role;
use dobot_host::StationHandle;
use dobot_supervisor::Refusal;
use tokio::io::AsyncWriteExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::{Instant, sleep, timeout};

use crate::bridge::bridge;
use crate::{ProgramNews, Traffic};

/// The raw port: programs that speak the arm's own protocol over TCP, as the vendor's bridge did,
/// work with the station as they are (note N26).
///
/// One program at a time is served, as a client of the station: the first packet takes the lease if
/// nobody has it, every packet is checked, and each status that it gets permits one command. The
/// protocol has no words for a refusal, so that the driver tells of it elsewhere.
///
/// Another program is told why it is turned away, in a line that holds no header of a packet. It is
/// told so after a moment only: a program that is started again may come before the end of the last
/// one was seen.
///
/// The port is on this machine only: the protocol knows no passwords. What begins as web browsers do
/// is cut off, for a page from anywhere can make a browser send packets here.
///
/// A program on this machine that ends takes its connection with it, however it ends. So a connection
/// that is merely silent belongs to a program that is there, perhaps one that only watches, and is not
/// taken from it for the sake of the next.
#[derive(Debug)]
pub struct RawPort {
    listener: TcpListener,
    address: SocketAddr,
}

/// Why there is no raw port.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RawPortError {
    /// Other machines could come.
    #[error(
        "the raw port is {found}; allowed are addresses of this machine alone, as 127.0.0.1, because its protocol knows no passwords"
    )]
    NotLoopback {
        /// What was asked for.
        found: SocketAddr,
    },
    /// Another program listens there.
    #[error("the raw port {address} is in use by another program")]
    InUse {
        /// What was asked for.
        address: SocketAddr,
    },
    /// The operating system does not let it listen.
    #[error("cannot listen on the raw port {address}")]
    Listen {
        /// What was asked for.
        address: SocketAddr,
        /// What it says.
        #[source]
        source: io::Error,
    },
}

impl RawPort {
    /// Listens there; port 0 is any that is free.
    ///
    /// # Errors
    ///
    /// [`RawPortError`].
    pub async fn bind(address: SocketAddr) -> Result<Self, RawPortError> {
        if !address.ip().is_loopback() {
            return Err(RawPortError::NotLoopback { found: address });
        }
        let error = |source: io::Error| match source.kind() {
            io::ErrorKind::AddrInUse => RawPortError::InUse { address },
            _ => RawPortError::Listen { address, source },
        };
        let listener = TcpListener::bind(address).await.map_err(error)?;
        let address = listener.local_addr().map_err(error)?;
        Ok(Self { listener, address })
    }

    /// Where programs come.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves programs, one after the other, until the station ends.
    pub async fn serve(self, handle: &StationHandle, mut tell: impl FnMut(ProgramNews)) {
        let mut next = None;
        loop {
            let program = if let Some(program) = next.take() {
                program
            } else {
                tokio::select! {
                    program = accept(&self.listener, &mut tell) => program,
                    () = handle.ended() => return,
                }
            };
            match self.serve_one(program, handle, &mut tell).await {
                Ok(waiting) => next = waiting,
                Err(_) => return,
            }
        }
    }

    /// Serves a program until it leaves, and returns the one that waits by then.
    ///
    /// # Errors
    ///
    /// When the station ends.
    async fn serve_one(
        &self,
        program: Program,
        handle: &StationHandle,
        tell: &mut impl FnMut(ProgramNews),
    ) -> Result<Option<Program>, Refusal> {
        let Program { mut stream, name } = program;
        // Small packets at once; without it they are only later.
        let _ = stream.set_nodelay(true);
        let statuses = handle.packets();
        let client = handle.client(&name, Role::Control).await?;
        tell(ProgramNews::Came { name: name.clone() });
        let (reader, writer) = stream.split();
        let bridge = pin!(bridge(reader, writer, &client, statuses));
        let (traffic, waiting) = self.attend(bridge, &name, tell).await;
        tell(ProgramNews::Left { name, traffic });
        Ok(waiting)
    }

    /// Turns others away while a program is served.
    async fn attend(
        &self,
        mut bridge: Pin<&mut impl Future<Output = Traffic>>,
        served: &str,
        tell: &mut impl FnMut(ProgramNews),
    ) -> (Traffic, Option<Program>) {
        let mut waiting = None;
        let mut grace = pin!(sleep(GRACE));
        loop {
            tokio::select! {
                biased;
                traffic = &mut bridge => return (traffic, waiting),
                program = accept(&self.listener, tell), if waiting.is_none() => {
                    waiting = Some(program);
                    grace.as_mut().reset(Instant::now() + GRACE);
                }
                () = &mut grace, if waiting.is_some() => {
                    if let Some(program) = waiting.take() {
                        let (name, by) = (program.name.clone(), served.to_owned());
                        tokio::spawn(program.turn_away(reason(served)));
                        tell(ProgramNews::TurnedAway { name, by });
                    }
                }
            }
        }
    }
}

/// A program that came.
#[derive(Debug)]
struct Program {
    stream: TcpStream,
    name: String,
}

impl Program {
    /// Says why and closes; what the program sends is read for a moment, so that the closing does not
    /// overtake the reason.
    async fn turn_away(mut self, reason: String) {
        let told = async {
            self.stream.write_all(reason.as_bytes()).await?;
            self.stream.shutdown().await?;
            tokio::io::copy(&mut self.stream, &mut tokio::io::sink()).await
        };
        // Whoever does not read it does without.
        let _ = timeout(TIME_TO_READ, told).await;
    }
}

/// Waits for a program.
async fn accept(listener: &TcpListener, tell: &mut impl FnMut(ProgramNews)) -> Program {
    loop {
        match listener.accept().await {
            Ok((stream, from)) => {
                let name = format!("raw program {from}");
                return Program { stream, name };
            }
            // It left before it was met; the next one may come.
            Err(error) if error.kind() == io::ErrorKind::ConnectionAborted => {}
            Err(error) => {
                tell(ProgramNews::Trouble(format!(
                    "the raw port cannot take another program: {error}"
                )));
                sleep(AGAIN_AFTER).await;
            }
        }
    }
}

/// ASCII, and so without the headers A5 and B5 of packets.
fn reason(served: &str) -> String {
    format!("turned away: {served} has the raw port of the station, which serves one at a time\r\n")
}

/// A program that comes before the one served was seen to leave waits so long for that.
const GRACE: Duration = Duration::from_millis(500);
/// How long one that is turned away may take to read why.
const TIME_TO_READ: Duration = Duration::from_secs(1);
/// When the system lets no more programs in, it is asked again after this time.
const AGAIN_AFTER: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests;
