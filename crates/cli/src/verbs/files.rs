//! `dobot files`: the drawings, photos and programs that a station stores.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use clap::Subcommand;
use data_encoding::BASE64;
use dobot_api::{ConnectError, StationAddress, delete, fetch, fetch_bytes, post};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// List, store, fetch and delete the files of a station
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot files                           list drawings, photos and programs
  dobot files list harbour              those with this text in their names
  dobot files put harbour.svg           store a file; the page can open it
  dobot files put harbour.svg --replace
  dobot files get harbour.svg           write it to this folder
  dobot files get 4 --out - | less
  dobot files rm harbour.svg 4

The station keeps up to 1000 files of 256 MB together, each with the placement,
pen and result of its last drawing.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    station: Station,
    /// Print JSON
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// List files
    List {
        /// Text that the names contain
        #[arg(default_value = "")]
        search: String,
    },
    /// Write a file to this computer
    Get {
        /// Name or number of the file
        file: String,
        /// File to write, or - for standard output (default: its name)
        #[arg(long, short, value_name = "FILE")]
        out: Option<PathBuf>,
        /// Overwrite an existing file
        #[arg(long)]
        force: bool,
    },
    /// Store a file
    Put {
        /// File to store
        path: PathBuf,
        /// Name at the station (default: that of the file)
        #[arg(long)]
        name: Option<String>,
        /// Replace the content of a file of this name
        #[arg(long, conflicts_with = "keep_both")]
        replace: bool,
        /// Give the new file a number if another one has its name
        #[arg(long)]
        keep_both: bool,
    },
    /// Delete files
    Rm {
        /// Names or numbers of the files
        #[arg(required = true)]
        files: Vec<String>,
    },
}

/// The list of files, as far as it is shown.
#[derive(Debug, Deserialize)]
struct FileList {
    used_bytes: u64,
    most_bytes: u64,
    damaged: Vec<String>,
    files: Vec<StoredFile>,
}

/// A stored file, as far as it is shown.
#[derive(Debug, Deserialize, Serialize)]
struct StoredFile {
    file: u64,
    name: String,
    kind: String,
    bytes: u64,
    changed_ms: i64,
    #[serde(default)]
    last_job: Option<FileJob>,
}

#[derive(Debug, Deserialize, Serialize)]
struct FileJob {
    job: u64,
    phase: String,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let station = args.station.address_of_running().await?;
    let list = Action::List {
        search: String::new(),
    };
    match args.action.unwrap_or(list) {
        Action::List { search } => list_files(&station, &search, args.json).await,
        Action::Get { file, out, force } => get(&station, &file, out, force).await,
        Action::Put {
            path,
            name,
            replace,
            keep_both,
        } => {
            let existing = match (replace, keep_both) {
                (true, _) => "replace",
                (_, true) => "keep_both",
                _ => "refuse",
            };
            put(&station, &path, name, existing, args.json).await
        }
        Action::Rm { files } => remove(&station, &files).await,
    }
}

async fn list_files(station: &StationAddress, search: &str, as_json: bool) -> Result<(), Failure> {
    let path = format!("{FILES}?search={}", in_query(search));
    if as_json {
        return Ok(output::json(&fetch::<Value>(station, &path).await?)?);
    }
    let all: FileList = fetch(station, &path).await?;
    for damaged in &all.damaged {
        eprintln!("{damaged}");
    }
    for file in &all.files {
        output::line(&line(file))?;
    }
    eprintln!("{} of {} used", size(all.used_bytes), size(all.most_bytes));
    Ok(())
}

async fn get(
    station: &StationAddress,
    file: &str,
    out: Option<PathBuf>,
    force: bool,
) -> Result<(), Failure> {
    let file = find(station, file).await?;
    let content = fetch_bytes(station, &format!("{FILES}/{}/content", file.file)).await?;
    // A station may be somebody else's: only the last part of a name names a file here.
    let name = Path::new(&file.name).file_name().map(PathBuf::from);
    let out = out.or(name).unwrap_or_else(|| "file".into());
    if out == Path::new("-") {
        return Ok(output::bytes(&content)?);
    }
    output::file(&out, &content, force)?;
    Ok(output::line(&format!(
        "{} written to {}",
        size(content.len() as u64),
        out.display()
    ))?)
}

