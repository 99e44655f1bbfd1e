//! Finding a station.

use std::fmt;

use super::{CertificateTrust, StationAddress, StationAddressError, is_station};
use crate::{Folders, Running, RunningError};

/// Search options for a station.
#[derive(Clone, Default)]
pub struct StationSearch {
    /// The address; if absent, the environment variable `DOBOT_STATION`, then the station running
    /// on this machine.
    pub address: Option<String>,
    /// The access token, required for more than watching; if absent, the environment variable
    /// `DOBOT_TOKEN`, then the local station's token for programs of the same user.
    pub token: Option<String>,
    /// Why the certificate is trusted, over https.
    pub trust: Option<CertificateTrust>,
}

/// The error returned when no station can be searched for.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SearchError {
    /// The user has no home folder.
    #[error("this user has no home folder")]
    NoFolders,
    /// The address is invalid.
    #[error(transparent)]
    Address(#[from] StationAddressError),
    /// The file of the running station cannot be read.
    #[error(transparent)]
    Running(#[from] RunningError),
}

impl SearchError {
    /// Returns a hint on how to fix it.
    #[must_use]
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NoFolders => Some(
                "name the station's data folder: `--data FOLDER`, or the environment variable DOBOT_DATA",
            ),
            Self::Address(_) | Self::Running(_) => None,
        }
    }
}

impl StationSearch {
    /// Finds the station; `None` if none is named and none is running.
    ///
    /// # Errors
    ///
    /// [`SearchError`].
    pub async fn find(&self) -> Result<Option<StationAddress>, SearchError> {
        if let Some(name) = self.name() {
            return self.named(&name).map(Some);
        }
        if let Some(address) = running(&here()?)? {
            return Ok(Some(self.of_here(address)));
        }
        // A station with its own data folder is most likely at the default address.
        let usual = self.named(USUAL)?;
        let is_there = variable("DOBOT_DATA").is_none() && is_station(&usual).await;
        Ok(is_there.then_some(usual))
    }

    /// Returns the named address, if any.
    #[must_use]
    pub fn name(&self) -> Option<String> {
        self.address.clone().or_else(|| variable("DOBOT_STATION"))
    }

    /// Adds token and trust to the local station's address.
    fn of_here(&self, mut here: StationAddress) -> StationAddress {
        here.token = self.token.clone().or(here.token);
        here.trust = self.trust.clone().or(here.trust);
        here
    }

    fn named(&self, name: &str) -> Result<StationAddress, SearchError> {
        let mut address = StationAddress::new(name)?;
        address.token = self.token.clone().or_else(|| variable("DOBOT_TOKEN"));
        address.trust.clone_from(&self.trust);
        // The local station's token need not be given.
        if let Some(here) = running(&here()?)?
            .filter(|address_here| address_here.to_string() == address.to_string())
        {
            address.token = address.token.or(here.token);
            address.trust = address.trust.or(here.trust);
        }
        Ok(address)
    }
}

/// Hides the token.
impl fmt::Debug for StationSearch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { address, trust, .. } = self;
        write!(f, "StationSearch({address:?}, trust {trust:?})")
    }
}

/// Returns the address of the station running with these folders.
///
/// # Errors
///
/// [`SearchError`] if its file is invalid.
pub fn running(folders: &Folders) -> Result<Option<StationAddress>, SearchError> {
    let running = Running::read(&folders.running())?;
    let address = running
        .map(|running| StationAddress::of(&running))
        .transpose();
    Ok(address?)
}

fn here() -> Result<Folders, SearchError> {
    Folders::of_environment().ok_or(SearchError::NoFolders)
}

/// Returns an environment variable that is set and not empty.
fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|value| !value.is_empty())
}

/// The default address of a station.
const USUAL: &str = "http://127.0.0.1";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_explicit_token_is_used_even_at_the_station_of_this_machine() {
        let mut here = StationAddress::new(USUAL).expect("it is an address");
        here.token = Some("everything".to_owned());
        let token_for = |token: Option<&str>| {
            let search = StationSearch {
                token: token.map(str::to_owned),
                ..StationSearch::default()
            };
            search.of_here(here.clone()).token
        };
        assert_eq!(token_for(Some("less")).as_deref(), Some("less"));
        assert_eq!(token_for(None).as_deref(), Some("everything"));
    }
}
