//! The world around a served arm.

use std::io;
use std::time::Duration;

use tokio::io::AsyncWriteExt;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::timeout;

use super::Server;
use crate::world::World;

impl Server {
    /// Serves the state of the world: each client of the listener receives one JSON
    /// document, a [`WorldState`](crate::world::WorldState), or `null` if the arm has no world.
    #[must_use]
    pub fn on_world(mut self, listener: TcpListener) -> Self {
        self.world = Some(listener);
        self
    }

    /// Sends the state of the world; the arm keeps running meanwhile.
    pub(super) fn show_world(&self, mut stream: TcpStream) -> io::Result<()> {
        let state = self.arm.world().map(World::state);
        let document = serde_json::to_vec(&state).map_err(io::Error::other)?;
        tokio::spawn(async move {
            // A client that does not read in time is disconnected.
            let read = async {
                stream.write_all(&document).await?;
                stream.shutdown().await
            };
            let _ = timeout(TIME_TO_READ, read).await;
        });
        Ok(())
    }
}

/// The timeout for sending the state of the world.
const TIME_TO_READ: Duration = Duration::from_secs(10);
