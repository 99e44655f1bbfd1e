//! A dataset for LeRobot, format v3.0: a folder with frames, episodes and metadata.

use std::fs::{self, File};
use std::io::BufWriter;
use std::ops::RangeInclusive;
use std::path::Path;
use std::time::Duration;

use crate::{Recording, Sample};
use dobot_wire::Status;
use serde_json::{Value, json};

use super::cell::{Cell, Column, Kind, column};
use super::error::ExportError;
use super::features::{FEATURES, Feature, Summaries, values};
use super::frames::{FPS, Frame, Frames};
use super::parquet_table::ParquetTable;
use super::rows::Packets;

/// The contents of a dataset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dataset {
    /// The number of episodes: periods without a silence of more than a second.
    pub episodes: u32,
    /// The number of frames, 25 per second.
    pub frames: u32,
    /// The number of periods left out because they have only one frame.
    pub left_out: u32,
}

/// Exports a period of a recording, in time since the start of its recorder, as a dataset in a new
/// folder; `task` describes what the arm does.
///
/// # Errors
///
/// [`ExportError`] if the folder exists or cannot be written, or the recording has no motion; then
/// no dataset remains.
pub fn export_lerobot(
    recording: &mut Recording,
    stretch: &RangeInclusive<Duration>,
    folder: &Path,
    task: &str,
) -> Result<Dataset, ExportError> {
    if task.trim().is_empty() {
        return Err(ExportError::NoTask);
    }
    fs::create_dir(folder)?;
    let result = write(recording, stretch, folder, task);
    if result.is_err() {
        // The folder is ours: it did not exist before. The original error is the one to report.
        let _ = fs::remove_dir_all(folder);
    }
    result
}

fn write(
    recording: &mut Recording,
    stretch: &RangeInclusive<Duration>,
    folder: &Path,
    task: &str,
) -> Result<Dataset, ExportError> {
    let mut writer = Writer::new(folder, task)?;
    let (mut packets, mut frames) = (Packets::new(), Frames::default());
    for moment in recording {
        if moment.at > *stretch.end() {
            break;
        }
        let (statuses, _) = packets.of(&moment);
        for status in statuses {
            let at = moment.at;
            if at >= *stretch.start() {
                for frame in frames.push(Sample { at, status }) {
                    writer.push(frame)?;
                }
            }
        }
    }
    writer.finish(folder)
}

/// A writer of frames in episodes.
struct Writer<'t> {
    task: &'t str,
    data: ParquetTable<BufWriter<File>>,
    episodes: ParquetTable<BufWriter<File>>,
    dataset: Dataset,
    all: Summaries,
    /// The last frame, whose action is not known yet.
    last: Option<Frame>,
    /// The written frames of this episode, and their summaries.
    of_episode: u32,
    episode: Summaries,
}

impl<'t> Writer<'t> {
    fn new(folder: &Path, task: &'t str) -> Result<Self, ExportError> {
        let columns: Vec<_> = FEATURES.iter().map(Feature::column).collect();
        Ok(Self {
            task,
            data: table(&folder.join(DATA), &columns, &[])?,
            episodes: table(&folder.join(EPISODES), &episode_columns(), &[])?,
            dataset: Dataset::default(),
            all: Summaries::new(),
            last: None,
            of_episode: 0,
            episode: Summaries::new(),
        })
    }

    fn push(&mut self, frame: Frame) -> Result<(), ExportError> {
        if frame.number == 0 {
            self.end_episode()?;
        } else if let Some(last) = self.last {
            self.write(&last, &frame.status)?;
        }
        self.last = Some(frame);
        Ok(())
    }

    fn write(&mut self, frame: &Frame, next: &Status) -> Result<(), ExportError> {
        let values = values(frame, next, self.dataset.episodes, self.dataset.frames);
        self.all.push(&values);
        self.episode.push(&values);
        let cells = FEATURES.iter().zip(&values);
        self.data.push(
            cells
                .map(|(feature, values)| feature.cell(values))
                .collect(),
        )?;
        self.dataset.frames += 1;
        self.of_episode += 1;
        Ok(())
    }

