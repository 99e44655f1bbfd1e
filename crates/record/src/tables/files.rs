//! Both tables of a recording as files beside each other.

use std::fs::{self, File, OpenOptions};
use std::io::BufWriter;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::Recording;

use super::error::ExportError;
use super::rows::{Written, export_tables};
use super::table::Table;

/// In which form tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableForm {
    /// Text that every program reads.
    Csv,
    #[cfg(feature = "parquet")]
    /// Columns with types, and a fifth of the size.
    Parquet,
}

impl TableForm {
    /// How the names of its files end.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            #[cfg(feature = "parquet")]
            Self::Parquet => "parquet",
        }
    }
}

/// Writes the statuses of a stretch of a recording to `out`, and its commands beside it: to `run.commands.csv` beside
/// `run.csv`. Gives how many rows were written, and the file of the commands.
///
/// # Errors
///
/// [`ExportError`]: where a file cannot be written, or is there already and is not to be written over. Then none is
/// begun.
pub fn export_files(
    recording: &mut Recording,
    stretch: &RangeInclusive<Duration>,
    form: TableForm,
    out: &Path,
    overwrites: bool,
) -> Result<(Written, PathBuf), ExportError> {
    let beside = out.with_extension(format!("commands.{}", form.ending()));
    let statuses = new_file(out, overwrites)?;
    let commands = new_file(&beside, overwrites).inspect_err(|_| {
        if !overwrites {
            // It is ours, and empty; why the other one cannot be begun is what a person wants to know.
            let _ = fs::remove_file(out);
        }
    })?;
    let (statuses, commands) = match form {
        #[cfg(feature = "parquet")]
        TableForm::Parquet => (
            Table::statuses_parquet(statuses)?,
            Table::commands_parquet(commands)?,
        ),
        TableForm::Csv => (
            Table::statuses_csv(statuses)?,
            Table::commands_csv(commands)?,
        ),
    };
    let written = export_tables(recording, stretch, statuses, commands)?;
    Ok((written, beside))
}

fn new_file(path: &Path, overwrites: bool) -> Result<BufWriter<File>, ExportError> {
    let mut options = OpenOptions::new();
    options
        .write(true)
        .create(overwrites)
        .truncate(overwrites)
        .create_new(!overwrites);
    let file = options.open(path).map_err(|source| ExportError::File {
        file: path.to_owned(),
        source,
    })?;
    Ok(BufWriter::new(file))
}
