//! A router, by which stations of several networks find each other.

use zenoh::Session;

use crate::{Credentials, FleetError, config};

/// A router that runs. It carries what stations say to each other, and knows no arm.
#[derive(Debug)]
pub struct Router {
    session: Session,
}

impl Router {
    /// Starts a router at these addresses, each as in `quic/0.0.0.0:7447`.
    ///
    /// # Errors
    ///
    /// [`FleetError`].
    pub async fn start(listen: &[String], credentials: &Credentials) -> Result<Self, FleetError> {
        let session = zenoh::open(config::router(listen, credentials)?).await;
        let session = session.map_err(|error| FleetError::zenoh(&error))?;
        Ok(Self { session })
    }

    /// Ends it. The stations try to find it again for as long as they run.
    pub async fn end(self) {
        // They miss it by themselves.
        let _ = self.session.close().await;
    }
}
