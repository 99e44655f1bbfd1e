//! Finding the station that is meant.

use std::fmt;

use super::{CertificateTrust, StationAddress, StationAddressError, is_station};
use crate::{Folders, Running, RunningError};

/// How the station is found that a person means.
#[derive(Clone, Default)]
pub struct StationSearch {
    /// Its address; without it, that of the environment variable `DOBOT_STATION`, and then that of the station
    /// that runs on this machine.
    pub address: Option<String>,
    /// What allows more than watching; without it, the environment variable `DOBOT_TOKEN`, and then what the station
    /// of this machine says to programs of the same person.
    pub token: Option<String>,
    /// Why one may trust what answers, over https.
    pub trust: Option<CertificateTrust>,
}

/// Why no station can be looked for.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SearchError {
    /// This person has no home folder.
    #[error("this person has no home folder")]
    NoFolders,
    /// What is to be its address is none.
    #[error(transparent)]
    Address(#[from] StationAddressError),
    /// The file of the station that runs cannot be read.
    #[error(transparent)]
    Running(#[from] RunningError),
}

impl SearchError {
    /// What to do about it.
    #[must_use]
    pub const fn hint(&self) -> Option<&'static str> {
        match self {
            Self::NoFolders => Some(
                "say where the station keeps its data: `--data FOLDER`, or the environment variable DOBOT_DATA",
            ),
            Self::Address(_) | Self::Running(_) => None,
        }
    }
}

impl StationSearch {
    /// Where the station is; `None` where none is named and none says that it runs.
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
        // One that was started with a folder of its own is most likely where all are.
        let usual = self.named(USUAL)?;
        let is_there = variable("DOBOT_DATA").is_none() && is_station(&usual).await;
        Ok(is_there.then_some(usual))
    }

    /// The address that a person named, if one did.
    #[must_use]
    pub fn name(&self) -> Option<String> {
        self.address.clone().or_else(|| variable("DOBOT_STATION"))
    }

    /// The station of this machine, with what was said of it.
    fn of_here(&self, mut here: StationAddress) -> StationAddress {
        here.token = self.token.clone().or(here.token);
        here.trust = self.trust.clone().or(here.trust);
        here
    }

    fn named(&self, name: &str) -> Result<StationAddress, SearchError> {
        let mut address = StationAddress::new(name)?;
        address.token = self.token.clone().or_else(|| variable("DOBOT_TOKEN"));
        address.trust.clone_from(&self.trust);
        // Whoever names the station of this machine need not know its token.
        if let Some(here) = running(&here()?)?.filter(|it| it.to_string() == address.to_string()) {
            address.token = address.token.or(here.token);
            address.trust = address.trust.or(here.trust);
        }
        Ok(address)
    }
}

/// The token is nobody's business.
impl fmt::Debug for StationSearch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { address, trust, .. } = self;
        write!(f, "StationSearch({address:?}, trust {trust:?})")
    }
}

/// Where the station of these folders says that it runs.
///
/// # Errors
///
/// [`SearchError`] where it says what makes no sense.
pub fn running(folders: &Folders) -> Result<Option<StationAddress>, SearchError> {
    let running = Running::read(&folders.running())?;
    let address = running.map(|it| StationAddress::of(&it)).transpose();
    Ok(address?)
}

fn here() -> Result<Folders, SearchError> {
    Folders::of_environment().ok_or(SearchError::NoFolders)
}

/// An environment variable that is set to something.
fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|it| !it.is_empty())
}

/// Where a station is served unless told otherwise.
const USUAL: &str = "http://127.0.0.1";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_says_a_token_is_known_by_that_one_at_the_station_of_this_machine_too() {
        let mut here = StationAddress::new(USUAL).expect("it is an address");
        here.token = Some("everything".to_owned());
        let says = |token: Option<&str>| {
            let search = StationSearch {
                token: token.map(str::to_owned),
                ..StationSearch::default()
            };
            search.of_here(here.clone()).token
        };
        assert_eq!(says(Some("less")).as_deref(), Some("less"));
        assert_eq!(says(None).as_deref(), Some("everything"));
    }
}
