//! Reads a recording, damaged or not.

use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use data_encoding::HEXLOWER_PERMISSIVE;
use mcap::records::op;
use serde_json::Value;

use crate::fields::Fields;
use crate::records::{BAD_RECORD, Flaw, Records};
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
    channels: HashMap<u16, Channel>,
    /// What came again and again, and was not given out yet.
    repeats: Option<Repeats>,
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

/// A packet that came again and again.
struct Repeats {
    topic: Arc<str>,
    packet: Vec<u8>,
    /// When it comes next, in nanoseconds since 1970.
    next_ns: Option<u64>,
    gaps_ns: std::vec::IntoIter<u64>,
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
        Ok(Self {
            records: Records::over(file)?,
            about: None,
            start_ns: None,
            channels: HashMap::new(),
            repeats: None,
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
            op::MESSAGE => self.message(&mut fields),
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

    fn message(&mut self, fields: &mut Fields<'_>) -> Result<Option<Moment>, String> {
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
        if let Some(repeats) = channel.repeats(logged_ns, fields.0) {
            self.repeats = Some(repeats);
            return Ok(None);
        }
        Ok(Some(Moment {
            at,
            topic: Arc::clone(&channel.topic),
            entry: channel.entry(fields.0),
        }))
    }

    /// The next of what came again and again.
    fn repeat(&mut self) -> Option<Moment> {
        let repeats = self.repeats.as_mut()?;
        let start_ns = self.start_ns.unwrap_or_default();
        let moment = repeats.next().map(|(at_ns, bytes)| Moment {
            at: Duration::from_nanos(at_ns.saturating_sub(start_ns)),
            topic: Arc::clone(&repeats.topic),
            entry: Entry::FromArm(bytes),
        });
        self.repeats.take_if(|_| moment.is_none());
        moment
    }
}

impl Iterator for Recording {
    type Item = Moment;

    fn next(&mut self) -> Option<Moment> {
        loop {
            if let Some(moment) = self.repeat() {
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

impl Iterator for Repeats {
    type Item = (u64, Vec<u8>);

    fn next(&mut self) -> Option<(u64, Vec<u8>)> {
        let at_ns = self.next_ns?;
        self.next_ns = self.gaps_ns.next().map(|gap_ns| at_ns + gap_ns);
        Some((at_ns, self.packet.clone()))
    }
}

impl Channel {
    /// The packets that a message of bytes from the arm tells, if it is of more than one.
    fn repeats(&self, last_ns: u64, data: &[u8]) -> Option<Repeats> {
        if &*self.topic != FROM_ARM || !self.is_json {
            return None;
        }
        let message: Repeated = serde_json::from_slice(data).ok()?;
        let packet = bytes_of(&message.bytes).filter(|it| !it.is_empty())?;
        let times_ns = message
            .gaps_ns
            .iter()
            .try_fold(0, |sum: u64, it| sum.checked_add(*it));
        Some(Repeats {
            topic: Arc::clone(&self.topic),
            packet,
            next_ns: Some(last_ns.checked_sub(times_ns?)?),
            gaps_ns: message.gaps_ns.into_iter(),
        })
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

fn metadata(fields: &mut Fields<'_>) -> Option<mcap::records::Metadata> {
    let name = fields.text()?.to_owned();
    let mut rest = fields.fields()?;
    let mut metadata = BTreeMap::new();
    while !rest.0.is_empty() {
        metadata.insert(rest.text()?.to_owned(), rest.text()?.to_owned());
    }
    Some(mcap::records::Metadata { name, metadata })
}

/// The bytes of hex digits; `None` where there is anything else.
fn bytes_of(digits: &str) -> Option<Vec<u8>> {
    HEXLOWER_PERMISSIVE.decode(digits.as_bytes()).ok()
}
