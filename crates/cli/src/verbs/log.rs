//! `dobot log`: lists and shows recordings.

mod export;
mod repair;

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, anyhow};
use dobot_record::{
    Entry, FROM_ARM, Moment, OpenError, Recording, TO_ARM, is_being_written, recordings,
};
use dobot_session::plausible;
use dobot_wire::{Commands, Decoder, Dialect, Status, Statuses};
use serde_json::json;

use self::export::Export;
use crate::failure::Failure;
use crate::output;
use crate::reach::folders;
use crate::values;
use crate::verbs::decode::{self, Content, Place};

/// List recordings, or show the contents of one
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot log                               list the recordings, oldest first
  dobot log dobot-2026-11-21T12-30-00Z.mcap
                                          packets in both directions, jobs, events
  dobot log FILE --since 12 --until 15.5  a few seconds of it
  dobot log FILE --topic /arm/joints      joint angles, hidden by default
  dobot log FILE --json                   one object per line
  dobot log FILE --export parquet -o run.parquet
                                          statuses; commands in run.commands.parquet
  dobot log FILE FILE --export lerobot --task 'Draw a square.'
                                          a LeRobot dataset of both
  dobot log FILE --export mcap            a complete copy, also while it is written
  dobot log FILE --export protobuf        the same for Rerun, in protobuf
  dobot log FILE --repair                 complete a recording that was cut off

Times are in seconds from the start of the recording. Foxglove opens the files,
too.")]
pub(crate) struct Args {
    /// Recording: a file, or its name in the folder of recordings; several make one dataset
    files: Vec<PathBuf>,
    #[command(flatten)]
    shelf: Shelf,
    /// Start of the range to show, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = values::number(0.0..=1e9, "seconds"))]
    since: f64,
    /// End of the range to show, in seconds (default: the end of the recording)
    #[arg(long, value_name = "SECONDS", value_parser = values::number(0.0..=1e9, "seconds"))]
    until: Option<f64>,
    /// Topic to show, for example /events; may be repeated
    #[arg(long = "topic", value_name = "TOPIC")]
    topics: Vec<String>,
    /// Protocol dialect: specification or firmware-1.1 (default: as recorded)
    #[arg(long, value_name = "DIALECT", hide_short_help = true)]
    dialect: Option<Dialect>,
    /// Print JSON, one object per line
    #[arg(long)]
    json: bool,
    /// Complete a recording that was cut off or damaged; without a file, all of the folder
    #[arg(long, conflicts_with_all = ["form", "topics", "json", "since", "until"])]
    repair: bool,
    #[command(flatten)]
    export: Export,
}

/// The folder of recordings.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Shelf {
    /// Folder of recordings (default: in the station's data folder)
    #[arg(long, value_name = "FOLDER", hide_short_help = true)]
    recordings: Option<PathBuf>,
    /// Data folder of the station
    #[arg(
        long,
        value_name = "FOLDER",
        conflicts_with = "recordings",
        hide_short_help = true
    )]
    data: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let find = |file: &PathBuf| args.shelf.find(file);
    let paths: Vec<PathBuf> = args.files.iter().map(find).collect::<Result<_, _>>()?;
    if args.repair {
        return repair::run(&paths, &args.shelf.folder()?);
    }
    if args.export.is_asked() {
        return args.export.run(&paths, args.range());
    }
    match &paths[..] {
        [] => list(&args.shelf.folder()?, args.json),
        [path] => {
            // Read first: the recording may be completed in the meantime.
            let is_being_written = is_being_written(path);
            let recording = open(path)?;
            Printer::new(args).print(recording, is_being_written)
        }
        several => Err(too_many(several.len())),
    }
}

fn too_many(found: usize) -> Failure {
    let error = anyhow!("one recording is printed at a time; found {found}");
    let hint = "name one file; several are for `--export lerobot` and `--repair`";
    Failure::usage(error).with_hint(hint)
}

