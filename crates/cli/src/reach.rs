//! From options and files to a running station.

use std::path::PathBuf;

use anyhow::anyhow;
use dobot_api::{CertificateTrust, Folders, Running, StationAddress, fingerprint, is_station};
use dobot_rules::StationClient;
use dobot_station::DEFAULT_HTTP;

use crate::failure::Failure;

/// Which station.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct Station {
    /// The station's address, as in <http://127.0.0.1:8642>
    ///
    /// Without it, the environment variable `DOBOT_STATION` is used, and then the station that
    /// runs on this machine: the one of this person's data folder, or what answers at port 8642.
    #[arg(id = "station", long = "station", value_name = "URL", global = true)]
    address: Option<String>,
    /// What allows more than watching; better given in the environment variable `DOBOT_TOKEN`
    #[arg(long, value_name = "TOKEN", global = true, hide_short_help = true)]
    token: Option<String>,
    /// The SHA-256 digest of the station's certificate, which the station prints when it starts
    #[arg(long, value_name = "DIGEST", global = true, hide_short_help = true, value_parser = fingerprint)]
    fingerprint: Option<[u8; 32]>,
    /// A PEM file with the certificate that the station's own one was issued by
    #[arg(
        long,
        value_name = "FILE",
        global = true,
        hide_short_help = true,
        conflicts_with = "fingerprint"
    )]
    ca: Option<PathBuf>,
}

impl Station {
    /// Whether a person said which station it is to be.
    pub(crate) fn is_named(&self) -> bool {
        self.name().is_some()
    }

    /// Where the station is; `None` where none is named and none says that it runs.
    pub(crate) async fn address(&self) -> Result<Option<StationAddress>, Failure> {
        if let Some(name) = self.name() {
            return self.named(&name).map(Some);
        }
        if let Some(address) = running(&folders(None)?)? {
            return Ok(Some(address));
        }
        // One that was started with a folder of its own is most likely where all are.
        let usual = self.named(&format!("http://{DEFAULT_HTTP}"))?;
        let is_there = variable("DOBOT_DATA").is_none() && is_station(&usual).await;
        Ok(is_there.then_some(usual))
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

    fn name(&self) -> Option<String> {
        self.address.clone().or_else(|| variable("DOBOT_STATION"))
    }

    fn named(&self, name: &str) -> Result<StationAddress, Failure> {
        let mut address = StationAddress::new(name)?;
        address.token = self.token.clone().or_else(|| variable("DOBOT_TOKEN"));
        let fingerprint = self.fingerprint.map(CertificateTrust::Fingerprint);
        address.trust = fingerprint.or_else(|| self.ca.clone().map(CertificateTrust::Authority));
        // Whoever names the station of this machine need not know its token.
        if let Some(here) =
            running(&folders(None)?)?.filter(|it| it.to_string() == address.to_string())
        {
            address.token = address.token.or(here.token);
            address.trust = address.trust.or(here.trust);
        }
        Ok(address)
    }
}

/// The folders of this person's station.
pub(crate) fn folders(data: Option<PathBuf>) -> Result<Folders, Failure> {
    let data = data.or_else(|| variable("DOBOT_DATA").map(PathBuf::from));
    let folders = data.map(Folders::at).or_else(Folders::of_person);
    folders.ok_or_else(|| {
        Failure::new(
            anyhow!("this person has no home folder"),
            "say where the station keeps its data: `--data FOLDER`, or the environment variable DOBOT_DATA",
        )
    })
}

/// What the others call a verb of this program.
pub(crate) fn client_name(verb: &str) -> String {
    format!("dobot {verb}")
}

/// Where the station of these folders says that it runs.
pub(crate) fn running(folders: &Folders) -> Result<Option<StationAddress>, Failure> {
    let Some(running) = Running::read(&folders.running())? else {
        return Ok(None);
    };
    Ok(Some(StationAddress::of(&running)?))
}

/// An environment variable that is set to something.
fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|it| !it.is_empty())
}
