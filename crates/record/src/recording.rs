//! Reads a recording, damaged or not.

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

/// A recording, read from its beginning: an iterator of what was recorded, in the order in which it
/// was.
///
/// A file that breaks off, as after a power cut, is read up to there; so is one that is damaged. The
/// iterator simply ends, and [`Recording::damage`] tells where and why. It takes a few megabytes of
/// memory at the most, whatever the file says about itself.
pub struct Recording {
    records: Records,
    about: Option<About>,
    /// Nanoseconds since 1970 when the times begin.
    start_ns: Option<u64>,
    channels: HashMap<u16, ReadChannel>,
    /// What came again and again, and was not given out yet.
    repeats: Box<dyn Iterator<Item = Moment> + Send>,
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
    /// It is not an MCAP file.
    #[error("it is no recording: it does not begin as an MCAP file does")]
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
    /// [`OpenError`]; a file that breaks off is not an error.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        Self::over(File::open(path)?)
    }

    /// Reads a recording from anywhere.
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
    fn step(&mut self) -> Result<Option<Moment>, Flaw> {
        let Some(record) = self.records.next() else {
            self.over = true;
            return Ok(None);
        };
        let (kind, body) = record?;
        self.take(kind, &body).map_err(Flaw::within)
    }

    /// Takes a record that is not a chunk.
    fn take(&mut self, kind: u8, body: &[u8]) -> Result<Option<Moment>, String> {
        if !matches!(kind, op::CHANNEL | op::METADATA | op::MESSAGE) {
            return Ok(None);
        }
        match mcap::parse_record(kind, body).map_err(|_| BAD_RECORD)? {
            Record::Channel(channel) => self.channel(channel)?,
            Record::Metadata(metadata) => {
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
        let (id, logged_ns) = (header.channel_id, header.log_time);
        let channel = self
            .channels
            .get(&id)
            .ok_or_else(|| format!("a message belongs to channel {id}, which nothing describes"))?;
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
    /// The packets that a message of bytes from the arm tells, if it is of more than one.
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
        let packet = bytes_of(&bytes).filter(|it| !it.is_empty())?;
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

/// What a message tells of a packet that came again and again.
#[derive(serde::Deserialize)]
struct Repeated {
    bytes: String,
    gaps_ns: Vec<u64>,
}

/// The bytes of hex digits; `None` where there is anything else.
fn bytes_of(digits: &str) -> Option<Vec<u8>> {
    HEXLOWER_PERMISSIVE.decode(digits.as_bytes()).ok()
}
