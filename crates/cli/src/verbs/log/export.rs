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
#[cfg(feature = "full")]
use dobot_record::copy_as_protobuf;
#[cfg(feature = "full")]
use dobot_record::tables::{DatasetPart, MarkedEpisode, export_lerobot, marked_episodes};
use dobot_record::tables::{ExportError, TableForm, export_files, holds_packets};
use dobot_record::{Damage, Recording, RepairError, copy, is_being_written};

use super::open;
use crate::failure::Failure;
use crate::output;

/// Options of an export.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Export")]
pub(super) struct Export {
    /// Export instead: csv or parquet (tables of statuses and commands), lerobot (a dataset), mcap (a complete copy), or protobuf (a complete copy for Rerun)
    #[arg(long = "export", value_name = "FORM", value_enum, requires = "files", conflicts_with_all = ["json", "topics", "dialect"])]
    form: Option<Form>,
    /// Output file, or the folder of a dataset (default: named after the recording, in the current folder)
    #[arg(short, long, value_name = "OUT", requires = "form")]
    out: Option<PathBuf>,
    /// Task description of a dataset
    #[arg(long, value_name = "TEXT", requires = "form", hide_short_help = true)]
    task: Option<String>,
    /// Episode of a dataset, in seconds, as in 12..15.5; may be repeated (default: everything, parted by silences)
    #[arg(long = "episode", value_name = "FROM..TO", requires = "form", value_parser = period, conflicts_with_all = ["since", "until"], hide_short_help = true)]
    episodes: Vec<RangeInclusive<Duration>>,
    /// Leave out the rest before the first motion and after the last one of each episode
    #[arg(long, requires = "form", hide_short_help = true)]
    trim_idle: bool,
    /// Overwrite existing files
    #[arg(long, requires = "form")]
    force: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    Csv,
    Parquet,
    Lerobot,
    Mcap,
    Protobuf,
}

impl Export {
    pub(super) const fn is_asked(&self) -> bool {
        self.form.is_some()
    }

    /// Exports a range of recordings, and prints what was written.
    pub(super) fn run(
        &self,
        files: &[PathBuf],
        range: RangeInclusive<Duration>,
    ) -> Result<(), Failure> {
        let Some((form, file)) = self.form.zip(files.first()) else {
            return Ok(());
        };
        self.check(form, files.len(), &range)?;
        let out = self.out.clone().unwrap_or_else(|| form.file(file));
        if files.iter().any(|file| is_same(file, &out)) {
            return Err(Failure::new(
                anyhow!(
                    "{} is the recording itself, which is never overwritten",
                    out.display()
                ),
                "name another file with `-o`",
            ));
        }
        let summary = match form {
            Form::Csv => self.tables(TableForm::Csv, file, &range, &out),
            #[cfg(feature = "full")]
            Form::Parquet => self.tables(TableForm::Parquet, file, &range, &out),
            #[cfg(feature = "full")]
            Form::Lerobot => self.dataset(files, &range, &out),
            #[cfg(feature = "full")]
            Form::Protobuf => copied(file, &out, copy_as_protobuf),
            #[cfg(not(feature = "full"))]
            Form::Parquet | Form::Lerobot | Form::Protobuf => {
                Err(NotBuilt("Parquet, LeRobot and protobuf").into())
            }
            Form::Mcap => copied(file, &out, copy),
        }?;
        Ok(output::line(&summary)?)
    }

    fn check(
        &self,
        form: Form,
        files: usize,
        range: &RangeInclusive<Duration>,
    ) -> Result<(), Failure> {
        let only = "only a dataset (`--export lerobot`) has it";
        let (option, why) = match form {
            Form::Lerobot if self.force => ("--force", "an existing folder is never overwritten"),
            Form::Lerobot if files > 1 && !self.episodes.is_empty() => {
                ("--episode", "it names periods of one recording")
            }
            Form::Lerobot => return Ok(()),
            _ if files > 1 => {
                let error = anyhow!("found {files} recordings; one is exported at a time");
                let hint = "several make one dataset: `--export lerobot`";
                return Err(Failure::usage(error).with_hint(hint));
            }
            _ if self.task.is_some() => ("--task", only),
            _ if !self.episodes.is_empty() => ("--episode", only),
            _ if self.trim_idle => ("--trim-idle", only),
            Form::Mcap | Form::Protobuf if !is_whole(range) => {
                ("--since or --until", "a copy is complete")
            }
            Form::Mcap | Form::Protobuf if self.force => {
                ("--force", "an existing recording is never overwritten")
            }
            _ => return Ok(()),
        };
        Err(Failure::usage(anyhow!("{option} does not apply: {why}"))
            .with_hint(format!("leave out `{option}`")))
    }

