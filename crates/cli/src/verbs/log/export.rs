//! `dobot log FILE --export`: exports a recording as tables.

use std::ffi::OsStr;
use std::io::ErrorKind;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::anyhow;
use clap::ValueEnum;
#[cfg(not(feature = "full"))]
use dobot_api::NotBuilt;
use dobot_record::Recording;
#[cfg(feature = "full")]
use dobot_record::tables::export_lerobot;
use dobot_record::tables::{ExportError, TableForm, export_files, holds_packets};

use super::open;
use crate::failure::Failure;
use crate::output;

/// Options of an export.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Export")]
pub(super) struct Export {
    /// Export tables instead: csv or parquet (statuses and commands), or lerobot (a dataset)
    #[arg(long = "export", value_name = "FORM", value_enum, requires = "file", conflicts_with_all = ["json", "topics", "dialect"])]
    form: Option<Form>,
    /// Output file, or the folder of a dataset (default: named after the recording, in the current folder)
    #[arg(short, long, value_name = "OUT", requires = "form")]
    out: Option<PathBuf>,
    /// Task description of a dataset
    #[arg(long, value_name = "TEXT", requires = "form", hide_short_help = true)]
    task: Option<String>,
    /// Overwrite existing files
    #[arg(long, requires = "form")]
    force: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    Csv,
    Parquet,
    Lerobot,
}

impl Export {
    pub(super) const fn is_asked(&self) -> bool {
        self.form.is_some()
    }

    /// Exports a range of a recording, and prints what was written.
    pub(super) fn run(&self, file: &Path, range: &RangeInclusive<Duration>) -> Result<(), Failure> {
        let Some(form) = self.form else {
            return Ok(());
        };
        self.check(form)?;
        // Without packets there is nothing to write.
        if !holds_packets(&mut open(file)?, range) {
            return Err(Failure::new(
                anyhow!(
                    "{} contains no packet in that range; there is nothing to export",
                    file.display()
                ),
                format!("run `dobot log {}` to see its contents", file.display()),
            ));
        }
        let out = self.out.clone().unwrap_or_else(|| form.file(file));
        if is_same(file, &out) {
            return Err(Failure::new(
                anyhow!(
                    "{} is the recording itself, which is never overwritten",
                    out.display()
                ),
                "name another file with `-o`",
            ));
        }
        let mut recording = open(file)?;
        let summary = match form {
            Form::Csv => self.tables(TableForm::Csv, &mut recording, range, &out),
            #[cfg(feature = "full")]
            Form::Parquet => self.tables(TableForm::Parquet, &mut recording, range, &out),
            #[cfg(feature = "full")]
            Form::Lerobot => self.dataset(&mut recording, range, &out),
            #[cfg(not(feature = "full"))]
            Form::Parquet | Form::Lerobot => Err(NotBuilt("Parquet and LeRobot").into()),
        }?;
        if let Some(damage) = recording.damage() {
            eprintln!(
                "warning: {}: {damage}; the readable part is exported",
                file.display()
            );
        }
        Ok(output::line(&summary)?)
    }

    fn check(&self, form: Form) -> Result<(), Failure> {
        let (option, why) = match form {
            Form::Lerobot if self.force => ("--force", "an existing folder is never overwritten"),
            Form::Csv | Form::Parquet if self.task.is_some() => {
                ("--task", "only a dataset has a task")
            }
            _ => return Ok(()),
        };
        Err(Failure::usage(anyhow!("{option} does not apply: {why}"))
            .with_hint(format!("leave out `{option}`")))
    }

    fn tables(
        &self,
        form: TableForm,
        recording: &mut Recording,
        range: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let (written, beside) = export_files(recording, range, form, out, self.force)
            .map_err(|error| tables_failure(out, error))?;
        Ok(format!(
            "{}: {}\n{}: {}",
            out.display(),
            output::many(written.statuses, "status", "statuses"),
            beside.display(),
            output::count(written.commands, "command")
        ))
    }

    #[cfg(feature = "full")]
    fn dataset(
        &self,
        recording: &mut Recording,
        range: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let task = self.task.as_deref().unwrap_or(TASK);
        let dataset = export_lerobot(recording, range, out, task)
            .map_err(|error| dataset_failure(out, error))?;
        Ok(format!(
            "{}: episodes {}, frames {}, episodes omitted because they have a single frame {}",
            out.display(),
            dataset.episodes,
            dataset.frames,
            dataset.left_out
        ))
    }
}

/// Whether two paths name the same file.
fn is_same(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(|path| path.canonicalize().ok());
    one.is_some() && one == other
}

fn tables_failure(out: &Path, error: ExportError) -> Failure {
    match &error {
        ExportError::File { source, .. } if source.kind() == ErrorKind::AlreadyExists => {
            Failure::new(error, "overwrite it with `--force`")
        }
        ExportError::File { .. } => error.into(),
        _ => anyhow::Error::from(error)
            .context(out.display().to_string())
            .into(),
    }
}

#[cfg(feature = "full")]
fn dataset_failure(out: &Path, error: ExportError) -> Failure {
    let exists =
        matches!(&error, ExportError::Io(source) if source.kind() == ErrorKind::AlreadyExists);
    let error = anyhow::Error::from(error).context(out.display().to_string());
    if exists {
        Failure::new(
            error,
            "name a new folder with `-o`; an existing one is never overwritten",
        )
    } else {
        error.into()
    }
}

impl Form {
    const fn ending(self) -> &'static str {
        match self {
            Self::Csv => TableForm::Csv.ending(),
            Self::Parquet => "parquet",
            Self::Lerobot => "lerobot",
        }
    }

    /// The default output file for a recording.
    fn file(self, recording: &Path) -> PathBuf {
        let name = recording.file_name().unwrap_or(OsStr::new("recording"));
        Path::new(name).with_extension(self.ending())
    }
}

/// The default task description.
#[cfg(feature = "full")]
const TASK: &str = "Move the arm as in the recording.";
