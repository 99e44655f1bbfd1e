//! `dobot log`: what was recorded.

mod export;

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
use crate::verbs::decode::{self, Content, Place};

/// List the recordings, or say what one holds
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot log                              the recordings, oldest first
  dobot log dobot-2026-11-21T12-30-00Z.mcap
                                         packets both ways, jobs and events
  dobot log FILE --from 12 --to 15.5     a few seconds of it
  dobot log FILE --topic /arm/joints     the joint angles, which are not shown otherwise
  dobot log FILE --json                  one object a line
  dobot log FILE --export parquet -o run.parquet
                                         statuses as a table, commands in run.commands.parquet
  dobot log FILE --export lerobot --task 'Draw a square.'
                                         a dataset that LeRobot loads

Times are seconds since the recorder was started. The files open in Foxglove too.")]
pub(crate) struct Args {
    /// A recording: a file, or its name in the folder
    file: Option<PathBuf>,
    #[command(flatten)]
    shelf: Shelf,
    /// Leave out what happened before, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = seconds)]
    from: f64,
    /// Leave out what happened after, in seconds
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    to: Option<f64>,
    /// Show this topic, as in /events; may be given several times
    #[arg(long = "topic", value_name = "TOPIC")]
    topics: Vec<String>,
    /// In which dialect: specification or firmware-1.1, instead of the one that was recorded
    #[arg(long, value_name = "DIALECT")]
    dialect: Option<Dialect>,
    /// Print JSON, one object a line
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    export: Export,
}

/// Where recordings are.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Shelf {
    /// Where recordings are looked for, instead of in the station's folder
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
    /// Where the station keeps its data
    #[arg(long, value_name = "FOLDER", conflicts_with = "folder")]
    data: Option<PathBuf>,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    match &args.file {
        None => list(&args.shelf.folder()?, args.json),
        Some(file) => {
            let path = args.shelf.find(file)?;
            if args.export.is_asked() {
                return args.export.run(&path, &args.stretch());
            }
            // It may be ended meanwhile: then there is more than was looked for.
            let is_being_written = is_being_written(&path);
            let recording = open(&path)?;
            Printer::new(args).print(recording, is_being_written)
        }
    }
}

impl Args {
    fn stretch(&self) -> std::ops::RangeInclusive<Duration> {
        let end = self.to.map_or(Duration::MAX, Duration::from_secs_f64);
        Duration::from_secs_f64(self.from)..=end
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
        match &self.folder {
            Some(folder) => Ok(folder.clone()),
            None => folders(self.data.clone()).map(|it| it.recordings()),
        }
    }

    /// The file of that name, here or in the folder.
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
            anyhow!(
                "there is no file {}, neither here nor in {}",
                file.display(),
                folder.display()
            ),
            "`dobot log` lists the recordings",
        ))
    }
}

/// Opens a recording.
pub(crate) fn open(path: &Path) -> Result<Recording, Failure> {
    Recording::open(path).map_err(|error| no_recording(path, error))
}

/// A failure to open a recording.
pub(crate) fn no_recording(path: &Path, error: OpenError) -> Failure {
    let is_other = matches!(error, OpenError::NotMcap);
    let error = anyhow::Error::from(error).context(path.display().to_string());
    if is_other {
        Failure::new(error, "`dobot decode` reads plain bytes")
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
            let about = recording.about().and_then(|it| it.dialect);
            self.print_moment(&moment, self.args.dialect.or(about))?;
        }
        match recording.damage() {
            None => Ok(()),
            Some(damage) if damage.breaks_off && is_being_written => {
                if self.args.json {
                    return Ok(output::json(&json!({ "being_written": true }))?);
                }
                let text = "it is still being written; this is what it holds by now";
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
        let dialect = about.dialect.map(|it| it.to_string());
        if self.args.json {
            return output::json(&json!({
                "start": start.to_string(),
                "program": about.program,
                "address": about.address,
                "dialect": dialect,
                "personality": about.personality,
            }));
        }
        let dialect = dialect.unwrap_or_else(|| "undecided".to_owned());
        let arm = match about.address.as_str() {
            "" => "no arm yet".to_owned(),
            address => format!("arm {address}, dialect {dialect}"),
        };
        output::line(&format!(
            "recorded by {} from {start} on, {arm}",
            about.program
        ))
    }

    fn print_moment(&mut self, moment: &Moment, dialect: Option<Dialect>) -> std::io::Result<()> {
        // The decoders see all bytes, so that they keep their place.
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
            Entry::Other(bytes) => place.line(&format!("{} bytes", bytes.len())),
            Entry::ToArm(_) | Entry::FromArm(_) => Ok(()),
        }
    }

    fn commands(&mut self, bytes: &[u8], dialect: Option<Dialect>) -> Vec<Content> {
        let before = self.to_arm.counts().skipped_bytes;
        let packets = self.to_arm.feed(bytes);
        let contents = packets.map(|it| Content::Command(decode::readings(&it, dialect)));
        let contents = contents.collect();
        with_skipped(self.to_arm.counts().skipped_bytes - before, contents)
    }

    fn statuses(&mut self, bytes: &[u8]) -> Vec<Content> {
        let before = self.from_arm.counts().skipped_bytes;
        let frames = self.from_arm.feed(bytes);
        let contents = frames.filter_map(|it| Status::parse(&it).ok().map(Content::Status));
        let contents = contents.collect();
        with_skipped(self.from_arm.counts().skipped_bytes - before, contents)
    }

    /// Without a choice everything but what is told by the statuses already.
    fn shows(&self, moment: &Moment) -> bool {
        let args = self.args;
        let at_s = moment.at.as_secs_f64();
        let topic: &str = &moment.topic;
        let is_chosen = if args.topics.is_empty() {
            topic == TO_ARM || topic == FROM_ARM || !is_detail(topic)
        } else {
            args.topics.iter().any(|it| it == topic)
        };
        is_chosen && at_s >= args.from && args.to.is_none_or(|to| at_s <= to)
    }
}

/// Bytes that belong to no packet were before the packets that came with them.
fn with_skipped(skipped: u64, contents: Vec<Content>) -> Vec<Content> {
    let skipped = (skipped > 0).then_some(Content::Skipped(skipped));
    skipped.into_iter().chain(contents).collect()
}

/// Views of each status.
fn is_detail(topic: &str) -> bool {
    topic.starts_with("/arm/") || topic == "/tf"
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|it| (0.0..=1e9).contains(it));
    seconds.ok_or_else(|| "a time is a number of seconds, 0 or more".to_owned())
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
