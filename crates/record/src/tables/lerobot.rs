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

/// A part of a recording for a dataset.
#[derive(Debug)]
pub struct DatasetPart {
    /// The recording.
    pub recording: Recording,
    /// The period, in time since the start of its recorder.
    pub period: RangeInclusive<Duration>,
    /// What the arm does.
    pub task: String,
}

/// Exports parts of recordings as one dataset in a new folder; each of them begins a new episode.
/// With `trims_idle` the rest before the first motion and after the last one of each episode is
/// left out, but for half a second, and so are episodes without motion.
///
/// # Errors
///
/// [`ExportError`] if the folder exists or cannot be written, a task is empty, or nothing moves;
/// then no dataset remains.
pub fn export_lerobot(
    parts: &mut [DatasetPart],
    trims_idle: bool,
    folder: &Path,
) -> Result<Dataset, ExportError> {
    if parts.iter().any(|part| part.task.trim().is_empty()) {
        return Err(ExportError::NoTask);
    }
    fs::create_dir(folder)?;
    let result = write(parts, trims_idle, folder);
    if result.is_err() {
        // The folder is ours: it did not exist before. The original error is the one to report.
        let _ = fs::remove_dir_all(folder);
    }
    result
}

fn write(
    parts: &mut [DatasetPart],
    trims_idle: bool,
    folder: &Path,
) -> Result<Dataset, ExportError> {
    let mut writer = Writer::new(folder, trims_idle)?;
    for part in parts {
        let (mut packets, mut frames) = (Packets::new(), Frames::default());
        writer.begin(&part.task)?;
        for moment in part.recording.by_ref() {
            let at = moment.at;
            if at > *part.period.end() {
                break;
            }
            let (statuses, _) = packets.of(&moment);
            for status in statuses.into_iter().filter(|_| at >= *part.period.start()) {
                for frame in frames.push(Sample { at, status }) {
                    writer.push(frame)?;
                }
            }
        }
    }
    writer.finish(folder)
}

/// A writer of frames in episodes.
struct Writer {
    trims_idle: bool,
    /// The tasks, in the order of their first episode, and the current one.
    tasks: Vec<String>,
    task: usize,
    data: ParquetTable<BufWriter<File>>,
    episodes: ParquetTable<BufWriter<File>>,
    dataset: Dataset,
    all: Summaries,
    /// The frames of this episode.
    episode: Vec<Status>,
}

impl Writer {
    fn new(folder: &Path, trims_idle: bool) -> Result<Self, ExportError> {
        let columns: Vec<_> = FEATURES.iter().map(Feature::column).collect();
        Ok(Self {
            trims_idle,
            tasks: Vec::new(),
            task: 0,
            data: table(&folder.join(DATA), &columns, &[])?,
            episodes: table(&folder.join(EPISODES), &episode_columns(), &[])?,
            dataset: Dataset::default(),
            all: Summaries::new(),
            episode: Vec::new(),
        })
    }

    /// Begins a part with a task.
    fn begin(&mut self, task: &str) -> Result<(), ExportError> {
        self.end_episode()?;
        let known = self.tasks.iter().position(|known| known == task);
        self.task = known.unwrap_or_else(|| {
            self.tasks.push(task.to_owned());
            self.tasks.len() - 1
        });
        Ok(())
    }

    fn push(&mut self, frame: Frame) -> Result<(), ExportError> {
        if frame.number == 0 {
            self.end_episode()?;
        }
        self.episode.push(frame.status);
        Ok(())
    }

    fn end_episode(&mut self) -> Result<(), ExportError> {
        let all = std::mem::take(&mut self.episode);
        let kept = if self.trims_idle {
            without_rest(&all)
        } else {
            &all[..]
        };
        match kept.len() {
            0 if all.is_empty() => Ok(()),
            0 | 1 => {
                self.dataset.left_out += 1;
                Ok(())
            }
            _ => self.write_episode(kept),
        }
    }

