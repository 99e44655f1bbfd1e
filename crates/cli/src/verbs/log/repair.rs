//! `dobot log --repair`: completes recordings that were cut off or damaged.

use std::path::{Path, PathBuf};

use anyhow::Context;
use dobot_record::{RepairError, is_being_written, recordings, repair};

use crate::failure::Failure;
use crate::output;

/// Repairs these recordings, or all of the folder that nobody is writing, and prints the result of
/// each. One that cannot be repaired does not keep the others from it.
pub(super) fn run(paths: &[PathBuf], folder: &Path) -> Result<(), Failure> {
    let of_folder = if paths.is_empty() {
        unfinished(folder)?
    } else {
        Vec::new()
    };
    let mut result = Ok(());
    for path in paths.iter().chain(&of_folder) {
        if let Err(failure) = one(path)
            && let Err(earlier) = std::mem::replace(&mut result, Err(failure))
        {
            eprintln!("error: {}", earlier.detail());
        }
    }
    result
}

/// The recordings of a folder that nobody is writing.
fn unfinished(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let files = recordings(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    if files.is_empty() {
        eprintln!("no recordings in {}", folder.display());
    }
    let paths = files.into_iter().map(|file| file.path);
    Ok(paths.filter(|path| !is_being_written(path)).collect())
}

fn one(path: &Path) -> Result<(), Failure> {
    let file = path.display();
    let text = match repair(path) {
        Ok(None) => format!("{file}: complete"),
        Ok(Some(damage)) => format!("{file}: repaired; {damage}"),
        Err(error) => return Err(failure(path, error)),
    };
    Ok(output::line(&text)?)
}

fn failure(path: &Path, error: RepairError) -> Failure {
    let error = match error {
        RepairError::Open(error) => return super::recording_failure(path, error),
        error => error,
    };
    let hint = match error {
        RepairError::BeingWritten => Some("copy what it has now: `dobot log FILE --export mcap`"),
        _ => None,
    };
    let error = anyhow::Error::from(error).context(path.display().to_string());
    match hint {
        Some(hint) => Failure::new(error, hint),
        None => error.into(),
    }
}
