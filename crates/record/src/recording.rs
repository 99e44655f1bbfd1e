//! Reads a recording, damaged or not.

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use mcap::MAGIC;
use mcap::records::op;
use serde_json::Value;

use crate::chunk::Chunk;
use crate::fields::Fields;
use crate::topic::{FROM_ARM, NAME_LEN, TO_ARM};
use crate::{About, Damage, Entry, Moment, hex};

/// A recording, read from its beginning: an iterator of what was recorded, in the order in which it
/// was.
///
/// A file that breaks off, as after a power cut, is read up to there; so is one that is damaged. The
/// iterator simply ends, and [`Recording::damage`] tells where and why. It takes a few megabytes of
/// memory at the most, whatever the file says about itself.
pub struct Recording {
    file: BufReader<Box<dyn Read + Send>>,
    about: Option<About>,
    /// Nanoseconds since 1970 when the times begin.
    start_ns: Option<u64>,
    channels: HashMap<u16, Channel>,
    chunk: Option<Chunk>,
    /// How many bytes of the file were good.
    good_bytes: u64,
    last: Option<Duration>,
    over: bool,
    damage: Option<Damage>,
}

/// Why a file cannot be read as a recording.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// It cannot be opened.
    #[error("cannot read it")]
    Io(#[from] io::Error),
    /// It is something else.
    #[error("it is no recording: it does not begin as an MCAP file does")]
    NotMcap,
}

#[derive(Clone, Debug)]
struct Channel {
    topic: Arc<str>,
    is_json: bool,
}

/// A record of the file that is worth a look.
enum Part {
    Record(u8, Vec<u8>),
    /// Nothing of interest here.
    Skipped,
    End,
}

impl Recording {
    /// Opens a file.
    ///
    /// # Errors
    ///
    /// [`OpenError`]; a file that breaks off is no error.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        Self::over(File::open(path)?)
    }

    /// Reads a recording from anywhere.
    ///
    /// # Errors
    ///
    /// [`OpenError`].
    pub fn over(file: impl Read + Send + 'static) -> Result<Self, OpenError> {
        let file: Box<dyn Read + Send> = Box::new(file);
        let mut file = BufReader::new(file);
        let mut magic = Vec::new();
        file.by_ref()
            .take(MAGIC.len() as u64)
            .read_to_end(&mut magic)?;
        if !MAGIC.starts_with(&magic) {
            return Err(OpenError::NotMcap);
        }
        // The power may have been cut before it was begun.
        let is_begun = magic == MAGIC;
        let damage = (!is_begun).then(|| Damage {
            good_bytes: 0,
            last: None,
            reason: "the file ends before it begins".to_owned(),
        });
        Ok(Self {
            file,
            about: None,
            start_ns: None,
            channels: HashMap::new(),
            chunk: None,
            good_bytes: MAGIC.len() as u64,
            last: None,
            over: !is_begun,
            damage,
        })
    }

    /// What the recording is of, as far as it was read: known from its first moment on; `None` in
    /// files of others.
    #[must_use]
    pub const fn about(&self) -> Option<&About> {
        self.about.as_ref()
    }

    /// When its times begin; `None` before its first moment.
    #[must_use]
    pub fn start(&self) -> Option<jiff::Timestamp> {
        jiff::Timestamp::from_nanosecond(self.start_ns?.into()).ok()
    }

    /// Where it breaks off, once it was read to its end; `None` for one that is whole.
    #[must_use]
    pub const fn damage(&self) -> Option<&Damage> {
        self.damage.as_ref()
    }

    /// The next moment, if there is one in what comes next.
    fn step(&mut self) -> Result<Option<Moment>, String> {
        if let Some(chunk) = &mut self.chunk {
            if let Some(record) = chunk.next() {
                let (kind, body) = record?;
                return self.take(kind, &body);
            }
            self.good_bytes += chunk.file_bytes();
            self.chunk = None;
            return Ok(None);
        }
        match self.part()? {
            Part::Record(op::CHUNK, body) => {
                self.chunk = Some(Chunk::new(body)?);
                Ok(None)
            }
            Part::Record(kind, body) => {
                let moment = self.take(kind, &body)?;
                self.good_bytes += HEADER_LEN + body.len() as u64;
                Ok(moment)
            }
            Part::Skipped => Ok(None),
            Part::End => {
                self.over = true;
                Ok(None)
            }
        }
    }

    /// The next record of the file.
    fn part(&mut self) -> Result<Part, String> {
        let header = self.read(HEADER_LEN)?;
        if header.is_empty() {
            return Err("the file ends without its end mark".to_owned());
        }
        let mut fields = Fields(&header);
        let (Some(kind), Some(len)) = (fields.u8(), fields.u64()) else {
            return Err(CUT.to_owned());
        };
        match kind {
            op::CHUNK | op::CHANNEL | op::MESSAGE | op::METADATA if len > LONGEST => Err(format!(
                "a record says that it has {len} bytes; allowed are {LONGEST}"
            )),
            op::CHUNK | op::CHANNEL | op::MESSAGE | op::METADATA => {
                let body = self.read(len)?;
                if (body.len() as u64) < len {
                    return Err(CUT.to_owned());
                }
                Ok(Part::Record(kind, body))
            }
            op::FOOTER => self.skip(len).and_then(|()| self.end()),
            _ => self.skip(len).map(|()| Part::Skipped),
        }
    }

    /// Takes a record that is not a chunk.
    fn take(&mut self, kind: u8, body: &[u8]) -> Result<Option<Moment>, String> {
        let mut fields = Fields(body);
        match kind {
            op::CHANNEL => self.channel(&mut fields).map(|()| None),
            op::METADATA => {
                let metadata = metadata(&mut fields).ok_or(BAD_RECORD)?;
                if let Some((about, start)) = About::of_metadata(&metadata) {
                    self.about = Some(about);
                    self.start_ns = u64::try_from(start.as_nanosecond()).ok();
                }
                Ok(None)
            }
            op::MESSAGE => self.message(&mut fields).map(Some),
            _ => Ok(None),
        }
    }

    fn channel(&mut self, fields: &mut Fields<'_>) -> Result<(), String> {
        let mut read = || {
            let (id, _schema) = (fields.u16()?, fields.u16()?);
            Some((id, fields.text()?, fields.text()?))
        };
        let (id, topic, encoding) = read().ok_or(BAD_RECORD)?;
        if topic.len() > NAME_LEN {
            return Err(format!(
                "the name of a topic has {} bytes; allowed are {NAME_LEN}",
                topic.len()
            ));
        }
        let channel = Channel {
            topic: topic.into(),
            is_json: encoding == "json",
        };
        self.channels.insert(id, channel);
        Ok(())
    }

    fn message(&mut self, fields: &mut Fields<'_>) -> Result<Moment, String> {
        let mut read = || {
            let (id, _sequence) = (fields.u16()?, fields.u32()?);
            let (logged_ns, _published) = (fields.u64()?, fields.u64()?);
            Some((id, logged_ns))
        };
        let (id, logged_ns) = read().ok_or(BAD_RECORD)?;
        let channel = self
            .channels
            .get(&id)
            .ok_or_else(|| format!("a message belongs to channel {id}, which nothing describes"))?;
        let start_ns = *self.start_ns.get_or_insert(logged_ns);
        let at = Duration::from_nanos(logged_ns.saturating_sub(start_ns));
        self.last = Some(at);
        Ok(Moment {
            at,
            topic: Arc::clone(&channel.topic),
            entry: channel.entry(fields.0),
        })
    }

    /// Up to `len` bytes, fewer only where the file ends.
    fn read(&mut self, len: u64) -> Result<Vec<u8>, String> {
        let mut bytes = Vec::new();
        let read = self.file.by_ref().take(len).read_to_end(&mut bytes);
        read.map_err(|error| format!("the file cannot be read on: {error}"))?;
        Ok(bytes)
    }

    fn skip(&mut self, len: u64) -> Result<(), String> {
        let skipped = io::copy(&mut self.file.by_ref().take(len), &mut io::sink());
        let skipped = skipped.map_err(|error| format!("the file cannot be read on: {error}"))?;
        if skipped < len {
            return Err(CUT.to_owned());
        }
        self.good_bytes += HEADER_LEN + len;
        Ok(())
    }

    fn end(&mut self) -> Result<Part, String> {
        let magic = self.read(MAGIC.len() as u64)?;
        if magic == MAGIC {
            Ok(Part::End)
        } else {
            Err("the end mark of the file is damaged".to_owned())
        }
    }
}

