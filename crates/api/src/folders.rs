//! Where a station keeps what it has to remember.

use std::path::{Path, PathBuf};

use directories::ProjectDirs;

/// Where a station keeps what it has to remember, and where it says that it runs.
///
/// ```
/// use dobot_api::Folders;
///
/// let folders = Folders::at("/srv/dobot");
/// assert_eq!(folders.journal(), std::path::Path::new("/srv/dobot/journal.redb"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folders {
    data: PathBuf,
    runtime: PathBuf,
    /// Who may do what, and by what the station is known.
    identity: PathBuf,
}

/// Makes a folder that is for this person's eyes only, and those above it. One that is there stays as it is.
///
/// # Errors
///
/// What the operating system says.
pub fn make_private(folder: &Path) -> std::io::Result<()> {
    let mut make = std::fs::DirBuilder::new();
    make.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut make, 0o700);
    make.create(folder)
}

impl Folders {
    /// Everything in one folder.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        let data = folder.into();
        Self {
            runtime: data.clone(),
            identity: data.clone(),
            data,
        }
    }

    /// Those of a virtual arm that the station of these folders gives to somebody, with its own jobs and recordings: it
    /// accepts the station's tokens, and has its certificate.
    #[must_use]
    pub fn of_virtual_arm(&self, name: &str) -> Self {
        let data = self.virtual_arms().join(name);
        Self {
            runtime: data.clone(),
            data,
            identity: self.identity.clone(),
        }
    }

    /// What the virtual arms that the station gives have to remember, a folder for each.
    #[must_use]
    pub fn virtual_arms(&self) -> PathBuf {
        self.data.join("virtual-arms")
    }

    /// The folders that the system has for this person's programs; `None` for one without a home.
    #[must_use]
    pub fn of_person() -> Option<Self> {
        let folders = ProjectDirs::from("", "", "dobot")?;
        let data = folders.data_local_dir();
        Some(Self {
            data: data.to_owned(),
            identity: data.to_owned(),
            runtime: folders.runtime_dir().unwrap_or(data).to_owned(),
        })
    }

    /// The folder that the environment variable `DOBOT_DATA` names, otherwise those of this person.
    #[must_use]
    pub fn of_environment() -> Option<Self> {
        let named = std::env::var_os("DOBOT_DATA").filter(|it| !it.is_empty());
        named.map(Self::at).or_else(Self::of_person)
    }

    /// Makes the folder that outlives the station, for this person's eyes only; one that is there stays
    /// as it is.
    ///
    /// # Errors
    ///
    /// What the operating system says.
    pub fn make_data(&self) -> std::io::Result<()> {
        make_private(&self.data)
    }

    /// The folder that outlives the station.
    #[must_use]
    pub fn data(&self) -> &Path {
        &self.data
    }

    /// The policy, where a client has put one in place of the default.
    #[must_use]
    pub fn policy(&self) -> PathBuf {
        self.data.join("policy.toml")
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
        self.identity.join("tokens.toml")
    }

    /// The options that a person gives each drawing.
    #[must_use]
    pub fn drawing_defaults(&self) -> PathBuf {
        self.data.join("draw.toml")
    }

    /// What is known of each arm that was met.
    #[must_use]
    pub fn arms(&self) -> PathBuf {
        self.data.join("arms.toml")
    }

    /// Whose time it is at the arm, and when.
    #[must_use]
    pub fn slots(&self) -> PathBuf {
        self.data.join("slots.toml")
    }

    /// The stop that holds the arm, if one does.
    #[must_use]
    pub fn stop(&self) -> PathBuf {
        self.data.join("stop.toml")
    }

    /// What the watchdog of the arm did while the station could not.
    #[must_use]
    pub fn watchdog(&self) -> PathBuf {
        self.data.join("watchdog.txt")
    }

    /// The number that the station goes by in a fleet.
    #[must_use]
    pub fn fleet_id(&self) -> PathBuf {
        self.data.join("fleet-id.txt")
    }

    /// The work for any arm of the fleet that was submitted to the station, a folder.
    #[must_use]
    pub fn fleet_work(&self) -> PathBuf {
        self.data.join("fleet-work")
    }

    /// The station's own certificate and its key, a folder.
    #[must_use]
    pub fn tls(&self) -> PathBuf {
        self.identity.join("tls")
    }

    /// The folder of an arm that is used without a station, by the text of its address: its jobs.
    #[must_use]
    pub fn of_arm(&self, address: &str) -> Self {
        let plain = |it: char| if it.is_ascii_alphanumeric() { it } else { '-' };
        let name: String = address.chars().map(plain).collect();
        Self::at(self.data.join("arms").join(name))
    }

    /// What a running station says of itself; absent while none runs.
    #[must_use]
    pub fn running(&self) -> PathBuf {
        self.runtime.join("station.toml")
    }
}

#[cfg(all(test, unix))]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    use super::*;

    #[test]
    fn a_new_folder_is_for_its_owner_alone_and_one_that_is_there_stays_as_it_is() {
        let mode = |folder: &Path| folder.metadata().unwrap().permissions().mode() & 0o777;
        let above = tempfile::tempdir().unwrap();
        std::fs::set_permissions(above.path(), std::fs::Permissions::from_mode(0o755)).unwrap();
        let folder = above.path().join("data");
        make_private(&folder).unwrap();
        assert_eq!(mode(&folder), 0o700);
        make_private(above.path()).unwrap();
        assert_eq!(mode(above.path()), 0o755);
    }
}
