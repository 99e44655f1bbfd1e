//! Where a station keeps what it has to remember.

use std::path::{Path, PathBuf};

use directories::ProjectDirs;
use dobot_client::Address;

/// Where a station keeps what it has to remember, and where it says that it runs.
///
/// ```
/// use dobot_station::Folders;
///
/// let folders = Folders::at("/srv/dobot");
/// assert_eq!(folders.journal(), std::path::Path::new("/srv/dobot/journal.redb"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folders {
    data: PathBuf,
    runtime: PathBuf,
}

impl Folders {
    /// Everything in one folder.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        let data = folder.into();
        Self {
            runtime: data.clone(),
            data,
        }
    }

    /// The folders that the system has for this person's programs; `None` for one without a home.
    #[must_use]
    pub fn of_person() -> Option<Self> {
        let folders = ProjectDirs::from("", "", "dobot")?;
        let data = folders.data_local_dir();
        Some(Self {
            data: data.to_owned(),
            runtime: folders.runtime_dir().unwrap_or(data).to_owned(),
        })
    }

    /// The folder that outlives the station.
    #[must_use]
    pub fn data(&self) -> &Path {
        &self.data
    }

    /// The jobs.
    #[must_use]
    pub fn journal(&self) -> PathBuf {
        self.data.join("journal.redb")
    }

    /// The recordings, a folder.
    #[must_use]
    pub fn recordings(&self) -> PathBuf {
        self.data.join("recordings")
    }

    /// Who may do what.
    #[must_use]
    pub fn tokens(&self) -> PathBuf {
        self.data.join("tokens.toml")
    }

    /// What is known of each arm that was met.
    #[must_use]
    pub fn arms(&self) -> PathBuf {
        self.data.join("arms.toml")
    }

    /// What the guardian of the arm did while the station could not.
    #[must_use]
    pub fn guardian(&self) -> PathBuf {
        self.data.join("guardian.txt")
    }

    /// The station's own certificate and its key, a folder.
    #[must_use]
    pub fn tls(&self) -> PathBuf {
        self.data.join("tls")
    }

    /// The folder of an arm that is used without a station: its jobs.
    #[must_use]
    pub fn of_arm(&self, address: &Address) -> Self {
        let plain = |it: char| if it.is_ascii_alphanumeric() { it } else { '-' };
        let name: String = address.to_string().chars().map(plain).collect();
        Self::at(self.data.join("arms").join(name))
    }

    /// What a running station says of itself; absent while none runs.
    #[must_use]
    pub fn running(&self) -> PathBuf {
        self.runtime.join("station.toml")
    }
}
