//! Both tables of a recording as files.

use std::fs::{self, File, OpenOptions};
use std::io::BufWriter;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::Recording;

use super::error::ExportError;
use super::rows::{Written, export_tables};
use super::table::Table;

/// The format of table files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableForm {
    /// Text, for every program.
    Csv,
    #[cfg(feature = "parquet")]
    /// Typed columns, a fifth of the size.
    Parquet,
}

impl TableForm {
    /// The file name extension.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            #[cfg(feature = "parquet")]
            Self::Parquet => "parquet",
        }
    }
}

/// Writes the statuses of a period of a recording to `out`, and its commands to a second file:
/// `run.commands.csv` beside `run.csv`. Returns the numbers of rows and the file of the commands.
///
/// # Errors
///
/// [`ExportError`] if a file cannot be written, or exists and must not be overwritten. Then no file
/// is created.
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
            // This file is ours and empty; the error about the other one is the one to report.
            let _ = fs::remove_file(out);
        }
    })?;
    let [statuses, commands] = tables(form, statuses, commands)?;
    let written = export_tables(recording, stretch, statuses, commands)?;
    Ok((written, beside))
}

fn tables(
    form: TableForm,
    statuses: BufWriter<File>,
    commands: BufWriter<File>,
) -> Result<[Table<BufWriter<File>>; 2], ExportError> {
    Ok(match form {
        #[cfg(feature = "parquet")]
        TableForm::Parquet => [
            Table::statuses_parquet(statuses)?,
            Table::commands_parquet(commands)?,
        ],
        TableForm::Csv => [
            Table::statuses_csv(statuses)?,
            Table::commands_csv(commands)?,
        ],
    })
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
