//! The recordings of the station: list, download, and states over time.

use std::fs::File;
use std::io::{self, Read, Take};
use std::path::PathBuf;
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_LENGTH, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use dobot_api::Problem;
use dobot_api::problem_kinds::{NO_SUCH_RECORDING, RECORDING};
use dobot_record::{RecordedFile, Recording, Sample, Track, is_being_written, recordings};
use dobot_wire::Status;
use futures_util::Stream;
use futures_util::stream::try_unfold;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tokio::sync::Semaphore;

use crate::http::exchange::responses::beside;

/// The folder of the recordings.
#[derive(Debug)]
pub(crate) struct Recordings {
    folder: PathBuf,
    /// A recording is read completely to extract its states: one at a time.
    turn: Semaphore,
}

/// A recording.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RecordingView {
    /// The name of its file.
    pub(crate) name: String,
    /// Its begin, in milliseconds since 1970-01-01T00:00:00Z.
    begin_ms: i64,
    /// Its size, in bytes.
    bytes: u64,
    /// Whether it is still being written.
    being_written: bool,
}

/// The requested part and resolution of a recording.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Stretch {
    #[serde(default)]
    from_s: f64,
    to_s: Option<f64>,
    #[serde(default = "usual")]
    most: usize,
}

/// The positions of the arm over a part of a recording.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RecordedStates {
    /// The origin of its times, in milliseconds since 1970-01-01T00:00:00Z; absent if nothing could
    /// be read.
    begin_ms: Option<i64>,
    /// The minimum spacing of the samples, in seconds; 0 if all changes are included.
    spacing_s: f64,
    /// The statuses, the oldest first. The arm did not move between two equal ones.
    samples: Vec<SampleView>,
}

/// The status at one moment.
#[derive(Debug, Serialize, JsonSchema)]
struct SampleView {
    /// The time, in seconds since the origin of the recording.
    at_s: f64,
    /// The status.
    #[serde(flatten)]
    status: Status,
}

impl Recordings {
    pub(crate) const fn new(folder: PathBuf) -> Self {
        let turn = Semaphore::const_new(1);
        Self { folder, turn }
    }

    /// Returns all recordings, the oldest first.
    pub(crate) async fn list(&self) -> Result<Vec<RecordingView>, Problem> {
        let folder = self.folder.clone();
        let views = move || {
            let files = recordings(&folder)?;
            Ok(files.iter().filter_map(view).collect())
        };
        let listed = beside(views).await?;
        listed.map_err(|error: io::Error| unreadable(&error))
    }

    /// Returns the file as a response.
    pub(crate) async fn file(&self, name: &str) -> Result<Response, Problem> {
        let found = self.find(name).await?;
        let opened = beside(move || open(&found)).await?;
        let (file, bytes) = opened.map_err(|error| unreadable(&error))?;
        let headers = [
            (CONTENT_TYPE, "application/octet-stream".to_owned()),
            (CONTENT_LENGTH, bytes.to_string()),
            (
                CONTENT_DISPOSITION,
                format!("attachment; filename=\"{name}\""),
            ),
        ];
        Ok((headers, Body::from_stream(pieces(file))).into_response())
    }

    /// Returns the positions of the arm.
    pub(crate) async fn states(
        &self,
        name: &str,
        stretch: Stretch,
    ) -> Result<RecordedStates, Problem> {
        let found = self.find(name).await?;
        // The semaphore is never closed.
        let turn = self.turn.acquire().await;
        let read = beside(move || read(&found, stretch)).await?;
        drop(turn);
        read.map_err(|error| unreadable(&error))
    }

    /// Returns the recording of this name: one of the listed files, and no other.
    async fn find(&self, name: &str) -> Result<RecordedFile, Problem> {
        let (folder, wanted) = (self.folder.clone(), name.to_owned());
        let files = beside(move || recordings(&folder)).await?;
        let mut files = files.map_err(|error| unreadable(&error))?.into_iter();
        let found = files.find(|file| file.path.file_name().is_some_and(|name| name == &*wanted));
        found.ok_or_else(|| {
            NO_SUCH_RECORDING.hinted(
                "no recording has this name",
                "`GET /api/v1/recordings` lists them",
            )
        })
    }
}

impl Stretch {
    /// The maximum number of samples.
    pub(crate) const MAX_SAMPLES: usize = 5_000;

    /// Checks the ranges; returns the problem in one line.
    pub(crate) fn check(&self) -> Result<(), String> {
        let from_s = self.from_s;
        let to_s = self.to_s.unwrap_or(f64::MAX);
        if !(0.0..=to_s).contains(&from_s) {
            return Err(format!("from_s is {from_s}; allowed are 0 to to_s"));
        }
        if !(2..=Self::MAX_SAMPLES).contains(&self.most) {
            let (found, most) = (self.most, Self::MAX_SAMPLES);
            return Err(format!("most is {found}; allowed are 2 to {most}"));
        }
        Ok(())
    }
}

const fn usual() -> usize {
    2_000
}

fn view(file: &RecordedFile) -> Option<RecordingView> {
    Some(RecordingView {
        name: file.path.file_name()?.to_str()?.to_owned(),
        begin_ms: file.begin.as_millisecond(),
        bytes: file.bytes,
        being_written: is_being_written(&file.path),
    })
}

/// Opens the current contents of a file: one that is being written grows.
fn open(found: &RecordedFile) -> io::Result<(Take<File>, u64)> {
    let file = File::open(&found.path)?;
    let bytes = file.metadata()?.len();
    Ok((file.take(bytes), bytes))
}

/// Streams a file piece by piece, without reading it into memory.
fn pieces(file: Take<File>) -> impl Stream<Item = io::Result<Bytes>> {
    try_unfold(file, async |mut file| {
        let read = tokio::task::spawn_blocking(move || {
            let mut piece = Vec::with_capacity(PIECE);
            let read = file.by_ref().take(PIECE as u64).read_to_end(&mut piece);
            read.map(|_| (Bytes::from(piece), file))
        });
        let (piece, file) = read.await.map_err(io::Error::other)??;
        Ok((!piece.is_empty()).then_some((piece, file)))
    })
}

fn read(found: &RecordedFile, stretch: Stretch) -> io::Result<RecordedStates> {
    let mut recording = Recording::open(&found.path).map_err(io::Error::other)?;
    let end_s = stretch.to_s.unwrap_or(f64::MAX);
    let [from, to] = [stretch.from_s, end_s]
        .map(|item| Duration::try_from_secs_f64(item).unwrap_or(Duration::MAX));
    let track = Track::read(&mut recording, &(from..=to), stretch.most);
    let samples = track
        .samples
        .iter()
        .map(|Sample { at, status }| SampleView {
            at_s: at.as_secs_f64(),
            status: *status,
        });
    Ok(RecordedStates {
        begin_ms: recording.start().map(Timestamp::as_millisecond),
        spacing_s: track.spacing.as_secs_f64(),
        samples: samples.collect(),
    })
}

fn unreadable(error: &io::Error) -> Problem {
    RECORDING.problem(error.to_string())
}

/// The size of a piece, in bytes.
const PIECE: usize = 256 << 10;
