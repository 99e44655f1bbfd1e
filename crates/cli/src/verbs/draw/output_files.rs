//! The files that a drawing leaves: whether they can be written is known before it begins.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::Path;

use anyhow::Context;

use crate::failure::Failure;

/// Finds out whether a file can be written, and leaves all as it was.
pub(super) fn check_writable(file: &Path) -> Result<(), Failure> {
    let tried = match fs::metadata(file) {
        // A link to a file that is not there yet makes it.
        Err(_) if file.is_symlink() => Ok(()),
        // Whoever reads a pipe or terminal would take the try for the end.
        Ok(it) if !it.is_file() && !it.is_dir() => Ok(()),
        Ok(_) => OpenOptions::new().append(true).open(file).map(drop),
        Err(_) => try_new(file),
    };
    told(file, tried)
}

pub(super) fn write(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    told(file, fs::write(file, bytes))
}

fn try_new(file: &Path) -> io::Result<()> {
    OpenOptions::new().write(true).create_new(true).open(file)?;
    fs::remove_file(file)
}

fn told(file: &Path, outcome: io::Result<()>) -> Result<(), Failure> {
    outcome.with_context(|| format!("cannot write {}", file.display()))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn asking_whether_a_file_can_be_written_changes_nothing() {
        let folder = tempfile::tempdir().expect("there is room");
        let [old, new] = ["old.svg", "new.svg"].map(|name| folder.path().join(name));
        fs::write(&old, "an older picture").expect("there is room");
        for file in [&old, &new] {
            check_writable(file).expect("both can be written");
        }
        assert_eq!(fs::read(&old).expect("it is there"), b"an older picture");
        assert!(!new.exists());
        check_writable(folder.path()).expect_err("a folder is no file");
        check_writable(&new.join("in-no-folder.svg")).expect_err("there is no such folder");
    }
}
