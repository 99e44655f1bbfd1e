//! Routers, which connect stations of several networks.

use zenoh::Session;

use crate::{Credentials, FleetError, config};

/// A running router. It forwards messages between stations and has no arm.
#[derive(Debug)]
pub struct Router {
    session: Session,
}

impl Router {
    /// Starts a router that listens on these addresses, as in `quic/0.0.0.0:7447`.
    ///
    /// # Errors
    ///
    /// [`FleetError`].
    pub async fn start(listen: &[String], credentials: &Credentials) -> Result<Self, FleetError> {
        let session = zenoh::open(config::router(listen, credentials)?).await;
        let session = session.map_err(|error| FleetError::zenoh(&error))?;
        Ok(Self { session })
    }

    /// Ends the router. The stations keep trying to reconnect.
    pub async fn end(self) {
        // The stations notice by themselves.
        let _ = self.session.close().await;
    }
}
