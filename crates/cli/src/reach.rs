//! Finding a running station.

use std::path::PathBuf;

use anyhow::anyhow;
use dobot_api::{Folders, SearchError, StationAddress, StationOptions};
use dobot_host::StationClient;

use crate::failure::Failure;

/// The station, as the options name it.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct Station {
    #[command(flatten)]
    options: StationOptions,
}

impl Station {
    /// Whether an option or the environment names the station.
    pub(crate) fn is_named(&self) -> bool {
        self.options.search().name().is_some()
    }

    /// The address of the station; `None` if none is named and none runs.
    pub(crate) async fn address(&self) -> Result<Option<StationAddress>, Failure> {
        self.options.search().find().await.map_err(search_failure)
    }

    /// The address of the station, which must be named or running.
    pub(crate) async fn address_of_running(&self) -> Result<StationAddress, Failure> {
        self.address().await?.ok_or_else(|| {
            Failure::new(
                anyhow!("no station runs on this machine"),
                "start one with `dobot up`, or name one with `--station URL`; set DOBOT_DATA=FOLDER for a station with `--data FOLDER`",
            )
        })
    }

    /// Connects to the station, under the name of a verb.
    pub(crate) async fn client(&self, verb: &str) -> Result<StationClient, Failure> {
        let address = self.address_of_running().await?;
        Ok(StationClient::connect(&address, &client_name(verb)).await?)
    }
}

/// The folders of this user's station.
pub(crate) fn folders(data: Option<PathBuf>) -> Result<Folders, Failure> {
    let folders = data.map(Folders::at).or_else(Folders::of_environment);
    folders.ok_or_else(|| search_failure(SearchError::NoFolders))
}

/// The client name of a verb, as other clients see it.
pub(crate) fn client_name(verb: &str) -> String {
    format!("dobot {verb}")
}

fn search_failure(error: SearchError) -> Failure {
    match error.hint() {
        Some(hint) => Failure::new(error, hint),
        None => error.into(),
    }
}
