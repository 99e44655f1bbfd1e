//! Files on the disk: a folder for each, with its content and what is known about it.
//!
//! ```text
//! files/7/content-2      the content of the second revision
//! files/7/about.json     name, placement, last job; names the revision of the content
//! ```
//!
//! Each change writes the content first, and then replaces `about.json`: after a crash or on a full
//! disk the file is unchanged.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use dobot_api::problem_kinds::{
    FILE_CHANGED, FILE_EXISTS, FILES_FULL, FILES_UNUSABLE, NO_SUCH_FILE,
};
use dobot_api::{JobPhase, Problem, write_private};
use dobot_draw::Options;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::name::check_name;
use super::{Existing, FileView, FilesView};
use crate::http::resources::sketch::Sketch;

/// All files, as far as they have been read.
#[derive(Debug)]
pub(super) struct Store {
    folder: PathBuf,
    files: BTreeMap<u64, About>,
    /// The highest number ever seen, also of a damaged file.
    last: u64,
    /// Why files cannot be read, a line each.
    damaged: Vec<String>,
    write: Write,
    /// The room for all contents together, in bytes.
    most_bytes: u64,
}

/// Writes a file atomically.
pub(super) type Write = fn(&Path, &[u8]) -> io::Result<()>;

/// What is known about a file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct About {
    pub(super) name: String,
    /// Counts the changes by people, from 1.
    pub(super) revision: u64,
    /// The revision whose content is the current one.
    content: u64,
    pub(super) bytes: u64,
    pub(super) sha256: String,
    pub(super) added_ms: i64,
    pub(super) changed_ms: i64,
    #[serde(default)]
    pub(super) options: Option<Options>,
    #[serde(default)]
    pub(super) last_job: Option<FileJob>,
    #[serde(default)]
    pub(super) sketch: Option<Sketch>,
    /// Why it cannot be drawn.
    #[serde(default)]
    pub(super) problem: Option<String>,
}

/// The last job made from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct FileJob {
    /// Its number.
    pub(crate) job: u64,
    /// When it was queued, in milliseconds since 1970-01-01T00:00:00Z.
    pub(crate) queued_ms: i64,
    /// Its last known phase.
    pub(crate) phase: JobPhase,
    /// Its actual duration, in seconds, once it is done.
    pub(crate) took_s: Option<f64>,
}

/// A change of a file; absent parts stay.
#[derive(Debug, Default)]
pub(super) struct Change {
    pub(super) name: Option<String>,
    pub(super) content: Option<Vec<u8>>,
    pub(super) options: Option<Options>,
}

impl Store {
    /// Reads what is in a folder, which need not exist yet.
    pub(super) fn open(folder: PathBuf, write: Write, most_bytes: u64) -> io::Result<Self> {
        let mut store = Self {
            folder,
            files: BTreeMap::new(),
            last: 0,
            damaged: Vec::new(),
            write,
            most_bytes,
        };
        let entries = match std::fs::read_dir(&store.folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(store),
            entries => entries?,
        };
        for entry in entries {
            let name = entry?.file_name();
            let Some(number) = name.to_str().and_then(|name| name.parse().ok()) else {
                continue;
            };
            store.take_in(number);
        }
        Ok(store)
    }

    /// Reads the folder with this number.
    fn take_in(&mut self, number: u64) {
        self.last = self.last.max(number);
        match self.read(number) {
            Ok(Some(about)) => drop(self.files.insert(number, about)),
            // It was being added or deleted when the station ended.
            Ok(None) => drop(std::fs::remove_dir_all(self.place(number))),
            Err(why) => self.damaged.push(format!(
                "{} cannot be read: {why}",
                self.about(number).display()
            )),
        }
    }

