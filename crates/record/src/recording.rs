//! The reader of recordings, damaged or not.

use std::collections::HashMap;
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use data_encoding::HEXLOWER_PERMISSIVE;
use mcap::records::{self, MessageHeader, Record, op};
use serde_json::Value;

use crate::chunk::BAD_RECORD;
use crate::records::{Flaw, Records};
use crate::topic::{FROM_ARM, NAME_LEN, TO_ARM};
use crate::{About, Damage, Entry, Moment};

/// A recording, as an iterator of its entries in order.
///
/// A truncated or damaged file is read up to the damage; the iterator simply ends, and
/// [`Recording::damage`] gives position and reason. It uses a few megabytes of memory at most,
/// whatever the file declares.
pub struct Recording {
    records: Records,
    about: Option<About>,
    /// The start of the times, in nanoseconds since 1970.
    start_ns: Option<u64>,
    channels: HashMap<u16, ReadChannel>,
    /// Repeated packets that were not returned yet.
    repeats: Box<dyn Iterator<Item = Moment> + Send>,
    last: Option<Duration>,
    over: bool,
    damage: Option<Damage>,
}

/// The error returned when a file cannot be read as a recording.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// The file cannot be opened.
    #[error("cannot read the recording")]
    Io(#[from] io::Error),
    /// The file is not an MCAP file.
    #[error("not a recording; recordings are MCAP files")]
    NotMcap,
}

#[derive(Clone, Debug)]
struct ReadChannel {
    topic: Arc<str>,
    is_json: bool,
}

impl Recording {
    /// Opens a file.
    ///
    /// # Errors
    ///
    /// [`OpenError`]; a truncated file is not an error.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        Self::over(File::open(path)?)
    }

    /// Reads a recording from any reader.
    ///
    /// # Errors
    ///
    /// [`OpenError`].
    pub fn over(file: impl Read + Send + 'static) -> Result<Self, OpenError> {
        Ok(Self {
            records: Records::over(file)?,
            about: None,
            start_ns: None,
            channels: HashMap::new(),
            repeats: Box::new(std::iter::empty()),
            last: None,
            over: false,
            damage: None,
        })
    }

    /// The metadata, as far as it was read: known from the first entry on; `None` in files of other
    /// programs.
    #[must_use]
    pub const fn about(&self) -> Option<&About> {
        self.about.as_ref()
    }

    /// The start of its times; `None` before its first entry.
    #[must_use]
    pub fn start(&self) -> Option<jiff::Timestamp> {
        jiff::Timestamp::from_nanosecond(self.start_ns?.into()).ok()
    }

    /// The damage, after the recording was read to its end; `None` if it is complete.
    #[must_use]
    pub const fn damage(&self) -> Option<&Damage> {
        self.damage.as_ref()
    }

    /// The next entry, if the next record contains one.
    fn step(&mut self) -> Result<Option<Moment>, Flaw> {
        let Some(record) = self.records.next() else {
            self.over = true;
            return Ok(None);
        };
        let (kind, body) = record?;
        self.take(kind, &body).map_err(Flaw::within)
    }

    /// Handles a record that is not a chunk.
    fn take(&mut self, kind: u8, body: &[u8]) -> Result<Option<Moment>, String> {
        if !matches!(kind, op::CHANNEL | op::METADATA | op::MESSAGE) {
            return Ok(None);
        }
        match mcap::parse_record(kind, body).map_err(|_| BAD_RECORD)? {
            Record::Channel(channel) => self.channel(channel)?,
            Record::Metadata(metadata) => {
                About::check_format(&metadata)?;
                if let Some((about, start)) = About::of_metadata(&metadata) {
                    self.about = Some(about);
                    self.start_ns = u64::try_from(start.as_nanosecond()).ok();
                }
            }
            Record::Message { header, data } => return self.message(&header, &data),
            _ => {}
        }
        Ok(None)
    }

    fn channel(&mut self, channel: records::Channel) -> Result<(), String> {
        let name_len = channel.topic.len();
        if name_len > NAME_LEN {
            return Err(format!(
                "the name of a topic has {name_len} bytes; allowed are {NAME_LEN}"
            ));
        }
        let read = ReadChannel {
            topic: channel.topic.into(),
            is_json: channel.message_encoding == "json",
        };
        self.channels.insert(channel.id, read);
        Ok(())
    }

    fn message(&mut self, header: &MessageHeader, data: &[u8]) -> Result<Option<Moment>, String> {
        let id = header.channel_id;
        // The log time of a recorder's message is later if the clock went back.
        let logged_ns = match &self.about {
            Some(_) => header.publish_time,
            None => header.log_time,
        };
        let channel = self
            .channels
            .get(&id)
            .ok_or_else(|| format!("a message belongs to channel {id}, which is not defined"))?;
        let start_ns = *self.start_ns.get_or_insert(logged_ns);
        let at = Duration::from_nanos(logged_ns.saturating_sub(start_ns));
        self.last = Some(at);
        if let Some(repeats) = channel.repeats(start_ns, logged_ns, data) {
            self.repeats = Box::new(repeats);
            return Ok(None);
        }
        Ok(Some(Moment {
            at,
            topic: Arc::clone(&channel.topic),
            entry: channel.entry(data),
        }))
    }
}

