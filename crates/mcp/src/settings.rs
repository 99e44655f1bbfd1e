//! How agents reach the arm.

use std::fmt;
use std::future::Future;
use std::pin::Pin;

use dobot_api::StationAddress;

use crate::FilesFolder;

/// How agents reach the arm, and what they may do.
pub struct Settings {
    find: Box<dyn Fn() -> Found + Send + Sync>,
    /// Drawings and programs are queued only, and a person starts each; other motion is refused. True unless it is set
    /// otherwise. Over HTTP the agent's token decides instead.
    pub asks: bool,
    /// Where the files are that agents may draw and run; none without it.
    pub files: Option<FilesFolder>,
}

type Found = Pin<Box<dyn Future<Output = Result<StationAddress, NoStation>> + Send>>;

/// Why no station is found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoStation {
    /// What is wrong, in one line.
    pub detail: String,
    /// What to do about it.
    pub hint: Option<String>,
}

impl Settings {
    /// The station at this address.
    #[must_use]
    pub fn at(station: StationAddress) -> Self {
        Self::finding(move || {
            let station = station.clone();
            async move { Ok(station) }
        })
    }

    /// The station that is found anew for each call: one that was started again has another token.
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