impl Args {
    /// The range of time to show.
    fn range(&self) -> std::ops::RangeInclusive<Duration> {
        let end = self.until.map_or(Duration::MAX, Duration::from_secs_f64);
        Duration::from_secs_f64(self.since)..=end
    }
}

fn list(folder: &Path, as_json: bool) -> Result<(), Failure> {
    let files = recordings(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    if files.is_empty() && !as_json {
        eprintln!("no recordings in {}", folder.display());
    }
    for file in files {
        let path = file.path.display();
        let is_being_written = is_being_written(&file.path);
        if as_json {
            output::json(&json!({
                "file": path.to_string(),
                "begin": file.begin.to_string(),
                "bytes": file.bytes,
                "being_written": is_being_written,
            }))?;
        } else {
            let (begin, size) = (file.begin, size(file.bytes));
            let note = if is_being_written {
                "  being written"
            } else {
                ""
            };
            output::line(&format!("{begin}  {size:>9}  {path}{note}"))?;
        }
    }
    Ok(())
}

impl Shelf {
    fn folder(&self) -> Result<PathBuf, Failure> {
        match &self.recordings {
            Some(folder) => Ok(folder.clone()),
            None => folders(self.data.clone()).map(|folders| folders.recordings()),
        }
    }

    /// Finds a recording by its path, or by its name in the folder.
    pub(crate) fn find(&self, file: &Path) -> Result<PathBuf, Failure> {
        if file.exists() || file.components().count() > 1 {
            return Ok(file.to_owned());
        }
        let folder = self.folder()?;
        let path = folder.join(file);
        if path.exists() {
            return Ok(path);
        }
        Err(Failure::new(
            anyhow!("no file {} here or in {}", file.display(), folder.display()),
            "run `dobot log` to list the recordings",
        ))
    }
}

/// Opens a recording.
pub(crate) fn open(path: &Path) -> Result<Recording, Failure> {
    Recording::open(path).map_err(|error| recording_failure(path, error))
}

/// Converts a failure to open a recording.
pub(crate) fn recording_failure(path: &Path, error: OpenError) -> Failure {
    let is_other = matches!(error, OpenError::NotMcap);
    let error = anyhow::Error::from(error).context(path.display().to_string());
    if is_other {
        Failure::new(error, "use `dobot decode` for plain bytes")
    } else {
        error.into()
    }
}

/// Prints a recording.
struct Printer<'a> {
    args: &'a Args,
    to_arm: Decoder<Commands>,
    from_arm: Decoder<Statuses>,
}

impl<'a> Printer<'a> {
    fn new(args: &'a Args) -> Self {
        Self {
            args,
            to_arm: Decoder::commands(),
            from_arm: Decoder::statuses(plausible),
        }
    }

    fn print(mut self, mut recording: Recording, is_being_written: bool) -> Result<(), Failure> {
        let mut is_first = true;
        while let Some(moment) = recording.next() {
            if std::mem::take(&mut is_first) {
                self.print_head(&recording)?;
            }
            let about = recording.about().and_then(|about| about.dialect);
            self.print_moment(&moment, self.args.dialect.or(about))?;
        }
        match recording.damage() {
            None => Ok(()),
            Some(damage) if damage.breaks_off && is_being_written => {
                if self.args.json {
                    return Ok(output::json(&json!({ "being_written": true }))?);
                }
                let text = "the recording is still being written; this is what it contains now";
                Ok(output::line(text)?)
            }
            Some(damage) if self.args.json => {
                let damage = damage.to_string();
                Ok(output::json(&json!({ "damage": damage }))?)
            }
            Some(damage) => Ok(output::line(&format!("the file is damaged: {damage}"))?),
        }
    }