    /// Writes an episode. After the last frame the arm stays in place.
    fn write_episode(&mut self, frames: &[Status]) -> Result<(), ExportError> {
        let mut summaries = Summaries::new();
        let task = u32::try_from(self.task).unwrap_or(u32::MAX);
        let from = self.dataset.frames;
        let nexts = frames.iter().skip(1).chain(frames.last());
        for (number, (status, next)) in (0..).zip(frames.iter().zip(nexts)) {
            let frame = Frame {
                number,
                status: *status,
            };
            let counters = [self.dataset.episodes, self.dataset.frames, task];
            let values = values(&frame, next, counters);
            self.all.push(&values);
            summaries.push(&values);
            let cells = FEATURES.iter().zip(&values);
            let cells = cells.map(|(feature, values)| feature.cell(values));
            self.data.push(cells.collect())?;
            self.dataset.frames += 1;
        }
        self.data.end_group()?;
        let to = self.dataset.frames;
        let integer = |n: u32| Cell::Integer(n.into());
        let mut cells = vec![
            integer(self.dataset.episodes),
            Cell::Texts(vec![self.tasks[self.task].clone()]),
            integer(to - from),
            integer(from),
            integer(to),
        ];
        // The numbers of folder and file of the frames, and of this row.
        cells.extend([0; 4].map(integer));
        cells.extend(summaries.cells());
        self.episodes.push(cells)?;
        self.dataset.episodes += 1;
        Ok(())
    }

    fn finish(mut self, folder: &Path) -> Result<Dataset, ExportError> {
        self.end_episode()?;
        if self.dataset.episodes == 0 {
            return Err(ExportError::NoMotion);
        }
        self.data.finish()?;
        self.episodes.finish()?;
        write_tasks(&folder.join("meta/tasks.parquet"), &self.tasks)?;
        write_json(
            &folder.join("meta/info.json"),
            &info(&self.dataset, self.tasks.len()),
        )?;
        write_json(&folder.join("meta/stats.json"), &self.all.to_json())?;
        fs::write(folder.join("README.md"), README)?;
        Ok(self.dataset)
    }
}

/// The frames without the rest before the first motion and after the last one, but for half a
/// second of each; none if nothing moves.
fn without_rest(frames: &[Status]) -> &[Status] {
    let moves = |pair: &[Status]| !rests(&pair[0], &pair[1]);
    let mut pairs = frames.windows(2);
    let (Some(first), Some(last)) = (pairs.clone().position(moves), pairs.rposition(moves)) else {
        return &[];
    };
    let begin = first.saturating_sub(KEPT_REST);
    let end = (last + 2 + KEPT_REST).min(frames.len());
    &frames[begin..end]
}

/// Whether nothing moves and nothing switches between two statuses.
fn rests(before: &Status, after: &Status) -> bool {
    let angles = |status: &Status| {
        [
            status.base_deg,
            status.rear_deg,
            status.fore_deg,
            status.servo_deg,
            status.gripper_deg,
        ]
    };
    let pairs = angles(before).into_iter().zip(angles(after));
    let mut turns = pairs.map(|(before, after)| (after - before).abs());
    before.suction == after.suction && turns.all(|turn| turn <= REST_DEG)
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
fn write_tasks(file: &Path, tasks: &[String]) -> Result<(), ExportError> {
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
    for (index, task) in (0..).zip(tasks) {
        table.push(vec![Cell::Integer(index), Cell::Text(Some(task.clone()))])?;
    }
    table.finish()
}

fn write_json(file: &Path, value: &Value) -> Result<(), ExportError> {
    let text = serde_json::to_string_pretty(value).map_err(std::io::Error::other)?;
    Ok(fs::write(file, text + "\n")?)
}

fn info(dataset: &Dataset, tasks: usize) -> Value {
    let features = FEATURES
        .iter()
        .map(|feature| (feature.name.to_owned(), feature.about()));
    json!({
        "codebase_version": "v3.0",
        "robot_type": "dobot_arm",
        "total_episodes": dataset.episodes,
        "total_frames": dataset.frames,
        "total_tasks": tasks,
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

/// The number of frames that are kept before the first motion and after the last one.
const KEPT_REST: usize = FPS as usize / 2;
/// A smaller turn between two frames is no motion, in degrees.
const REST_DEG: f32 = 0.005;

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
