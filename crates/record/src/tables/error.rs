//! Why a recording cannot be exported.

use std::io;
use std::path::PathBuf;

/// Why a recording cannot be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A file cannot be written.
    #[error("cannot write it")]
    Io(#[from] io::Error),
    /// A file cannot be begun.
    #[error("cannot write {}", file.display())]
    File {
        /// Which.
        file: PathBuf,
        /// What the system says.
        #[source]
        source: io::Error,
    },
    /// A CSV file cannot be written.
    #[error("cannot write it")]
    Csv(#[from] csv::Error),
    #[cfg(feature = "parquet")]
    /// A Parquet file cannot be written.
    #[error("cannot write it")]
    Parquet(#[from] parquet::errors::ParquetError),
    #[cfg(feature = "parquet")]
    /// The recording holds no motion that a dataset could be made of.
    #[error(
        "it holds no two statuses less than a second apart in that stretch; a dataset needs them"
    )]
    NoMotion,
    #[cfg(feature = "parquet")]
    /// A task without a word.
    #[error("the task is empty; allowed is a text that says what the arm does")]
    NoTask,
}