    fn print_head(&self, recording: &Recording) -> std::io::Result<()> {
        let Some((about, start)) = recording.about().zip(recording.start()) else {
            return Ok(());
        };
        let dialect = about.dialect.map(|dialect| dialect.to_string());
        if self.args.json {
            return output::json(&json!({
                "start": start.to_string(),
                "program": about.program,
                "address": about.address,
                "dialect": dialect,
                "personality": about.personality,
            }));
        }
        let dialect = dialect.unwrap_or_else(|| "unknown".to_owned());
        let arm = match about.address.as_str() {
            "" => "no arm yet".to_owned(),
            address => format!("arm {address}, dialect {dialect}"),
        };
        output::line(&format!(
            "recorded by {} from {start}, {arm}",
            about.program
        ))
    }

    fn print_moment(&mut self, moment: &Moment, dialect: Option<Dialect>) -> std::io::Result<()> {
        // The decoders need all bytes to stay synchronized.
        let contents = match &moment.entry {
            Entry::ToArm(bytes) => self.commands(bytes, dialect),
            Entry::FromArm(bytes) => self.statuses(bytes),
            Entry::Json(_) | Entry::Other(_) => Vec::new(),
        };
        if !self.shows(moment) {
            return Ok(());
        }
        let at_s = moment.at.as_secs_f64();
        let topic: &str = &moment.topic;
        let place = Place {
            text: format!("{at_s:10.3}  {topic}"),
            fields: vec![("at_s", json!(at_s))],
        };
        for content in contents {
            decode::show(&place, &content, self.args.json)?;
        }
        match &moment.entry {
            Entry::Json(value) if self.args.json => {
                place.json(json!({ "topic": topic, "message": value }))
            }
            Entry::Json(value) => place.line(&value.to_string()),
            Entry::Other(bytes) if self.args.json => {
                place.json(json!({ "topic": topic, "bytes": bytes.len() }))
            }
            Entry::Other(bytes) => place.line(&output::count(bytes.len(), "byte")),
            Entry::ToArm(_) | Entry::FromArm(_) => Ok(()),
        }
    }

    fn commands(&mut self, bytes: &[u8], dialect: Option<Dialect>) -> Vec<Content> {
        let before = self.to_arm.counts().skipped_bytes;
        let packets = self.to_arm.feed(bytes);
        let contents = packets.map(|packet| Content::Command(decode::readings(&packet, dialect)));
        let contents = contents.collect();
        with_skipped(self.to_arm.counts().skipped_bytes - before, contents)
    }

    fn statuses(&mut self, bytes: &[u8]) -> Vec<Content> {
        let before = self.from_arm.counts().skipped_bytes;
        let frames = self.from_arm.feed(bytes);
        let contents = frames.filter_map(|frame| Status::parse(&frame).ok().map(Content::Status));
        let contents = contents.collect();
        with_skipped(self.from_arm.counts().skipped_bytes - before, contents)
    }

    /// Whether an entry is shown; by default all except the details of statuses.
    fn shows(&self, moment: &Moment) -> bool {
        let args = self.args;
        let at_s = moment.at.as_secs_f64();
        let topic: &str = &moment.topic;
        let is_chosen = if args.topics.is_empty() {
            topic == TO_ARM || topic == FROM_ARM || !is_detail(topic)
        } else {
            args.topics.iter().any(|chosen| chosen == topic)
        };
        is_chosen && at_s >= args.since && args.until.is_none_or(|until| at_s <= until)
    }
}

/// Puts skipped bytes before the packets that arrived with them.
fn with_skipped(skipped: u64, contents: Vec<Content>) -> Vec<Content> {
    let skipped = (skipped > 0).then_some(Content::Skipped(skipped));
    skipped.into_iter().chain(contents).collect()
}

/// Whether a topic repeats the contents of statuses.
fn is_detail(topic: &str) -> bool {
    topic.starts_with("/arm/") || topic == "/tf"
}

#[expect(clippy::cast_precision_loss, reason = "a size for a person")]
fn size(bytes: u64) -> String {
    let bytes = bytes as f64;
    match bytes {
        ..1e3 => format!("{bytes} B"),
        ..1e6 => format!("{:.1} kB", bytes / 1e3),
        _ => format!("{:.1} MB", bytes / 1e6),
    }
}
