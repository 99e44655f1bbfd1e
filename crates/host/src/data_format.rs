//! The format of a data folder, so that an older program leaves newer data alone.

use std::io;

use dobot_api::Folders;
use serde::{Deserialize, Serialize};

use crate::known_arms::{NewText, read_file};

/// The format of a data folder: the content of `format.toml`. A later version of this program reads data of every earlier
/// format, and raises the number when an earlier program could no longer use what it writes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct DataFormat {
    /// The format, counted from 1.
    pub format: u32,
    /// The program that wrote it, as in `dobot 0.1.0`.
    pub program: String,
}

/// Why a data folder cannot be used. Nothing in it was changed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DataFormatError {
    /// The file cannot be read or written.
    #[error("cannot read or write {file}")]
    File {
        /// The file.
        file: String,
        /// The operating system's error.
        #[source]
        source: io::Error,
    },
    /// Its content is invalid.
    #[error(
        "{file} does not give the format of the data ({why}); allowed is a line such as `format = 1` and one such as \
         `program = \"dobot 0.1.0\"`"
    )]
    Content {
        /// The file.
        file: String,
        /// The reason.
        why: String,
    },
    /// A newer version of this program wrote the data.
    #[error(
        "the data in {folder} has format {}, written by {}; {PROGRAM} knows formats up to {KNOWN}: use a newer version, \
         or another folder with `--data FOLDER`", .found.format, .found.program
    )]
    Newer {
        /// The data folder.
        folder: String,
        /// Its format.
        found: DataFormat,
    },
}

impl DataFormat {
    /// Returns the format of a data folder; `None` if nothing has used it yet.
    ///
    /// # Errors
    ///
    /// [`DataFormatError`] if the file cannot be read, or the format is a newer one.
    pub fn of(folders: &Folders) -> Result<Option<Self>, DataFormatError> {
        let file = folders.format();
        let text = read_file(&file).map_err(|source| DataFormatError::File {
            file: file.display().to_string(),
            source,
        })?;
        let Some(text) = text else {
            return Ok(None);
        };
        let found: Self = toml::from_str(&text).map_err(|error| DataFormatError::Content {
            file: file.display().to_string(),
            why: error.message().to_owned(),
        })?;
        if found.format > KNOWN {
            return Err(DataFormatError::Newer {
                folder: folders.data().display().to_string(),
                found,
            });
        }
        Ok(Some(found))
    }

    /// Checks that this program can use a data folder, and writes the format into a new one.
    pub(crate) fn claim(folders: &Folders) -> Result<(), DataFormatError> {
        if Self::of(folders)?.is_some() {
            return Ok(());
        }
        let own = Self {
            format: KNOWN,
            program: PROGRAM.to_owned(),
        };
        let file = folders.format();
        let written = folders
            .make_data()
            .and_then(|()| NewText::of(&file, &own)?.write());
        written.map_err(|source| DataFormatError::File {
            file: file.display().to_string(),
            source,
        })
    }
}

const PROGRAM: &str = concat!("dobot ", env!("CARGO_PKG_VERSION"));

/// The newest format that this version knows, which it writes.
const KNOWN: u32 = 1;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_data_of_a_newer_program_is_refused_and_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let folders = Folders::at(folder.path());
        let text = "format = 2\nprogram = \"dobot 0.3.0\"\nmore = true\n";
        fs::write(folders.format(), text).unwrap();
        let error = DataFormat::claim(&folders).unwrap_err().to_string();
        for part in ["format 2", "dobot 0.3.0", "up to 1", "--data FOLDER"] {
            assert!(error.contains(part), "`{part}` is missing: {error}");
        }
        assert_eq!(fs::read_to_string(folders.format()).unwrap(), text);
    }

    #[test]
    fn a_new_folder_gets_the_format_and_keeps_it() {
        let folder = tempfile::tempdir().unwrap();
        let folders = Folders::at(folder.path().join("new"));
        assert_eq!(DataFormat::of(&folders).unwrap(), None);
        DataFormat::claim(&folders).unwrap();
        let first = fs::read_to_string(folders.format()).unwrap();
        DataFormat::claim(&folders).unwrap();
        assert_eq!(fs::read_to_string(folders.format()).unwrap(), first);
        assert_eq!(DataFormat::of(&folders).unwrap().unwrap().format, 1);
    }

    #[test]
    fn a_format_that_is_no_number_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let folders = Folders::at(folder.path());
        fs::write(folders.format(), "format = \"one\"\n").unwrap();
        let error = DataFormat::claim(&folders).unwrap_err().to_string();
        assert!(
            error.contains("format.toml") && error.contains("format = 1"),
            "{error}"
        );
    }
}
