//! Command-line options that select a station.

use std::path::PathBuf;

use super::{CertificateTrust, StationSearch, fingerprint};

/// The station that a program's options select.
#[derive(Clone, Default, clap::Args)]
pub struct StationOptions {
    /// Address of the station, for example `http://127.0.0.1:8642`
    ///
    /// If absent, the environment variable `DOBOT_STATION` is used, then the station running on
    /// this machine: the one with this user's data folder, or the one at port 8642.
    #[arg(
        id = "station",
        long = "station",
        value_name = "URL",
        global = true,
        help_heading = "Connection"
    )]
    address: Option<String>,
    /// Access token, required for more than watching; prefer the environment variable `DOBOT_TOKEN`
    #[arg(
        long,
        value_name = "TOKEN",
        global = true,
        hide_short_help = true,
        help_heading = "Connection"
    )]
    token: Option<String>,
    /// SHA-256 digest of the station's certificate, printed when the station starts
    #[arg(long, value_name = "DIGEST", global = true, hide_short_help = true, help_heading = "Connection", value_parser = fingerprint)]
    fingerprint: Option<[u8; 32]>,
    /// PEM file with the certificate of the authority that issued the station's certificate
    #[arg(
        long,
        value_name = "FILE",
        global = true,
        hide_short_help = true,
        help_heading = "Connection",
        conflicts_with = "fingerprint"
    )]
    ca: Option<PathBuf>,
}

impl StationOptions {
    /// Returns the search for the selected station.
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

/// Hides the token.
impl std::fmt::Debug for StationOptions {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("StationOptions")
            .field(&self.search())
            .finish()
    }
}
