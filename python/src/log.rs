//! Recordings as tables.

use std::io::ErrorKind;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::time::Duration;

#[cfg(feature = "full")]
use dobot_record::tables::{DatasetPart, export_lerobot as export_lerobot_of};
use dobot_record::tables::{ExportError, TableForm, export_files, holds_packets, read_tables};
use dobot_record::{OpenError, Recording};
#[cfg(not(feature = "full"))]
use pyo3::exceptions::PyNotImplementedError;
use pyo3::exceptions::{PyFileExistsError, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::Columns;
use crate::failure::file_error;
#[cfg(feature = "full")]
use crate::failure::value_error;

/// A part of a recording; times are in seconds since its recorder was started.
#[pyclass(frozen)]
pub(crate) struct Log {
    file: PathBuf,
    stretch: RangeInclusive<Duration>,
}

/// Statuses and commands, and the damage of the file.
type Read<'py> = (Bound<'py, PyDict>, Bound<'py, PyDict>, Option<String>);

#[pymethods]
impl Log {
    #[new]
    fn new(file: PathBuf, from_s: f64, to_s: f64) -> PyResult<Self> {
        let begin = Duration::try_from_secs_f64(from_s);
        let end = match to_s {
            f64::INFINITY => Ok(Duration::MAX),
            to_s => Duration::try_from_secs_f64(to_s),
        };
        let (Ok(begin), Ok(end)) = (begin, end) else {
            return Err(PyValueError::new_err(format!(
                "start is {from_s} and end is {to_s}; allowed are 0 or more, in seconds"
            )));
        };
        let log = Self {
            file,
            stretch: begin..=end,
        };
        log.open().map(|_| log)
    }

    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Read<'py>> {
        let (tables, damage) = py.detach(|| {
            let mut recording = self.open()?;
            let tables = read_tables(&mut recording, &self.stretch);
            Ok::<_, PyErr>((tables, recording.damage().map(ToString::to_string)))
        })?;
        let made = |columns: Vec<_>| {
            let mut made = Columns::new(py);
            for column in columns {
                made = made.column(column)?;
            }
            Ok::<_, PyErr>(made.finish())
        };
        Ok((made(tables.statuses)?, made(tables.commands)?, damage))
    }

    /// Writes the statuses to a file and the commands to a second file next to it, whose name is
    /// returned.
    fn export_files(
        &self,
        py: Python<'_>,
        out: PathBuf,
        parquet: bool,
        overwrite: bool,
    ) -> PyResult<PathBuf> {
        let form = if parquet {
            parquet_form()?
        } else {
            TableForm::Csv
        };
        py.detach(|| {
            self.check()?;
            let same = [&self.file, &out].map(|path| path.canonicalize().ok());
            if same[0].is_some() && same[0] == same[1] {
                let out = out.display();
                return Err(PyValueError::new_err(format!(
                    "{out} is the recording itself, which is never overwritten"
                )));
            }
            let written = export_files(&mut self.open()?, &self.stretch, form, &out, overwrite);
            Ok(written.map_err(failed)?.1)
        })
    }
}

#[cfg(not(feature = "full"))]
#[pyfunction]
pub(crate) fn export_lerobot(
    _logs: Vec<PyRef<'_, Log>>,
    _out: PathBuf,
    _task: &str,
    _trim_idle: bool,
) -> PyResult<(u32, u32)> {
    Err(not_built())
}

/// Writes recordings as one LeRobot dataset into a new folder; returns the numbers of episodes and
/// frames.
#[cfg(feature = "full")]
#[pyfunction]
pub(crate) fn export_lerobot(
    py: Python<'_>,
    logs: Vec<PyRef<'_, Log>>,
    out: PathBuf,
    task: &str,
    trim_idle: bool,
) -> PyResult<(u32, u32)> {
    let opened = logs.iter().map(|log| {
        log.check()?;
        Ok(DatasetPart {
            recording: log.open()?,
            period: log.stretch.clone(),
            task: task.to_owned(),
        })
    });
    let mut parts: Vec<_> = opened.collect::<PyResult<_>>()?;
    py.detach(|| {
        let dataset = export_lerobot_of(&mut parts, trim_idle, &out).map_err(failed)?;
        Ok((dataset.episodes, dataset.frames))
    })
}

impl Log {
    fn open(&self) -> PyResult<Recording> {
        Recording::open(&self.file).map_err(|error| match error {
            OpenError::Io(error) => file_error(&error, &self.file),
            other => PyValueError::new_err(format!("{}: {other}", self.file.display())),
        })
    }

    /// Checks that the recording contains data.
    fn check(&self) -> PyResult<()> {
        if holds_packets(&mut self.open()?, &self.stretch) {
            return Ok(());
        }
        let file = self.file.display();
        Err(PyValueError::new_err(format!(
            "{file} contains no packets in this time range; there is nothing to export"
        )))
    }
}

#[cfg(feature = "full")]
#[expect(clippy::unnecessary_wraps, reason = "a build without Parquet fails")]
fn parquet_form() -> PyResult<TableForm> {
    Ok(TableForm::Parquet)
}

#[cfg(not(feature = "full"))]
fn parquet_form() -> PyResult<TableForm> {
    Err(not_built())
}

#[cfg(not(feature = "full"))]
fn not_built() -> PyErr {
    PyNotImplementedError::new_err(
        "this module is built without Parquet and LeRobot; the wheels have them",
    )
}

fn failed(error: ExportError) -> PyErr {
    match error {
        ExportError::File { file, source } if source.kind() == ErrorKind::AlreadyExists => {
            let file = file.display();
            PyFileExistsError::new_err(format!("{file} exists; replace it with overwrite=True"))
        }
        ExportError::File { file, source } => file_error(&source, &file),
        ExportError::Io(source) => source.into(),
        #[cfg(feature = "full")]
        ExportError::NoMotion | ExportError::NoTask => value_error(&error),
        other => PyOSError::new_err(other.to_string()),
    }
}