    /// After the last frame the arm stays in place.
    fn end_episode(&mut self) -> Result<(), ExportError> {
        let Some(last) = self.last.take() else {
            return Ok(());
        };
        if last.number == 0 {
            self.dataset.left_out += 1;
            return Ok(());
        }
        self.write(&last, &last.status)?;
        self.data.end_group()?;
        let (to, len) = (self.dataset.frames, self.of_episode);
        let integer = |n: u32| Cell::Integer(n.into());
        let mut cells = vec![
            integer(self.dataset.episodes),
            Cell::Texts(vec![self.task.to_owned()]),
            integer(len),
            integer(to - len),
            integer(to),
        ];
        // The numbers of folder and file of the frames, and of this row.
        cells.extend([0; 4].map(integer));
        let summaries = std::mem::replace(&mut self.episode, Summaries::new());
        cells.extend(summaries.cells());
        self.episodes.push(cells)?;
        self.dataset.episodes += 1;
        self.of_episode = 0;
        Ok(())
    }

    fn finish(mut self, folder: &Path) -> Result<Dataset, ExportError> {
        self.end_episode()?;
        if self.dataset.episodes == 0 {
            return Err(ExportError::NoMotion);
        }
        self.data.finish()?;
        self.episodes.finish()?;
        write_tasks(&folder.join("meta/tasks.parquet"), self.task)?;
        write_json(&folder.join("meta/info.json"), &info(&self.dataset))?;
        write_json(&folder.join("meta/stats.json"), &self.all.to_json())?;
        fs::write(folder.join("README.md"), README)?;
        Ok(self.dataset)
    }
}

/// Creates a table and its folder.
fn table(
    file: &Path,
    columns: &[Column],
    notes: &[(&str, String)],
) -> Result<ParquetTable<BufWriter<File>>, ExportError> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    let file = BufWriter::new(File::create_new(file)?);
    ParquetTable::new(file, columns, notes)
}

fn episode_columns() -> Vec<Column> {
    let mut columns = vec![
        column("episode_index", Kind::Integer),
        column("tasks", Kind::Texts),
    ];
    columns.extend(
        [
            "length",
            "dataset_from_index",
            "dataset_to_index",
            "data/chunk_index",
            "data/file_index",
            "meta/episodes/chunk_index",
            "meta/episodes/file_index",
        ]
        .map(|name| column(name, Kind::Integer)),
    );
    columns.extend(Summaries::columns());
    columns
}

/// The tasks, indexed by their text: the note informs pandas which column is the row index.
fn write_tasks(file: &Path, task: &str) -> Result<(), ExportError> {
    let columns = [
        column("task_index", Kind::Integer),
        column("task", Kind::Text),
    ];
    let pandas = json!({
        "index_columns": ["task"],
        "column_indexes": [],
        "columns": [
            { "name": "task_index", "field_name": "task_index", "pandas_type": "int64", "numpy_type": "int64", "metadata": null },
            { "name": "task", "field_name": "task", "pandas_type": "unicode", "numpy_type": "object", "metadata": null },
        ],
        "pandas_version": "2.0.0",
    });
    let mut table = table(file, &columns, &[("pandas", pandas.to_string())])?;
    table.push(vec![Cell::Integer(0), Cell::Text(Some(task.to_owned()))])?;
    table.finish()
}

fn write_json(file: &Path, value: &Value) -> Result<(), ExportError> {
    let text = serde_json::to_string_pretty(value).map_err(std::io::Error::other)?;
    Ok(fs::write(file, text + "\n")?)
}

fn info(dataset: &Dataset) -> Value {
    let features = FEATURES
        .iter()
        .map(|feature| (feature.name.to_owned(), feature.about()));
    json!({
        "codebase_version": "v3.0",
        "robot_type": "dobot_arm",
        "total_episodes": dataset.episodes,
        "total_frames": dataset.frames,
        "total_tasks": 1,
        "chunks_size": 1000,
        "data_files_size_in_mb": 100,
        "video_files_size_in_mb": 200,
        "fps": FPS,
        "splits": { "train": format!("0:{}", dataset.episodes) },
        "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet",
        "video_path": null,
        "features": Value::Object(features.collect()),
    })
}

const DATA: &str = "data/chunk-000/file-000.parquet";
const EPISODES: &str = "meta/episodes/chunk-000/file-000.parquet";

const README: &str = "\
---
tags:
- LeRobot
configs:
- config_name: default
  data_files: data/*/*.parquet
---
The motion of an original Dobot Arm, by `dobot log --export lerobot`: 25 frames a second, in degrees and millimetres.

`action` is the state of the frame behind it.
";
