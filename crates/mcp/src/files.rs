//! The files that agents may use.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::refused::Refused;

/// The folder of the files that agents may use; nothing outside of it is accessible.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilesFolder(PathBuf);

/// The error returned when a folder cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("the folder {} cannot be used", .0.display())]
pub struct FilesFolderError(PathBuf, #[source] io::Error);

impl FilesFolder {
    /// Returns an existing folder.
    ///
    /// # Errors
    ///
    /// [`FilesFolderError`] if it is not a folder, or cannot be read.
    pub fn new(folder: &Path) -> Result<Self, FilesFolderError> {
        let error = |error| FilesFolderError(folder.to_owned(), error);
        fs::read_dir(folder).map_err(error)?;
        fs::canonicalize(folder).map(Self).map_err(error)
    }

    /// Returns the name and the bytes of a file in the folder.
    pub(crate) fn read(&self, name: &str) -> Result<(String, Vec<u8>), Refused> {
        let unread = |why: &dyn std::fmt::Display| {
            Refused::new("file", format!("the file `{name}` cannot be read: {why}"))
        };
        // Symbolic links are resolved before the location is checked.
        let path = fs::canonicalize(self.0.join(name)).map_err(|error| unread(&error))?;
        if !path.starts_with(&self.0) {
            return Err(outside(name));
        }
        // Reading a device may never end, or block.
        if !fs::metadata(&path).is_ok_and(|metadata| metadata.is_file()) {
            return Err(unread(&"it is not a file"));
        }
        let mut bytes = Vec::new();
        let read =
            File::open(&path).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes));
        if read.map_err(|error| unread(&error))? as u64 > MAX_BYTES {
            let most_mb = MAX_BYTES / 1_000_000;
            return Err(unread(&format!("it has more than {most_mb} MB")));
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Ok((name.into_owned(), bytes))
    }
}

fn outside(name: &str) -> Refused {
    Refused::new(
        "file",
        format!("the file `{name}` is outside of the folder for agents"),
    )
    .hinted("use a file in that folder, which was set with `dobot mcp --files FOLDER`")
}

/// The station's limit.
const MAX_BYTES: u64 = 24_000_000;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_folder_are_read_and_no_others() {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("inside");
        fs::create_dir(&inside).unwrap();
        fs::write(folder.path().join("secret.svg"), "secret").unwrap();
        fs::write(inside.join("a.svg"), "a").unwrap();
        let files = FilesFolder::new(&inside).unwrap();
        let read = ("a.svg".to_owned(), b"a".to_vec());
        assert_eq!(files.read("a.svg"), Ok(read.clone()));
        assert_eq!(files.read("./a.svg"), Ok(read));
        for name in [
            "../secret.svg",
            "/etc/passwd",
            "",
            ".",
            "..",
            "b.svg",
            "a\0b",
        ] {
            assert!(files.read(name).is_err(), "{name:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_leads_out_of_the_folder_is_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("inside");
        fs::create_dir(&inside).unwrap();
        fs::write(folder.path().join("secret.svg"), "secret").unwrap();
        std::os::unix::fs::symlink("../secret.svg", inside.join("link.svg")).unwrap();
        let files = FilesFolder::new(&inside).unwrap();
        assert_eq!(files.read("link.svg"), Err(outside("link.svg")));
    }
}
