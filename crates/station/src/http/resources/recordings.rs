//! The recordings of the station: listed, handed out, looked through.

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

use crate::http::exchange::answer::beside;

/// The folder with the recordings.
#[derive(Debug)]
pub(crate) struct Recordings {
    folder: PathBuf,
    /// A recording is read whole to be looked through: one at a time.
    turn: Semaphore,
}

/// A recording.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RecordingView {
    /// The name of its file.
    pub(crate) name: String,
    /// When it was begun, in milliseconds since 1970-01-01T00:00:00Z.
    begin_ms: i64,
    /// How long it is, in bytes.
    bytes: u64,
    /// Whether it is still being written.
    being_written: bool,
}

/// Which part of a recording is wanted, and how fine.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Stretch {
    #[serde(default)]
    from_s: f64,
    to_s: Option<f64>,
    #[serde(default = "usual")]
    most: usize,
}

/// Where the arm was over a stretch of a recording.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct RecordedStates {
    /// When its times begin, in milliseconds since 1970-01-01T00:00:00Z; none where it holds nothing that could be read.
    begin_ms: Option<i64>,
    /// So close together the samples stand at the most, in seconds; 0 where all that say something new are there.
    spacing_s: f64,
    /// What the arm told, the oldest first. Between two that are the same it did not move.
    samples: Vec<SampleView>,
}

/// What the arm told at one moment.
#[derive(Debug, Serialize, JsonSchema)]
struct SampleView {
    /// When, in seconds since the times of the recording begin.
    at_s: f64,
    /// What.
    #[serde(flatten)]
    status: Status,
}

impl Recordings {
    pub(crate) const fn new(folder: PathBuf) -> Self {
        let turn = Semaphore::const_new(1);
        Self { folder, turn }
    }

    /// All of them, the oldest first.
    pub(crate) async fn list(&self) -> Result<Vec<RecordingView>, Problem> {
        let folder = self.folder.clone();
        let views = move || {
            let files = recordings(&folder)?;
            Ok(files.iter().filter_map(view).collect())
        };
        let listed = beside(views).await?;
        listed.map_err(|error: io::Error| unreadable(&error))
    }

    /// The file itself, as an answer.
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

    /// Where the arm was.
    pub(crate) async fn states(
        &self,
        name: &str,
        stretch: Stretch,
    ) -> Result<RecordedStates, Problem> {
        let found = self.find(name).await?;
        // It is never closed.
        let turn = self.turn.acquire().await;
        let read = beside(move || read(&found, stretch)).await?;
        drop(turn);
        read.map_err(|error| unreadable(&error))
    }

    /// The recording of that name: one of those that are listed, and no other file.
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
    /// How many samples there may be at the most.
    pub(crate) const MOST: usize = 5_000;

    /// What of it is out of range, in one line.
    pub(crate) fn check(&self) -> Result<(), String> {
        let from_s = self.from_s;
        let to_s = self.to_s.unwrap_or(f64::MAX);
        if !(0.0..=to_s).contains(&from_s) {
            return Err(format!(
                "from_s is {from_s}; allowed is 0 or more, and no more than to_s"
            ));
        }
        if !(2..=Self::MOST).contains(&self.most) {
            let (found, most) = (self.most, Self::MOST);
            return Err(format!("most is {found}; allowed is 2 to {most}"));
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

/// What of a file is there now: one that is being written grows on.
fn open(found: &RecordedFile) -> io::Result<(Take<File>, u64)> {
    let file = File::open(&found.path)?;
    let bytes = file.metadata()?.len();
    Ok((file.take(bytes), bytes))
}

/// A file, piece by piece: no more of it is in memory than travels.
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

/// How much of a file is read at once, in bytes.
const PIECE: usize = 256 << 10;
