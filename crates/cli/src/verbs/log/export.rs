//! `dobot log FILE --export`: a recording as tables.

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

/// What a recording is made into.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Export {
    /// Write it as tables instead: csv or parquet (statuses and commands), or lerobot (a dataset)
    #[arg(long = "export", value_name = "FORM", value_enum, requires = "file", conflicts_with_all = ["json", "topics", "dialect"])]
    form: Option<Form>,
    /// Where to, instead of beside you under the name of the recording: a file, or the folder of a dataset
    #[arg(short, long, value_name = "OUT", requires = "form")]
    out: Option<PathBuf>,
    /// What the arm does, in words, for a dataset
    #[arg(long, value_name = "TEXT", requires = "form")]
    task: Option<String>,
    /// Write over files that are there
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

    /// Writes a stretch of a recording, and says what was written.
    pub(super) fn run(
        &self,
        file: &Path,
        stretch: &RangeInclusive<Duration>,
    ) -> Result<(), Failure> {
        let Some(form) = self.form else {
            return Ok(());
        };
        self.check(form)?;
        // Nothing is written for a recording that tells nothing.
        if !holds_packets(&mut open(file)?, stretch) {
            return Err(Failure::new(
                anyhow!(
                    "{} holds no packet in that stretch; there is nothing to export",
                    file.display()
                ),
                format!("`dobot log {}` prints what it holds", file.display()),
            ));
        }
        let out = self.out.clone().unwrap_or_else(|| form.file(file));
        if is_same(file, &out) {
            return Err(Failure::new(
                anyhow!(
                    "{} is the recording itself; it is never written over",
                    out.display()
                ),
                "`-o` names another file",
            ));
        }
        let mut recording = open(file)?;
        let told = match form {
            Form::Csv => self.tables(TableForm::Csv, &mut recording, stretch, &out),
            #[cfg(feature = "full")]
            Form::Parquet => self.tables(TableForm::Parquet, &mut recording, stretch, &out),
            #[cfg(feature = "full")]
            Form::Lerobot => self.dataset(&mut recording, stretch, &out),
            #[cfg(not(feature = "full"))]
            Form::Parquet | Form::Lerobot => Err(NotBuilt("Parquet and LeRobot").into()),
        }?;
        if let Some(damage) = recording.damage() {
            eprintln!(
                "warning: {}: {damage}; what could be read is exported",
                file.display()
            );
        }
        Ok(output::line(&told)?)
    }

    fn check(&self, form: Form) -> Result<(), Failure> {
        let (option, why) = match form {
            Form::Lerobot if self.force => ("--force", "a folder is never written over"),
            Form::Csv | Form::Parquet if self.task.is_some() => {
                ("--task", "only a dataset has a task")
            }
            _ => return Ok(()),
        };
        Err(anyhow!("{option} is given, but {why}").into())
    }

    fn tables(
        &self,
        form: TableForm,
        recording: &mut Recording,
        stretch: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let (written, beside) = export_files(recording, stretch, form, out, self.force)
            .map_err(|error| no_tables(out, error))?;
        Ok(format!(
            "{}: {} statuses\n{}: {} commands",
            out.display(),
            written.statuses,
            beside.display(),
            written.commands
        ))
    }

    #[cfg(feature = "full")]
    fn dataset(
        &self,
        recording: &mut Recording,
        stretch: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let task = self.task.as_deref().unwrap_or(TASK);
        let dataset = export_lerobot(recording, stretch, out, task)
            .map_err(|error| no_dataset(out, error))?;
        Ok(format!(
            "{}: episodes {}, frames {}, left out since they held a single frame {}",
            out.display(),
            dataset.episodes,
            dataset.frames,
            dataset.left_out
        ))
    }
}

/// Whether both are one file.
fn is_same(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(|it| it.canonicalize().ok());
    one.is_some() && one == other
}

fn no_tables(out: &Path, error: ExportError) -> Failure {
    match &error {
        ExportError::File { source, .. } if source.kind() == ErrorKind::AlreadyExists => {
            Failure::new(error, "`--force` writes over it")
        }
        ExportError::File { .. } => error.into(),
        _ => anyhow::Error::from(error)
            .context(out.display().to_string())
            .into(),
    }
}

#[cfg(feature = "full")]
fn no_dataset(out: &Path, error: ExportError) -> Failure {
    let exists = matches!(&error, ExportError::Io(it) if it.kind() == ErrorKind::AlreadyExists);
    let error = anyhow::Error::from(error).context(out.display().to_string());
    if exists {
        Failure::new(
            error,
            "`-o` names another folder; one that is there is never written over",
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

    /// What is written of a recording where nobody says.
    fn file(self, recording: &Path) -> PathBuf {
        let name = recording.file_name().unwrap_or(OsStr::new("recording"));
        Path::new(name).with_extension(self.ending())
    }
}

/// What the arm does where nobody says.
#[cfg(feature = "full")]
const TASK: &str = "Move the arm as in the recording.";
