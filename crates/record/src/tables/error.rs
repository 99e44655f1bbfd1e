//! The error of exports.

use std::io;
use std::path::PathBuf;

/// The error returned when a recording cannot be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A file cannot be written.
    #[error("cannot write the export")]
    Io(#[from] io::Error),
    /// A file cannot be created.
    #[error("cannot write {}", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// The error of the operating system.
        #[source]
        source: io::Error,
    },
    /// A CSV file cannot be written.
    #[error("cannot write the export")]
    Csv(#[from] csv::Error),
    #[cfg(feature = "parquet")]
    /// A Parquet file cannot be written.
    #[error("cannot write the export")]
    Parquet(#[from] parquet::errors::ParquetError),
    #[cfg(feature = "parquet")]
    /// The recording contains no motion for a dataset.
    #[error(
        "there is no motion in this period: no two statuses less than a second apart, or with --trim-idle none that differ; a dataset needs them"
    )]
    NoMotion,
    #[cfg(feature = "parquet")]
    /// The task is empty.
    #[error("the task is empty; describe what the arm does")]
    NoTask,
}
