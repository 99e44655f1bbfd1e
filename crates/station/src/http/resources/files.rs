//! The files that the station stores: drawings, photos and programs, with their last placement and
//! result.

mod name;
mod store;

use std::io;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use dobot_api::problem_kinds::INVALID;
use dobot_api::{JobPhase, Problem};
use dobot_draw::Options;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub(crate) use self::name::FileKind;
use self::name::check_name;
pub(crate) use self::store::FileJob;
use self::store::{About, Change, MOST_BYTES, Store, Write, unusable};
use crate::http::exchange::responses::beside;
use crate::http::resources::drawings::bad;
use crate::http::resources::sketch::Sketch;

/// The files; all work with the disk is done in threads of its own.
#[derive(Clone, Debug)]
pub(crate) struct StoredFiles {
    folder: PathBuf,
    write: Write,
    most_bytes: u64,
    store: Arc<Mutex<Option<Store>>>,
}

/// The files and their space.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FilesView {
    /// The size of all contents together, in bytes.
    used_bytes: u64,
    /// Its maximum.
    most_bytes: u64,
    /// The maximum number of files.
    most_files: usize,
    /// Why files are missing in the list, a line each.
    damaged: Vec<String>,
    /// The files, the oldest first.
    files: Vec<FileView>,
}

/// A stored file.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct FileView {
    /// Its number.
    pub(crate) file: u64,
    /// Its name.
    pub(crate) name: String,
    /// What it is.
    kind: FileKind,
    /// Its revision, from 1: each change by a person is another one.
    revision: u64,
    /// The size of its content, in bytes.
    bytes: u64,
    /// The SHA-256 digest of its content, in hexadecimal.
    pub(crate) sha256: String,
    /// When it was added, in milliseconds since 1970-01-01T00:00:00Z.
    added_ms: i64,
    /// When a person changed it last.
    changed_ms: i64,
    /// The last placement, pen and other options of its drawing.
    #[serde(skip_serializing_if = "Option::is_none")]
    options: Option<Options>,
    /// The last job made from it.
    #[serde(skip_serializing_if = "Option::is_none")]
    last_job: Option<FileJob>,
    /// Whether it has a picture.
    has_sketch: bool,
    /// Why it cannot be drawn, if that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    problem: Option<String>,
}

/// A file to be stored.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewFile {
    /// Its name, which ends like that of a drawing, a picture or a program.
    #[schemars(length(min = 1, max = 120))]
    name: String,
    /// Its content, in Base64 (RFC 4648).
    content: String,
    /// The options of its drawing.
    #[serde(default)]
    options: Option<Options>,
    /// What to do if a file of this name has other content.
    #[serde(default)]
    existing: Existing,
}

/// What to do if a file of the same name has other content.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Existing {
    /// Refuse the new one.
    #[default]
    Refuse,
    /// Replace its content; its options stay unless new ones are given.
    Replace,
    /// Keep both: the new one gets a number in its name.
    KeepBoth,
}

/// A change of a file; absent parts stay.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChangeFile {
    /// The revision that is changed: a change of another one is refused.
    revision: u64,
    /// The new name.
    #[serde(default)]
    name: Option<String>,
    /// The new content, in Base64 (RFC 4648).
    #[serde(default)]
    content: Option<String>,
    /// The options of its drawing.
    #[serde(default)]
    options: Option<Options>,
}

impl FileView {
    fn of(file: u64, about: &About) -> Self {
        Self {
            file,
            name: about.name.clone(),
            // The name was checked; on a newer version of the station it may have been another kind.
            kind: FileKind::of(&about.name).unwrap_or(FileKind::Drawing),
            revision: about.revision,
            bytes: about.bytes,
            sha256: about.sha256.clone(),
            added_ms: about.added_ms,
            changed_ms: about.changed_ms,
            options: about.options.clone(),
            last_job: about.last_job.clone(),
            has_sketch: about.sketch.is_some(),
            problem: about.problem.clone(),
        }
    }

    /// Whether a picture of it can be made.
    pub(crate) fn is_drawn(&self) -> bool {
        self.kind != FileKind::Program
    }
}

impl StoredFiles {
    /// The files in a folder, which need not exist yet.
    pub(crate) fn new(folder: PathBuf) -> Self {
        Self::with_room(folder, store::write, MOST_BYTES)
    }

    fn with_room(folder: PathBuf, write: Write, most_bytes: u64) -> Self {
        let store = Arc::default();
        Self {
            folder,
            write,
            most_bytes,
            store,
        }
    }

