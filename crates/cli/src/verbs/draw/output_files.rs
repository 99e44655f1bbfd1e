//! The files that a drawing leaves: whether they can be written is known before it begins.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use serde::Serialize;

use super::args::Args;
use crate::failure::Failure;

/// Refuses to write over what is read, and two files over each other, under whatever names.
pub(super) fn check_apart(args: &Args) -> Result<(), Failure> {
    let Args { result, to, .. } = args;
    let drawings = args.files.iter().map(|it| ("the drawing", it));
    let others = [
        ("--materials", &args.materials),
        ("--defaults", &args.defaults),
        ("--calibration", &args.calibration),
        ("--policy", &to.policy),
    ];
    let others = others
        .into_iter()
        .filter_map(|(what, it)| Some((what, it.as_ref()?)));
    let outputs = [
        ("--picture", &result.picture),
        ("--timeline", &result.timeline),
        ("--export", &result.export),
    ];
    let mut taken: Vec<(&str, FileIdentity)> = drawings
        .chain(others)
        .filter_map(|(what, it)| Some((what, FileIdentity::of(it)?)))
        .collect();
    for (option, file) in outputs {
        let Some((file, identity)) = file
            .as_ref()
            .and_then(|it| Some((it, FileIdentity::of(it)?)))
        else {
            continue;
        };
        if let Some((what, _)) = taken.iter().find(|it| it.1 == identity) {
            let file = file.display();
            return Err(anyhow!(
                "{option} would write over {file}, which is {what}, too: give it a name of its own"
            )
            .into());
        }
        taken.push((option, identity));
    }
    Ok(())
}

/// What two names of one file have in common, where it keeps what is written.
#[derive(Debug, PartialEq, Eq)]
enum FileIdentity {
    /// The device and the number of a file there: a hard link is no other file.
    #[cfg(unix)]
    Number(u64, u64),
    /// One that is not there yet.
    Path(PathBuf),
}

impl FileIdentity {
    fn of(file: &Path) -> Option<Self> {
        match fs::metadata(file) {
            Ok(it) if !it.is_file() => None,
            #[cfg(unix)]
            Ok(it) => {
                use std::os::unix::fs::MetadataExt;
                Some(Self::Number(it.dev(), it.ino()))
            }
            #[cfg(not(unix))]
            Ok(_) => file.canonicalize().ok().map(Self::Path),
            Err(_) => {
                let folder = match file.parent()? {
                    it if it.as_os_str().is_empty() => Path::new("."),
                    it => it,
                };
                let folder = folder.canonicalize().ok()?;
                Some(Self::Path(folder.join(file.file_name()?)))
            }
        }
    }
}

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

/// Writes a long document piece by piece.
pub(super) fn write_json(file: &Path, document: &impl Serialize) -> Result<(), Failure> {
    let write = || {
        let mut writer = BufWriter::new(File::create(file)?);
        serde_json::to_writer(&mut writer, document)?;
        writer.flush()
    };
    told(file, write())
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
