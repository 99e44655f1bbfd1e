//! `dobot log FILE --export`: a recording as tables.

use std::ffi::OsStr;
use std::fs::File;
use std::io::BufWriter;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use clap::ValueEnum;
use dobot_record::Recording;
use dobot_tables::{ExportError, Table, export_lerobot, export_tables, holds_packets};

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
            Form::Csv | Form::Parquet => self.tables(form, &mut recording, stretch, &out),
            Form::Lerobot => self.dataset(&mut recording, stretch, &out),
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
        form: Form,
        recording: &mut Recording,
        stretch: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let beside = out.with_extension(format!("commands.{}", form.ending()));
        let file = |path: &Path| -> Result<BufWriter<File>, Failure> {
            Ok(BufWriter::new(output::new_file(path, self.force)?))
        };
        let statuses = file(out)?;
        let commands = file(&beside).inspect_err(|_| {
            if !self.force {
                // It is ours, and empty; why the other one cannot be begun is what a person wants to know.
                let _ = std::fs::remove_file(out);
            }
        })?;
        let (statuses, commands) = match form {
            Form::Parquet => (
                Table::statuses_parquet(statuses)?,
                Table::commands_parquet(commands)?,
            ),
            Form::Csv | Form::Lerobot => (
                Table::statuses_csv(statuses)?,
                Table::commands_csv(commands)?,
            ),
        };
        let written = export_tables(recording, stretch, statuses, commands)
            .with_context(|| out.display().to_string())?;
        Ok(format!(
            "{}: {} statuses\n{}: {} commands",
            out.display(),
            written.statuses,
            beside.display(),
            written.commands
        ))
    }

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

fn no_dataset(out: &Path, error: ExportError) -> Failure {
    let exists =
        matches!(&error, ExportError::Io(it) if it.kind() == std::io::ErrorKind::AlreadyExists);
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
            Self::Csv => "csv",
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
const TASK: &str = "Move the arm as in the recording.";
