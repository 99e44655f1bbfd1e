//! From options and files to a running station.

use std::path::PathBuf;

use anyhow::anyhow;
use dobot_api::{Folders, SearchError, StationAddress, StationOptions};
use dobot_host::StationClient;

use crate::failure::Failure;

/// The station, as the options name it.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Connection")]
pub(crate) struct Station {
    #[command(flatten)]
    options: StationOptions,
}

impl Station {
    /// Whether a person said which station it is to be.
    pub(crate) fn is_named(&self) -> bool {
        self.options.search().name().is_some()
    }

    /// Where the station is; `None` where none is named and none says that it runs.
    pub(crate) async fn address(&self) -> Result<Option<StationAddress>, Failure> {
        self.options.search().find().await.map_err(no_search)
    }

    /// Where the station is.
    pub(crate) async fn address_of_running(&self) -> Result<StationAddress, Failure> {
        self.address().await?.ok_or_else(|| {
            Failure::new(
                anyhow!("no station runs on this machine"),
                "`dobot up` starts one; one with `--data FOLDER` and another port than 8642 is found with DOBOT_DATA=FOLDER, and any one with `--station URL`",
            )
        })
    }

    /// Connects with the station, under the name of a verb.
    pub(crate) async fn client(&self, verb: &str) -> Result<StationClient, Failure> {
        let address = self.address_of_running().await?;
        Ok(StationClient::connect(&address, &client_name(verb)).await?)
    }
}

/// The folders of this person's station.
pub(crate) fn folders(data: Option<PathBuf>) -> Result<Folders, Failure> {
    let folders = data.map(Folders::at).or_else(Folders::of_environment);
    folders.ok_or_else(|| no_search(SearchError::NoFolders))
}

/// What the others call a verb of this program.
pub(crate) fn client_name(verb: &str) -> String {
    format!("dobot {verb}")
}

fn no_search(error: SearchError) -> Failure {
    match error.hint() {
        Some(hint) => Failure::new(error, hint),
        None => error.into(),
    }
}