impl Iterator for Recording {
    type Item = Moment;

    fn next(&mut self) -> Option<Moment> {
        loop {
            if let Some(moment) = self.repeats.next() {
                return Some(moment);
            }
            if self.over {
                return None;
            }
            match self.step() {
                Ok(None) => {}
                Ok(moment) => return moment,
                Err(flaw) => {
                    self.over = true;
                    self.damage = Some(Damage {
                        good_bytes: self.records.good_bytes(),
                        last: self.last,
                        reason: flaw.reason,
                        breaks_off: flaw.breaks_off,
                    });
                }
            }
        }
    }
}

impl fmt::Debug for Recording {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Recording")
            .field("about", &self.about)
            .field("good_bytes", &self.records.good_bytes())
            .field("damage", &self.damage)
            .finish_non_exhaustive()
    }
}

impl ReadChannel {
    /// The packets of a message with bytes from the arm, if it contains more than one.
    fn repeats(
        &self,
        start_ns: u64,
        last_ns: u64,
        data: &[u8],
    ) -> Option<impl Iterator<Item = Moment> + Send + use<>> {
        if &*self.topic != FROM_ARM || !self.is_json {
            return None;
        }
        let Repeated { bytes, gaps_ns } = serde_json::from_slice(data).ok()?;
        let packet = bytes_of(&bytes).filter(|bytes| !bytes.is_empty())?;
        let mut gaps = gaps_ns.iter();
        let lasted_ns = gaps.try_fold(0, |sum: u64, gap_ns| sum.checked_add(*gap_ns))?;
        let first_ns = last_ns.checked_sub(lasted_ns)?;
        let topic = Arc::clone(&self.topic);
        let times_ns = std::iter::once(0)
            .chain(gaps_ns)
            .scan(first_ns, |at_ns, gap_ns| {
                *at_ns += gap_ns;
                Some(*at_ns)
            });
        Some(times_ns.map(move |at_ns| Moment {
            at: Duration::from_nanos(at_ns.saturating_sub(start_ns)),
            topic: Arc::clone(&topic),
            entry: Entry::FromArm(packet.clone()),
        }))
    }

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
        let bytes = |value: &Value| value.get("bytes")?.as_str().and_then(bytes_of);
        match wire.and_then(|wire| bytes(&value).map(wire)) {
            Some(entry) => entry,
            None => Entry::Json(value),
        }
    }
}

/// The content of a message about a repeated packet.
#[derive(serde::Deserialize)]
struct Repeated {
    bytes: String,
    gaps_ns: Vec<u64>,
}

/// The bytes of hex digits; `None` for anything else.
fn bytes_of(digits: &str) -> Option<Vec<u8>> {
    HEXLOWER_PERMISSIVE.decode(digits.as_bytes()).ok()
}