async fn put(
    station: &StationAddress,
    path: &Path,
    name: Option<String>,
    existing: &str,
    as_json: bool,
) -> Result<(), Failure> {
    let content = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let own = || Some(path.file_name()?.to_str()?.to_owned());
    let name = name.or_else(own).ok_or_else(|| {
        let error = anyhow!("{} has no name that is a text", path.display());
        Failure::new(error, "give it one with --name")
    })?;
    let new = json!({"name": name, "content": BASE64.encode(&content), "existing": existing});
    let stored: Result<StoredFile, ConnectError> = post(station, FILES, &new).await;
    let stored = stored.map_err(|error| match &error {
        ConnectError::Refused(problem) if problem.name() == "file-exists" => {
            Failure::new(error, "use `--replace`, `--keep-both` or another `--name`")
        }
        _ => error.into(),
    })?;
    if as_json {
        return Ok(output::json(&stored)?);
    }
    Ok(output::line(&line(&stored))?)
}

async fn remove(station: &StationAddress, files: &[String]) -> Result<(), Failure> {
    for file in files {
        let file = find(station, file).await?;
        delete::<()>(station, &format!("{FILES}/{}", file.file)).await?;
        output::line(&format!("{} is deleted", file.name))?;
    }
    Ok(())
}

/// Returns the file of this name, or else of this number.
async fn find(station: &StationAddress, wanted: &str) -> Result<StoredFile, Failure> {
    let all: FileList = fetch(station, FILES).await?;
    let number = wanted.parse().ok();
    let by_name = all.files.iter().position(|file| file.name == wanted);
    let found = by_name.or_else(|| all.files.iter().position(|file| Some(file.file) == number));
    let found = found.and_then(|at| all.files.into_iter().nth(at));
    found.ok_or_else(|| {
        Failure::new(
            anyhow!("the station has no file {wanted:?}"),
            "run `dobot files` to list the files",
        )
    })
}

/// `   4  drawing     12.3 kB  2026-11-30 10:31  harbour.svg (job 7: done)`
fn line(file: &StoredFile) -> String {
    let changed = Timestamp::from_millisecond(file.changed_ms).unwrap_or_default();
    let changed = changed.to_zoned(TimeZone::system()).strftime("%F %H:%M");
    let job = file.last_job.as_ref();
    let job = job.map(|job| format!(" (job {}: {})", job.job, job.phase));
    format!(
        "{:4}  {:8} {:>9}  {changed}  {}{}",
        file.file,
        file.kind,
        size(file.bytes),
        file.name,
        job.unwrap_or_default()
    )
}

/// `12.3 kB` or `4.0 MB`
fn size(bytes: u64) -> String {
    let [kilo, tenths] = [bytes / 1000, bytes % 1000 / 100];
    if kilo < 1000 {
        return format!("{kilo}.{tenths} kB");
    }
    format!("{}.{} MB", kilo / 1000, kilo % 1000 / 100)
}

/// Encodes a text for a query.
fn in_query(text: &str) -> String {
    let mut encoded = String::new();
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() {
            encoded.push(byte.into());
        } else {
            write!(encoded, "%{byte:02X}").expect("a text takes all");
        }
    }
    encoded
}

const FILES: &str = "/api/v1/files";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_may_contain_anything() {
        assert_eq!(in_query("a b&ä"), "a%20b%26%C3%A4");
    }

    #[test]
    fn sizes_have_one_decimal() {
        assert_eq!(size(0), "0.0 kB");
        assert_eq!(size(12_345), "12.3 kB");
        assert_eq!(size(256_000_000), "256.0 MB");
    }
}
