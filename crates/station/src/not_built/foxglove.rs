//! The port for Foxglove, in a build without it.

use std::convert::Infallible;
use std::net::SocketAddr;

use dobot_api::NotBuilt;
use dobot_host::StationHandle;

/// A port that this build cannot open.
#[derive(Debug)]
pub struct FoxglovePort(Infallible);

/// The error returned when the port for Foxglove cannot be opened.
pub use dobot_api::NotBuilt as FoxglovePortError;

impl FoxglovePort {
    /// Always fails.
    ///
    /// # Errors
    ///
    /// Always [`NotBuilt`].
    #[expect(clippy::unused_async, reason = "with the feature `full` it waits")]
    pub async fn bind(_: SocketAddr) -> Result<Self, FoxglovePortError> {
        Err(NotBuilt("Foxglove"))
    }

    /// Returns the address of the port.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        match self.0 {}
    }

    /// Serves until the station ends.
    ///
    /// # Errors
    ///
    /// None: there is no such port.
    #[expect(clippy::unused_async, reason = "with the feature `full` it waits")]
    pub async fn serve(self, _: &StationHandle) -> Result<(), String> {
        match self.0 {}
    }
}
