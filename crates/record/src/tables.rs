//! Recordings as tables: CSV, Parquet and datasets for LeRobot.
//!
//! [`export_tables`] makes two tables of a recording, one of its statuses and one of its commands;
//! `export_lerobot` makes a dataset of its motion. Both read the recording once, and use a few
//! megabytes of memory at most, plus a few kilobytes per episode of a dataset. `docs/recordings.md`
//! describes every column.
//!
//! ```
//! use std::time::Duration;
//!
//! use dobot_record::{About, Limits, Record, Recorder, Recording, recordings};
//! use dobot_record::tables::{Table, export_tables};
//! use dobot_wire::Status;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let folder = tempfile::tempdir()?;
//! let start = "2026-11-21T12:30:00Z".parse()?;
//! let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start)?;
//! let status = Status::AT_ZERO.emit().to_bytes();
//! recorder.record(Duration::from_secs(1), Record::FromArm(status.to_vec()));
//! assert_eq!(recorder.finish().lost, 0);
//!
//! let mut recording = Recording::open(&recordings(folder.path())?[0].path)?;
//! let (mut statuses, mut commands) = (Vec::new(), Vec::new());
//! let all = Duration::ZERO..=Duration::MAX;
//! let written = export_tables(
//!     &mut recording,
//!     &all,
//!     Table::statuses_csv(&mut statuses)?,
//!     Table::commands_csv(&mut commands)?,
//! )?;
//! assert_eq!((written.statuses, written.commands), (1, 0));
//! assert!(String::from_utf8(statuses)?.starts_with("time,at_s,x_mm,y_mm,z_mm"));
//! # Ok(())
//! # }
//! ```

mod cell;
mod columns;
#[cfg(feature = "parquet")]
mod episodes;
mod error;
#[cfg(feature = "parquet")]
mod features;
mod files;
#[cfg(feature = "parquet")]
mod frames;
mod in_memory;
#[cfg(feature = "parquet")]
mod lerobot;
#[cfg(feature = "parquet")]
mod parquet_table;
mod rows;
#[cfg(feature = "parquet")]
mod summary;
mod table;

pub use columns::STATUS_FLOATS;
#[cfg(feature = "parquet")]
pub use episodes::{MarkedEpisode, marked_episodes};
pub use error::ExportError;
pub use files::{TableForm, export_files};
pub use in_memory::{TableColumn, Tables, Values, read_tables};
#[cfg(feature = "parquet")]
pub use lerobot::{Dataset, DatasetPart, export_lerobot};
pub use rows::{Written, export_tables, holds_packets};
pub use table::Table;
