//! The station of the arm: searched again for each connection, since a restarted station has
//! another token.

use dobot_api::{ConnectError, RemoteError, StationAddress, StationOptions, fetch};
use dobot_host::StationClient;
use dobot_safety::Policy;

/// The options for finding the station.
#[derive(Clone, Debug)]
pub(crate) struct Station {
    options: StationOptions,
}

impl Station {
    pub(crate) const fn new(options: StationOptions) -> Self {
        Self { options }
    }

    /// Opens a connection with a name for others; what it holds ends with it.
    ///
    /// # Errors
    ///
    /// The problem and the remedy.
    pub(crate) async fn connect(&self, name: &str) -> Result<StationClient, String> {
        let address = self.address().await?;
        let connected = StationClient::connect(&address, &format!("ros2 {name}")).await;
        connected.map_err(|error| not_connected(&error))
    }

    /// Returns the policy of the station.
    pub(crate) async fn policy(&self) -> Option<Policy> {
        let address = self.address().await.ok()?;
        fetch(&address, "/api/v1/policy").await.ok()
    }

    async fn address(&self) -> Result<StationAddress, String> {
        let found = self.options.search().find().await;
        let found = found.map_err(|error| with_hint(&error, error.hint()))?;
        found.ok_or_else(|| {
            "no station runs on this machine; start one with `dobot up`, or give another one with `--station URL`".to_owned()
        })
    }
}

fn not_connected(error: &ConnectError) -> String {
    with_hint(error, error.hint())
}

/// Returns the station's refusal, with its hint.
pub(crate) fn refused(error: &RemoteError) -> String {
    with_hint(error, error.hint())
}

fn with_hint(error: &impl std::fmt::Display, hint: Option<impl AsRef<str>>) -> String {
    match hint {
        Some(hint) => format!("{error}; {}", hint.as_ref()),
        None => error.to_string(),
    }
}
