//! The way to a served arm for clients in the same process.

use tokio::io::{DuplexStream, duplex};
use tokio::sync::{mpsc, oneshot};

/// Connects clients in this process with an arm that a [`Server`](crate::Server) serves; clones lead
/// to the same arm.
///
/// A stream that is dropped leaves the arm free for the next one. The arm ends the stream itself
/// when a fault closes its port: what is read then is its end.
#[derive(Clone, Debug)]
pub struct Connector {
    asks: mpsc::Sender<Ask>,
}

/// Why a client in this process does not get the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ConnectError {
    /// Another client has the arm.
    #[error("another client has the virtual arm, which serves one at a time")]
    InUse,
    /// A fault has closed the port.
    #[error("a fault has closed the port of the virtual arm; it can be opened again later")]
    PortClosed,
    /// Nobody serves the arm any more.
    #[error("the virtual arm is not served any more")]
    Ended,
}

/// The server's end of its connectors.
#[derive(Debug)]
pub(crate) struct Socket {
    connector: Connector,
    asks: mpsc::Receiver<Ask>,
}

/// A client that wants the arm.
#[derive(Debug)]
pub(crate) struct Ask(oneshot::Sender<Result<DuplexStream, ConnectError>>);

impl Connector {
    /// Connects with the arm, as if its port was opened.
    ///
    /// # Errors
    ///
    /// [`ConnectError`].
    pub async fn connect(&self) -> Result<DuplexStream, ConnectError> {
        let (reply, answer) = oneshot::channel();
        let asked = self.asks.send(Ask(reply)).await;
        asked.map_err(|_| ConnectError::Ended)?;
        answer.await.map_err(|_| ConnectError::Ended)?
    }
}

impl Socket {
    pub(crate) fn new() -> Self {
        let (sender, asks) = mpsc::channel(1);
        let connector = Connector { asks: sender };
        Self { connector, asks }
    }

    pub(crate) fn connector(&self) -> Connector {
        self.connector.clone()
    }

    /// Waits for a client; `None` never comes, for this end holds a connector itself. Safe to cancel.
    pub(crate) async fn ask(&mut self) -> Option<Ask> {
        self.asks.recv().await
    }
}

impl Ask {
    /// Gives the client its end, and returns the other; none if it has gone away meanwhile.
    pub(crate) fn grant(self) -> Option<DuplexStream> {
        let (ours, theirs) = duplex(CAPACITY);
        self.0.send(Ok(theirs)).ok().map(|()| ours)
    }

    pub(crate) fn refuse(self, why: ConnectError) {
        // One that has gone away needs no reason.
        let _ = self.0.send(Err(why));
    }
}

/// What the kernel of a computer keeps for a serial port.
const CAPACITY: usize = 4096;