    /// Reads what is known about a file, and removes contents that are not in use.
    fn read(&self, number: u64) -> Result<Option<About>, String> {
        let text = match std::fs::read(self.about(number)) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            text => text.map_err(|error| error.to_string())?,
        };
        let about: About = serde_json::from_slice(&text).map_err(|error| error.to_string())?;
        let content = self.content_path(number, &about);
        let found = content.metadata().map_err(|error| error.to_string())?.len();
        if found != about.bytes {
            return Err(format!("it has {found} bytes instead of {}", about.bytes));
        }
        for entry in std::fs::read_dir(self.place(number)).into_iter().flatten() {
            let path = entry.map_err(|error| error.to_string())?.path();
            if path != content && path != self.about(number) {
                // It costs only space.
                let _ = std::fs::remove_file(path);
            }
        }
        Ok(Some(about))
    }

    /// Returns the files whose names contain a text, whatever its case; all for an empty text.
    pub(super) fn list(&self, search: &str) -> FilesView {
        let wanted = search.to_lowercase();
        let matching = self
            .files
            .iter()
            .filter(|(_, about)| about.name.to_lowercase().contains(&wanted));
        FilesView {
            used_bytes: self.used_bytes(),
            most_bytes: self.most_bytes,
            most_files: MOST_FILES,
            damaged: self.damaged.clone(),
            files: matching
                .map(|(&number, about)| FileView::of(number, about))
                .collect(),
        }
    }

    pub(super) fn get(&self, number: u64) -> Result<&About, Problem> {
        self.files.get(&number).ok_or_else(|| none(number))
    }

    pub(super) fn content(&self, number: u64) -> Result<Vec<u8>, Problem> {
        let path = self.content_path(number, self.get(number)?);
        std::fs::read(&path).map_err(|error| unusable("read", &path, &error))
    }

    /// Adds a file; returns its number, and whether its content is new.
    pub(super) fn add(
        &mut self,
        name: &str,
        content: &[u8],
        options: Option<Options>,
        existing: Existing,
    ) -> Result<(u64, bool), Problem> {
        check_name(name)?;
        let same = self.named(name);
        let digest = digest(content);
        match (same, existing) {
            (Some(number), _) if self.files[&number].sha256 == digest => {
                return Ok((number, false));
            }
            (Some(number), Existing::Refuse) => return Err(exists(name, number)),
            (Some(number), Existing::Replace) => {
                let change = Change {
                    content: Some(content.to_vec()),
                    options,
                    name: None,
                };
                self.apply(number, change)?;
                return Ok((number, true));
            }
            _ => {}
        }
        let name = match same {
            Some(_) => self.free_name(name),
            None => name.to_owned(),
        };
        self.check_room(content.len() as u64, None)?;
        let number = self.last + 1;
        let now_ms = Timestamp::now().as_millisecond();
        let about = About {
            name,
            revision: 1,
            content: 1,
            bytes: content.len() as u64,
            sha256: digest,
            added_ms: now_ms,
            changed_ms: now_ms,
            options,
            last_job: None,
            sketch: None,
            problem: None,
        };
        let saved = self
            .save_content(number, &about, content)
            .and_then(|()| self.save(number, about));
        if saved.is_err() {
            // Nothing names it: it is only in the way.
            let _ = std::fs::remove_dir_all(self.place(number));
        }
        saved?;
        self.last = number;
        Ok((number, true))
    }

    /// Changes the file that has this revision; returns whether its content is new.
    pub(super) fn change(
        &mut self,
        number: u64,
        revision: u64,
        change: Change,
    ) -> Result<bool, Problem> {
        let about = self.get(number)?;
        if about.revision != revision {
            return Err(FILE_CHANGED.hinted(
                format!(
                    "{:?} has revision {}, not {revision}: somebody changed it",
                    about.name, about.revision
                ),
                "read it again, then repeat the change",
            ));
        }
        self.apply(number, change)
    }

    fn apply(&mut self, number: u64, change: Change) -> Result<bool, Problem> {
        let old = self.get(number)?.clone();
        let mut about = About {
            revision: old.revision + 1,
            changed_ms: Timestamp::now().as_millisecond(),
            options: change.options.or_else(|| old.options.clone()),
            ..old.clone()
        };
        if let Some(name) = change.name.filter(|name| *name != old.name) {
            self.check_free(&name)?;
            about.name = name;
        }
        let content = change
            .content
            .filter(|content| digest(content) != old.sha256);
        if let Some(content) = &content {
            self.replace_content(number, &mut about, content)?;
        }
        self.save(number, about)?;
        if content.is_some() {
            // It costs only space, until the next start.
            let _ = std::fs::remove_file(self.content_path(number, &old));
        }
        Ok(content.is_some())
    }

    fn check_free(&self, name: &str) -> Result<(), Problem> {
        check_name(name)?;
        let other = self.named(name);
        other.map_or(Ok(()), |other| Err(exists(name, other)))
    }

    fn replace_content(
        &self,
        number: u64,
        about: &mut About,
        content: &[u8],
    ) -> Result<(), Problem> {
        self.check_room(content.len() as u64, Some(number))?;
        about.content = about.revision;
        about.bytes = content.len() as u64;
        about.sha256 = digest(content);
        (about.sketch, about.problem) = (None, None);
        self.save_content(number, about, content)
    }

    /// Saves the picture of a content, or why there is none, unless the content has changed.
    pub(super) fn set_sketch(
        &mut self,
        number: u64,
        sha256: &str,
        sketch: Result<Option<Sketch>, String>,
    ) -> Result<(), Problem> {
        let mut about = self.get(number)?.clone();
        if about.sha256 != sha256 {
            return Ok(());
        }
        match sketch {
            Ok(sketch) => about.sketch = sketch,
            Err(problem) => about.problem = Some(problem),
        }
        self.save(number, about)
    }

    /// Saves a job made from a file, and the options of its drawing. That is no change by a person:
    /// the page that started it may still change the same revision.
    pub(super) fn set_job(
        &mut self,
        number: u64,
        job: FileJob,
        options: Option<Options>,
    ) -> Result<(), Problem> {
        let mut about = self.get(number)?.clone();
        about.options = options.or(about.options);
        about.last_job = Some(job);
        self.save(number, about)
    }

    /// Saves the result of a job, if it is the last one of a file.
    pub(super) fn finish_job(
        &mut self,
        job: u64,
        phase: JobPhase,
        took_s: Option<f64>,
    ) -> Result<(), Problem> {
        let made = |about: &About| about.last_job.as_ref().is_some_and(|last| last.job == job);
        let found = self.files.iter().find(|(_, about)| made(about));
        let Some((number, mut about)) = found.map(|(&number, about)| (number, about.clone()))
        else {
            return Ok(());
        };
        if let Some(last) = &mut about.last_job {
            (last.phase, last.took_s) = (phase, took_s);
        }
        self.save(number, about)
    }

    pub(super) fn remove(&mut self, number: u64) -> Result<(), Problem> {
        self.get(number)?;
        let about = self.about(number);
        // From then on it does not exist; the rest would be removed at the next start.
        std::fs::remove_file(&about).map_err(|error| unusable("delete", &about, &error))?;
        self.files.remove(&number);
        let _ = std::fs::remove_dir_all(self.place(number));
        Ok(())
    }

    fn named(&self, name: &str) -> Option<u64> {
        let mut files = self.files.iter();
        files
            .find(|(_, about)| about.name == name)
            .map(|(&number, _)| number)
    }

    /// Returns a free name, as in `harbour (2).svg`.
    fn free_name(&self, name: &str) -> String {
        let (stem, end) = match name.rsplit_once('.') {
            Some((stem, end)) => (stem, format!(".{end}")),
            None => (name, String::new()),
        };
        let numbered = (2..).map(|n| {
            let end = format!(" ({n}){end}");
            let room = super::name::MOST_LETTERS - end.chars().count();
            stem.chars().take(room).chain(end.chars()).collect()
        });
        let mut free = numbered.filter(|name: &String| self.named(name).is_none());
        free.next().expect("there are fewer files than numbers")
    }

    /// Checks the limits of the space for a new content, which may replace that of a file.
    fn check_room(&self, bytes: u64, instead_of: Option<u64>) -> Result<(), Problem> {
        let old = instead_of.map_or(0, |number| self.files[&number].bytes);
        let left = (self.most_bytes + old).saturating_sub(self.used_bytes());
        if bytes > left {
            return Err(self.full(format!(
                "the file has {}, and {} of {} are left",
                megabytes(bytes),
                megabytes(left),
                megabytes(self.most_bytes)
            )));
        }
        if instead_of.is_none() && self.files.len() >= MOST_FILES {
            return Err(self.full(format!("there are {MOST_FILES} files, the maximum")));
        }
        Ok(())
    }

    /// Returns the problem of a full store, which says what to delete: the largest files.
    fn full(&self, detail: String) -> Problem {
        let mut largest: Vec<&About> = self.files.values().collect();
        largest.sort_by_key(|about| std::cmp::Reverse(about.bytes));
        let largest = largest.iter().take(3);
        let names = largest.map(|about| format!("{:?} ({})", about.name, megabytes(about.bytes)));
        let names: Vec<String> = names.collect();
        FILES_FULL.hinted(
            detail,
            format!(
                "delete files that nobody needs; the largest are {}",
                names.join(", ")
            ),
        )
    }

    fn used_bytes(&self) -> u64 {
        self.files.values().map(|about| about.bytes).sum()
    }

    fn save_content(&self, number: u64, about: &About, content: &[u8]) -> Result<(), Problem> {
        let path = self.content_path(number, about);
        (self.write)(&path, content).map_err(|error| unusable("write", &path, &error))
    }

    /// Replaces what is known about a file, on the disk and then here.
    fn save(&mut self, number: u64, about: About) -> Result<(), Problem> {
        let text = serde_json::to_vec(&about).expect("its numbers are finite");
        let path = self.about(number);
        (self.write)(&path, &text).map_err(|error| unusable("write", &path, &error))?;
        self.files.insert(number, about);
        Ok(())
    }

    fn place(&self, number: u64) -> PathBuf {
        self.folder.join(number.to_string())
    }

    fn about(&self, number: u64) -> PathBuf {
        self.place(number).join("about.json")
    }

    fn content_path(&self, number: u64, about: &About) -> PathBuf {
        self.place(number)
            .join(format!("content-{}", about.content))
    }
}

