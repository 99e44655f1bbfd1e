//! How programs on the same machine find a running station.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::folders::make_private;

/// A running station's description for programs of the same user on the same machine: the contents
/// of `station.toml`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Running {
    /// The address, as in `http://127.0.0.1:8642`.
    pub address: String,
    /// The process id.
    pub pid: u32,
    /// An admin token, available to every process that can read the file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub token: Option<String>,
    /// The SHA-256 digest of its certificate in hexadecimal digits, if it is served with TLS.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fingerprint: Option<String>,
}

impl Running {
    /// Reads the file; `None` if it does not exist, so no station runs.
    ///
    /// The file may remain after a station was killed: connect to find out whether it runs.
    ///
    /// # Errors
    ///
    /// [`RunningError`] if the file cannot be read or parsed.
    pub fn read(file: &Path) -> Result<Option<Self>, RunningError> {
        let text = match fs::read_to_string(file) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(RunningError::io(file, error)),
        };
        let running = toml::from_str(&text).map_err(|error| RunningError::Content {
            file: file.display().to_string(),
            why: error.message().to_owned(),
        })?;
        Ok(Some(running))
    }

    /// Writes the file, private to this user.
    ///
    /// # Errors
    ///
    /// [`RunningError`] if it cannot be written.
    ///
    /// # Panics
    ///
    /// Never: a table of strings and a number can always be written as TOML.
    pub fn write(&self, file: &Path) -> Result<(), RunningError> {
        let text = toml::to_string(self).expect("a table of texts and a number is TOML");
        let written = || {
            if let Some(folder) = file.parent() {
                make_private(folder)?;
            }
            // An existing file would keep its permissions, so remove it first.
            remove(file)?;
            private().open(file)?.write_all(text.as_bytes())
        };
        written().map_err(|error| RunningError::io(file, error))
    }

    /// Removes the file, unless another station has written it since.
    ///
    /// # Errors
    ///
    /// [`RunningError`] if it cannot be removed.
    pub fn remove(&self, file: &Path) -> Result<(), RunningError> {
        if Self::read(file)?.as_ref() == Some(self) {
            remove(file).map_err(|error| RunningError::io(file, error))?;
        }
        Ok(())
    }
}

/// The error returned when the file of a running station is unusable.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunningError {
    /// The file cannot be read, written or removed.
    #[error("{file}")]
    Io {
        /// The file.
        file: String,
        /// The operating system's error.
        #[source]
        source: io::Error,
    },
    /// The contents are invalid.
    #[error("{file} does not describe a station: {why}")]
    Content {
        /// The file.
        file: String,
        /// The reason.
        why: String,
    },
}

impl RunningError {
    fn io(file: &Path, source: io::Error) -> Self {
        Self::Io {
            file: file.display().to_string(),
            source,
        }
    }
}

fn remove(file: &Path) -> io::Result<()> {
    match fs::remove_file(file) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Options for a new private file, where the system supports that.
fn private() -> fs::OpenOptions {
    let mut options = fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn running(pid: u32) -> Running {
        Running {
            address: "http://127.0.0.1:8642".into(),
            pid,
            token: Some("secret".into()),
            fingerprint: None,
        }
    }

    #[test]
    fn the_file_of_a_station_is_read_back_and_deleted_when_it_ends() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("run/station.toml");
        assert_eq!(Running::read(&file).unwrap(), None);
        running(7).write(&file).unwrap();
        assert_eq!(Running::read(&file).unwrap(), Some(running(7)));
        running(7).remove(&file).unwrap();
        assert_eq!(Running::read(&file).unwrap(), None);
    }

    #[test]
    fn the_file_of_a_later_station_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("station.toml");
        running(8).write(&file).unwrap();
        running(7).remove(&file).unwrap();
        assert_eq!(Running::read(&file).unwrap(), Some(running(8)));
    }

    #[cfg(unix)]
    #[test]
    fn only_the_owner_may_read_the_token_even_if_a_public_file_existed() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("station.toml");
        fs::write(&file, "").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o644)).unwrap();
        running(7).write(&file).unwrap();
        let mode = fs::metadata(&file).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o600, "{mode:o}");
    }

    #[test]
    fn a_file_with_other_content_is_reported_by_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("station.toml");
        fs::write(&file, "address = 7").unwrap();
        let error = Running::read(&file).unwrap_err().to_string();
        assert!(error.contains("station.toml"), "{error}");
    }
}