impl Iterator for Recording {
    type Item = Moment;

    fn next(&mut self) -> Option<Moment> {
        while !self.over {
            match self.step() {
                Ok(None) => {}
                Ok(moment) => return moment,
                Err(reason) => {
                    self.over = true;
                    self.damage = Some(Damage {
                        good_bytes: self.good_bytes,
                        last: self.last,
                        reason,
                    });
                }
            }
        }
        None
    }
}

impl fmt::Debug for Recording {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Recording")
            .field("about", &self.about)
            .field("good_bytes", &self.good_bytes)
            .field("damage", &self.damage)
            .finish_non_exhaustive()
    }
}

impl Channel {
    fn entry(&self, data: &[u8]) -> Entry {
        let value = serde_json::from_slice(data).ok();
        let Some(value) = value.filter(|_| self.is_json) else {
            return Entry::Other(data.to_vec());
        };
        let wire: Option<fn(Vec<u8>) -> Entry> = match &*self.topic {
            TO_ARM => Some(Entry::ToArm),
            FROM_ARM => Some(Entry::FromArm),
            _ => None,
        };
        let bytes = |value: &Value| value.get("bytes")?.as_str().and_then(hex::bytes);
        match wire.and_then(|wire| bytes(&value).map(wire)) {
            Some(entry) => entry,
            None => Entry::Json(value),
        }
    }
}

fn metadata(fields: &mut Fields<'_>) -> Option<mcap::records::Metadata> {
    let name = fields.text()?.to_owned();
    let mut rest = fields.fields()?;
    let mut metadata = BTreeMap::new();
    while !rest.0.is_empty() {
        metadata.insert(rest.text()?.to_owned(), rest.text()?.to_owned());
    }
    Some(mcap::records::Metadata { name, metadata })
}

/// The kind of a record and its length.
pub(crate) const HEADER_LEN: u64 = 9;

/// The longest record and the longest chunk, in bytes.
pub(crate) const LONGEST: u64 = 8 << 20;

pub(crate) const BAD_RECORD: &str = "a record does not hold what its kind does";

const CUT: &str = "the file ends in the middle of a record";
