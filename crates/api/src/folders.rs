//! The folders where a station keeps its data.

use std::path::{Path, PathBuf};

use directories::ProjectDirs;

/// The folders where a station keeps its data and its runtime file.
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
    /// Access tokens, certificate and fleet id.
    identity: PathBuf,
}

/// Creates a private folder (readable by this user only) and its parents. An existing folder is
/// left unchanged.
///
/// # Errors
///
/// The operating system's error.
pub fn make_private(folder: &Path) -> std::io::Result<()> {
    let mut make = std::fs::DirBuilder::new();
    make.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut make, 0o700);
    make.create(folder)
}

impl Folders {
    /// Puts everything in one folder.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        let data = folder.into();
        Self {
            runtime: data.clone(),
            identity: data.clone(),
            data,
        }
    }

    /// Returns the folders of a virtual arm hosted by this station, with its own jobs and
    /// recordings; it accepts the station's tokens and uses its certificate.
    #[must_use]
    pub fn of_virtual_arm(&self, name: &str) -> Self {
        let data = self.virtual_arms().join(name);
        Self {
            runtime: data.clone(),
            data,
            identity: self.identity.clone(),
        }
    }

    /// The folder for the data of hosted virtual arms, one subfolder each.
    #[must_use]
    pub fn virtual_arms(&self) -> PathBuf {
        self.data.join("virtual-arms")
    }

    /// The system's folders for this user's programs; `None` if the user has no home folder.
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

    /// The folder named by the environment variable `DOBOT_DATA`, otherwise this user's folders.
    #[must_use]
    pub fn of_environment() -> Option<Self> {
        let named = std::env::var_os("DOBOT_DATA").filter(|folder| !folder.is_empty());
        named.map(Self::at).or_else(Self::of_person)
    }

    /// Creates the persistent data folder, private to this user. An existing folder is left
    /// unchanged.
    ///
    /// # Errors
    ///
    /// The operating system's error.
    pub fn make_data(&self) -> std::io::Result<()> {
        make_private(&self.data)
    }

    /// The persistent data folder.
    #[must_use]
    pub fn data(&self) -> &Path {
        &self.data
    }

    /// The file with the format of the data.
    #[must_use]
    pub fn format(&self) -> PathBuf {
        self.data.join("format.toml")
    }

    /// The policy file, present if a client has replaced the default policy.
    #[must_use]
    pub fn policy(&self) -> PathBuf {
        self.data.join("policy.toml")
    }

    /// The job database.
    #[must_use]
    pub fn journal(&self) -> PathBuf {
        self.data.join("journal.redb")
    }

    /// The folder of recordings.
    #[must_use]
    pub fn recordings(&self) -> PathBuf {
        self.data.join("recordings")
    }

    /// The file of the buttons that people have added to the page.
    #[must_use]
    pub fn buttons(&self) -> PathBuf {
        self.data.join("buttons.json")
    }

    /// The folder of stored files.
    #[must_use]
    pub fn files(&self) -> PathBuf {
        self.data.join("files")
    }

    /// The folder of optional parts of the page.
    #[must_use]
    pub fn extras(&self) -> PathBuf {
        self.data.join("extras")
    }

    /// The file of webhooks and commands, written by the administrator.
    #[must_use]
    pub fn hooks(&self) -> PathBuf {
        self.data.join("hooks.toml")
    }

    /// The file of access tokens.
    #[must_use]
    pub fn tokens(&self) -> PathBuf {
        self.identity.join("tokens.toml")
    }

    /// The file of the user's default drawing options.
    #[must_use]
    pub fn drawing_defaults(&self) -> PathBuf {
        self.data.join("draw.toml")
    }

    /// The file of known arms.
    #[must_use]
    pub fn arms(&self) -> PathBuf {
        self.data.join("arms.toml")
    }

    /// The file of time slots.
    #[must_use]
    pub fn slots(&self) -> PathBuf {
        self.data.join("slots.toml")
    }

    /// The file of the stop that holds the arm.
    #[must_use]
    pub fn stop(&self) -> PathBuf {
        self.data.join("stop.toml")
    }

    /// The watchdog's report of what it did while the station was not responding.
    #[must_use]
    pub fn watchdog(&self) -> PathBuf {
        self.data.join("watchdog.txt")
    }

    /// The file of the station's fleet id.
    #[must_use]
    pub fn fleet_id(&self) -> PathBuf {
        self.data.join("fleet-id.txt")
    }

    /// The folder of fleet jobs submitted to this station.
    #[must_use]
    pub fn fleet_work(&self) -> PathBuf {
        self.data.join("fleet-work")
    }

    /// The folder of the station's certificate and key.
    #[must_use]
    pub fn tls(&self) -> PathBuf {
        self.identity.join("tls")
    }

    /// The data folder of an arm used without a station, by the text of its address: its jobs.
    #[must_use]
    pub fn of_arm(&self, address: &str) -> Self {
        let plain = |character: char| {
            if character.is_ascii_alphanumeric() {
                character
            } else {
                '-'
            }
        };
        let name: String = address.chars().map(plain).collect();
        Self::at(self.data.join("arms").join(name))
    }

    /// The file that describes the running station; absent while none runs.
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
    fn a_new_folder_is_private_and_an_existing_one_is_unchanged() {
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