    /// Returns the files whose names contain a text.
    pub(crate) async fn list(&self, search: String) -> Result<FilesView, Problem> {
        self.with(move |store| Ok(store.list(&search))).await
    }

    /// Returns a file.
    pub(crate) async fn view(&self, file: u64) -> Result<FileView, Problem> {
        let view = move |store: &mut Store| Ok(FileView::of(file, store.get(file)?));
        self.with(view).await
    }

    /// Returns the content of a file.
    pub(crate) async fn content(&self, file: u64) -> Result<Vec<u8>, Problem> {
        self.with(move |store| store.content(file)).await
    }

    /// Returns the picture of a file, if it has one.
    pub(crate) async fn sketch(&self, file: u64) -> Result<Option<Sketch>, Problem> {
        self.with(move |store| Ok(store.get(file)?.sketch.clone()))
            .await
    }

    /// Stores a file; returns it, and whether its content is new.
    pub(crate) async fn add(&self, new: NewFile) -> Result<(FileView, bool), Problem> {
        check_name(&new.name)?;
        check_options(new.options.as_ref())?;
        self.with(move |store| {
            let content = decoded(&new.content)?;
            let added = store.add(&new.name, &content, new.options, new.existing);
            let (file, is_new) = added?;
            Ok((FileView::of(file, store.get(file)?), is_new))
        })
        .await
    }

    /// Changes a file; returns it, and whether its content is new.
    pub(crate) async fn change(
        &self,
        file: u64,
        change: ChangeFile,
    ) -> Result<(FileView, bool), Problem> {
        check_options(change.options.as_ref())?;
        self.with(move |store| {
            let content = change.content.as_deref().map(decoded).transpose()?;
            let parts = Change {
                name: change.name,
                content,
                options: change.options,
            };
            let is_new = store.change(file, change.revision, parts)?;
            Ok((FileView::of(file, store.get(file)?), is_new))
        })
        .await
    }

    /// Deletes a file.
    pub(crate) async fn remove(&self, file: u64) -> Result<(), Problem> {
        self.with(move |store| store.remove(file)).await
    }

    /// Saves the picture of a content, or why there is none.
    pub(crate) async fn set_sketch(
        &self,
        file: u64,
        sha256: String,
        sketch: Result<Option<Sketch>, String>,
    ) -> Result<(), Problem> {
        self.with(move |store| store.set_sketch(file, &sha256, sketch))
            .await
    }

    /// Saves that a job was made from a file, with these options.
    pub(crate) async fn set_job(
        &self,
        file: u64,
        job: u64,
        options: Option<Options>,
    ) -> Result<(), Problem> {
        let made = FileJob {
            job,
            queued_ms: Timestamp::now().as_millisecond(),
            phase: JobPhase::Queued,
            took_s: None,
        };
        self.with(move |store| store.set_job(file, made, options))
            .await
    }

    /// Saves the result of a job, if it was made from a file.
    pub(crate) async fn finish_job(
        &self,
        job: u64,
        phase: JobPhase,
        took_s: Option<f64>,
    ) -> Result<(), Problem> {
        self.with(move |store| store.finish_job(job, phase, took_s))
            .await
    }

    /// Runs work with the store in a thread of its own; the first one reads what is there.
    async fn with<T: Send + 'static>(
        &self,
        work: impl FnOnce(&mut Store) -> Result<T, Problem> + Send + 'static,
    ) -> Result<T, Problem> {
        let this = self.clone();
        let done = beside(move || {
            let mut store = this.store.lock().unwrap_or_else(PoisonError::into_inner);
            if store.is_none() {
                let opened = Store::open(this.folder.clone(), this.write, this.most_bytes);
                let read = |error: io::Error| unusable("read", &this.folder, &error);
                *store = Some(opened.map_err(read)?);
            }
            work(store.as_mut().expect("it is open"))
        });
        done.await?
    }
}

fn check_options(options: Option<&Options>) -> Result<(), Problem> {
    let checked = options.map_or(Ok(()), Options::check_values);
    checked.map_err(|why| bad(&why))
}

fn decoded(content: &str) -> Result<Vec<u8>, Problem> {
    let bytes = data_encoding::BASE64.decode(content.as_bytes());
    bytes.map_err(|why| INVALID.problem(format!("`content` in Base64: {why}")))
}

#[cfg(test)]
mod tests;