/// Writes a private file atomically.
pub(super) fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    write_private(path, content)
}

/// Returns the SHA-256 digest in hexadecimal.
fn digest(content: &[u8]) -> String {
    data_encoding::HEXLOWER.encode(&Sha256::digest(content))
}

fn none(number: u64) -> Problem {
    NO_SUCH_FILE.hinted(
        format!("there is no file {number}"),
        "`GET /api/v1/files` lists them",
    )
}

fn exists(name: &str, number: u64) -> Problem {
    FILE_EXISTS.hinted(
        format!("file {number} with other content is named {name:?}"),
        "replace it, keep both, or use another name",
    )
}

pub(super) fn unusable(what: &str, path: &Path, error: &io::Error) -> Problem {
    FILES_UNUSABLE.hinted(
        format!("cannot {what} {}: {error}", path.display()),
        "free disk space, or check the folder's permissions",
    )
}

/// Rounded up, as in `1.3 MB`.
fn megabytes(bytes: u64) -> String {
    let tenths = bytes.div_ceil(100_000);
    format!("{}.{} MB", tenths / 10, tenths % 10)
}

/// The maximum size of all contents together.
pub(super) const MOST_BYTES: u64 = 256_000_000;
/// The maximum number of files.
pub(super) const MOST_FILES: usize = 1000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_rounded_up_to_a_tenth_of_a_megabyte() {
        for (bytes, text) in [
            (0, "0.0 MB"),
            (1, "0.1 MB"),
            (1_950_001, "2.0 MB"),
            (256_000_000, "256.0 MB"),
        ] {
            assert_eq!(megabytes(bytes), text);
        }
    }
}
