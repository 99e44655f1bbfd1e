//! Output files of a drawing, which are checked before it starts.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use serde::Serialize;

use super::args::Args;
use crate::failure::Failure;

/// Checks that no output file overwrites an input or another output, even under another name.
pub(super) fn check_apart(args: &Args) -> Result<(), Failure> {
    let result = &args.result;
    let outputs = [
        ("--picture", &result.picture),
        ("--timeline", &result.timeline),
        ("--export", &result.export),
    ];
    let mut taken = inputs(args);
    let outputs = outputs.iter();
    for (option, file) in outputs.filter_map(|(option, file)| Some((*option, file.as_ref()?))) {
        let Some(identity) = FileIdentity::of(file) else {
            continue;
        };
        if let Some((what, _)) = taken.iter().find(|other| other.1 == identity) {
            let file = file.display();
            return Err(Failure::usage(anyhow!(
                "{option} would overwrite {file}, which is also {what}; name another file"
            )));
        }
        taken.push((option, identity));
    }
    Ok(())
}

/// Returns the files that the drawing is made from.
fn inputs(args: &Args) -> Vec<(&'static str, FileIdentity)> {
    let drawings = args.files.iter().map(|file| ("the drawing", file));
    let others = [
        ("--materials", &args.materials),
        ("--defaults", &args.defaults),
        ("--calibration", &args.calibration),
        ("--policy", &args.to.policy),
    ];
    let others = others.into_iter();
    drawings
        .chain(others.filter_map(|(what, file)| Some((what, file.as_ref()?))))
        .filter_map(|(what, file)| Some((what, FileIdentity::of(file)?)))
        .collect()
}

/// The identity of a regular file under all of its names.
#[derive(Debug, PartialEq, Eq)]
enum FileIdentity {
    /// The device and the inode.
    #[cfg(unix)]
    Number(u64, u64),
    /// The path of a file that does not exist yet.
    Path(PathBuf),
}

impl FileIdentity {
    fn of(file: &Path) -> Option<Self> {
        match fs::metadata(file) {
            Ok(metadata) if !metadata.is_file() => None,
            #[cfg(unix)]
            Ok(metadata) => {
                use std::os::unix::fs::MetadataExt;
                Some(Self::Number(metadata.dev(), metadata.ino()))
            }
            #[cfg(not(unix))]
            Ok(_) => file.canonicalize().ok().map(Self::Path),
            Err(_) => {
                let folder = match file.parent()? {
                    parent if parent.as_os_str().is_empty() => Path::new("."),
                    parent => parent,
                };
                let folder = folder.canonicalize().ok()?;
                Some(Self::Path(folder.join(file.file_name()?)))
            }
        }
    }
}

/// Checks that a file can be written, without changing it.
pub(super) fn check_writable(file: &Path) -> Result<(), Failure> {
    let tried = match fs::metadata(file) {
        // Writing through a dangling link creates its target.
        Err(_) if file.is_symlink() => Ok(()),
        // A pipe or terminal would take the attempt for its end.
        Ok(metadata) if !metadata.is_file() && !metadata.is_dir() => Ok(()),
        Ok(_) => OpenOptions::new().append(true).open(file).map(drop),
        Err(_) => try_new(file),
    };
    in_context(file, tried)
}

pub(super) fn write(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    in_context(file, fs::write(file, bytes))
}

/// Writes a long document piece by piece.
pub(super) fn write_json(file: &Path, document: &impl Serialize) -> Result<(), Failure> {
    let write = || {
        let mut writer = BufWriter::new(File::create(file)?);
        serde_json::to_writer(&mut writer, document)?;
        writer.flush()
    };
    in_context(file, write())
}

fn try_new(file: &Path) -> io::Result<()> {
    OpenOptions::new().write(true).create_new(true).open(file)?;
    fs::remove_file(file)
}

fn in_context(file: &Path, outcome: io::Result<()>) -> Result<(), Failure> {
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
