//! The raw port: the arm's own packets over TCP, subject to the rules of the station.

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

/// The raw port: programs that speak the arm's own protocol over TCP, as with the vendor's bridge,
/// work with the station unchanged (note N26).
///
/// One program at a time is served, as a client of the station: the first packet takes the lease if
/// it is free, every packet is checked, and each status sent to the program permits one command.
/// The protocol has no message for a refusal, so the driver reports it elsewhere.
///
/// Another program gets the reason why it is turned away, in a line without a packet header, but
/// only after a moment: a restarted program may connect before the end of the previous one is
/// noticed.
///
/// The port is on this machine only: the protocol has no authentication. Connections of web
/// browsers are closed, since a page of any site can make a browser send packets here.
///
/// A local program that ends closes its connection in any case. So a connection that is merely
/// silent belongs to a running program, perhaps one that only watches, and is not closed in favour
/// of the next one.
#[derive(Debug)]
pub struct RawPort {
    listener: TcpListener,
    address: SocketAddr,
}

/// The error returned when the raw port cannot be opened.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RawPortError {
    /// The address is reachable from other machines.
    #[error(
        "the raw port is {found}; allowed are loopback addresses such as 127.0.0.1, because its protocol has no authentication"
    )]
    NotLoopback {
        /// The requested address.
        found: SocketAddr,
    },
    /// Another program listens there.
    #[error("the raw port {address} is in use by another program")]
    InUse {
        /// The requested address.
        address: SocketAddr,
    },
    /// The operating system refuses to listen.
    #[error("cannot listen on the raw port {address}")]
    Listen {
        /// The requested address.
        address: SocketAddr,
        /// The cause.
        #[source]
        source: io::Error,
    },
}

impl RawPort {
    /// Listens on an address; port 0 selects a free one.
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

    /// Returns the address of the port.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves programs, one after the other, until the station ends.
    pub async fn serve(self, handle: &StationHandle, mut report: impl FnMut(ProgramNews)) {
        let mut next = None;
        loop {
            let program = if let Some(program) = next.take() {
                program
            } else {
                tokio::select! {
                    program = accept(&self.listener, &mut report) => program,
                    () = handle.ended() => return,
                }
            };
            match self.serve_one(program, handle, &mut report).await {
                Ok(waiting) => next = waiting,
                Err(_) => return,
            }
        }
    }

    /// Serves a program until it leaves, and returns the one that waits by then.
    ///
    /// # Errors
    ///
    /// If the station ends.
    async fn serve_one(
        &self,
        program: Program,
        handle: &StationHandle,
        report: &mut impl FnMut(ProgramNews),
    ) -> Result<Option<Program>, Refusal> {
        let Program { mut stream, name } = program;
        // Sends small packets immediately; otherwise they are only later.
        let _ = stream.set_nodelay(true);
        let statuses = handle.packets();
        let client = handle.client(&name, Role::Control).await?;
        report(ProgramNews::Came { name: name.clone() });
        let (reader, writer) = stream.split();
        let bridge = pin!(bridge(reader, writer, &client, statuses));
        let (traffic, waiting) = self.attend(bridge, &name, report).await;
        report(ProgramNews::Left { name, traffic });
        Ok(waiting)
    }

    /// Turns others away while a program is served.
    async fn attend(
        &self,
        mut bridge: Pin<&mut impl Future<Output = Traffic>>,
        served: &str,
        report: &mut impl FnMut(ProgramNews),
    ) -> (Traffic, Option<Program>) {
        let mut waiting = None;
        let mut grace = pin!(sleep(GRACE));
        loop {
            tokio::select! {
                biased;
                traffic = &mut bridge => return (traffic, waiting),
                program = accept(&self.listener, report), if waiting.is_none() => {
                    waiting = Some(program);
                    grace.as_mut().reset(Instant::now() + GRACE);
                }
                () = &mut grace, if waiting.is_some() => {
                    if let Some(program) = waiting.take() {
                        let (name, by) = (program.name.clone(), served.to_owned());
                        tokio::spawn(program.turn_away(reason(served)));
                        report(ProgramNews::TurnedAway { name, by });
                    }
                }
            }
        }
    }
}

/// A connected program.
#[derive(Debug)]
struct Program {
    stream: TcpStream,
    name: String,
}

impl Program {
    /// Sends the reason and closes; data from the program are read for a moment, so that the
    /// closing does not overtake the reason.
    async fn turn_away(mut self, reason: String) {
        let message = async {
            self.stream.write_all(reason.as_bytes()).await?;
            self.stream.shutdown().await?;
            tokio::io::copy(&mut self.stream, &mut tokio::io::sink()).await
        };
        // The program may not read it.
        let _ = timeout(TIME_TO_READ, message).await;
    }
}

/// Waits for a program.
async fn accept(listener: &TcpListener, report: &mut impl FnMut(ProgramNews)) -> Program {
    loop {
        match listener.accept().await {
            Ok((stream, from)) => {
                let name = format!("a program on this computer (port {})", from.port());
                return Program { stream, name };
            }
            // It left before it was accepted; wait for the next one.
            Err(error) if error.kind() == io::ErrorKind::ConnectionAborted => {}
            Err(error) => {
                report(ProgramNews::Trouble(format!(
                    "the raw port cannot accept another program: {error}"
                )));
                sleep(AGAIN_AFTER).await;
            }
        }
    }
}

/// ASCII, and so without the headers A5 and B5 of packets.
fn reason(served: &str) -> String {
    format!(
        "turned away: {served} is using the raw port of the station, which serves one program at a time\r\n"
    )
}

/// How long a program waits for the end of the previous one.
const GRACE: Duration = Duration::from_millis(500);
/// How long a program that is turned away may take to read the reason.
const TIME_TO_READ: Duration = Duration::from_secs(1);
/// The delay before a retry when the system accepts no more programs.
const AGAIN_AFTER: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests;
