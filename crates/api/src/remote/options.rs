//! The options by which a program finds its station.

use std::path::PathBuf;

use super::{CertificateTrust, StationSearch, fingerprint};

/// Which station, as the options of a program say it.
#[derive(Clone, Default, clap::Args)]
pub struct StationOptions {
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

impl StationOptions {
    /// How the station is found that they mean.
    #[must_use]
    pub fn search(&self) -> StationSearch {
        let fingerprint = self.fingerprint.map(CertificateTrust::Fingerprint);
        StationSearch {
            address: self.address.clone(),
            token: self.token.clone(),
            trust: fingerprint.or_else(|| self.ca.clone().map(CertificateTrust::Authority)),
        }
    }
}

/// The token is nobody's business.
impl std::fmt::Debug for StationOptions {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("StationOptions")
            .field(&self.search())
            .finish()
    }
}
