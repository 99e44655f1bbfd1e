//! Settings of the tools.

use std::fmt;
use std::future::Future;
use std::pin::Pin;

use dobot_api::StationAddress;

use crate::FilesFolder;

/// Settings of the tools: the station, and the rights of agents.
pub struct Settings {
    find: Box<dyn Fn() -> Found + Send + Sync>,
    /// Whether drawings and programs are only queued, for a person to start, and other motion is
    /// refused (default: true). Over HTTP the agent's token decides instead.
    pub asks: bool,
    /// The folder of the files that agents may use; none if absent.
    pub files: Option<FilesFolder>,
}

type Found = Pin<Box<dyn Future<Output = Result<StationAddress, NoStation>> + Send>>;

/// The error returned when no station is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoStation {
    /// The problem, in one line.
    pub detail: String,
    /// The remedy.
    pub hint: Option<String>,
}

impl Settings {
    /// Uses the station at this address.
    #[must_use]
    pub fn at(station: StationAddress) -> Self {
        Self::finding(move || {
            let station = station.clone();
            async move { Ok(station) }
        })
    }

    /// Searches the station for each call: a restarted station has another token.
    #[must_use]
    pub fn finding<F>(find: impl Fn() -> F + Send + Sync + 'static) -> Self
    where
        F: Future<Output = Result<StationAddress, NoStation>> + Send + 'static,
    {
        Self {
            find: Box::new(move || Box::pin(find())),
            asks: true,
            files: None,
        }
    }

    pub(crate) async fn station(&self) -> Result<StationAddress, NoStation> {
        (self.find)().await
    }
}

impl fmt::Debug for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Settings")
            .field("asks", &self.asks)
            .field("files", &self.files)
            .finish_non_exhaustive()
    }
}