    fn tables(
        &self,
        form: TableForm,
        file: &Path,
        range: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        check_packets(file, range)?;
        let mut recording = open(file)?;
        let (written, beside) = export_files(&mut recording, range, form, out, self.force)
            .map_err(|error| tables_failure(out, error))?;
        warn_of_damage(file, &recording);
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
        files: &[PathBuf],
        range: &RangeInclusive<Duration>,
        out: &Path,
    ) -> Result<String, Failure> {
        let mut parts = self.parts(files, range)?;
        let dataset = export_lerobot(&mut parts, self.trim_idle, out)
            .map_err(|error| dataset_failure(out, error))?;
        Ok(format!(
            "{}: episodes {}, frames {}, episodes omitted because they have a single frame or no motion {}",
            out.display(),
            dataset.episodes,
            dataset.frames,
            dataset.left_out
        ))
    }

    /// The episodes of the recordings.
    #[cfg(feature = "full")]
    fn parts(
        &self,
        files: &[PathBuf],
        range: &RangeInclusive<Duration>,
    ) -> Result<Vec<DatasetPart>, Failure> {
        let mut parts = Vec::new();
        for file in files {
            for MarkedEpisode { period, task } in self.episodes_of(file, range)? {
                check_packets(file, &period)?;
                let task = task.or_else(|| self.task.clone());
                parts.push(DatasetPart {
                    recording: open(file)?,
                    period,
                    task: task.unwrap_or_else(|| TASK.to_owned()),
                });
            }
        }
        Ok(parts)
    }

    /// The episodes of a recording: those asked for, else those that were marked, else all of the range.
    #[cfg(feature = "full")]
    fn episodes_of(
        &self,
        file: &Path,
        range: &RangeInclusive<Duration>,
    ) -> Result<Vec<MarkedEpisode>, Failure> {
        let mut recording = open(file)?;
        let marked = marked_episodes(&mut recording);
        warn_of_damage(file, &recording);
        if self.episodes.is_empty() && is_whole(range) && !marked.is_empty() {
            return Ok(marked);
        }
        let periods = match &self.episodes[..] {
            [] => std::slice::from_ref(range),
            periods => periods,
        };
        let episode = |period: &RangeInclusive<Duration>| MarkedEpisode {
            period: period.clone(),
            task: None,
        };
        Ok(periods.iter().map(episode).collect())
    }
}

fn is_whole(range: &RangeInclusive<Duration>) -> bool {
    *range == (Duration::ZERO..=Duration::MAX)
}

/// Copies a recording to a complete one.
fn copied(
    file: &Path,
    out: &Path,
    copy: fn(&Path, &Path) -> Result<Option<Damage>, RepairError>,
) -> Result<String, Failure> {
    let is_being_written = is_being_written(file);
    let damage = copy(file, out).map_err(|error| {
        let error = anyhow::Error::from(error).context(out.display().to_string());
        if out.exists() {
            let hint = "name another file with `-o`; an existing one is never overwritten";
            return Failure::new(error, hint);
        }
        error.into()
    })?;
    if let Some(damage) = damage
        && !(damage.breaks_off && is_being_written)
    {
        warn(file, &damage);
    }
    Ok(format!("{}: a complete copy", out.display()))
}

fn warn_of_damage(file: &Path, recording: &Recording) {
    if let Some(damage) = recording.damage() {
        warn(file, damage);
    }
}

fn warn(file: &Path, damage: &Damage) {
    let file = file.display();
    eprintln!("warning: {file}: {damage}; the readable part is exported");
}

/// Checks that there is something to write.
fn check_packets(file: &Path, range: &RangeInclusive<Duration>) -> Result<(), Failure> {
    if holds_packets(&mut open(file)?, range) {
        return Ok(());
    }
    let file = file.display();
    Err(Failure::new(
        anyhow!("{file} contains no packet in that range; there is nothing to export"),
        format!("run `dobot log {file}` to see its contents"),
    ))
}

/// Parses a period in seconds: `12..15.5`.
fn period(text: &str) -> Result<RangeInclusive<Duration>, String> {
    let seconds = |text: &str| {
        text.parse()
            .ok()
            .and_then(|s| Duration::try_from_secs_f64(s).ok())
    };
    let ends = text
        .split_once("..")
        .map(|(from, to)| (seconds(from), seconds(to)));
    match ends {
        Some((Some(from), Some(to))) if from < to => Ok(from..=to),
        _ => Err("expected two times in seconds, the earlier one first, as in 12..15.5".to_owned()),
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
            Self::Mcap => "copy.mcap",
            Self::Protobuf => "protobuf.mcap",
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
