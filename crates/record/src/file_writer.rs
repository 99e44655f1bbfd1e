//! The writer of one MCAP file.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::io::{self, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use jiff::Timestamp;
use mcap::records::MessageHeader;
use mcap::write::NoSeek;
use mcap::{Compression, McapResult, WriteOptions, Writer};

use crate::encoder::Message;
use crate::{About, Topic};

/// A writer of one MCAP file with small chunks, each written as a whole, so that flushed data stays
/// readable after a crash.
pub(crate) struct FileWriter<W: Write> {
    writer: Writer<NoSeek<Counted<W>>>,
    /// The number of bytes passed to the file.
    written: Arc<AtomicU64>,
    channels: HashMap<String, WrittenChannel>,
    /// An upper bound of the length of the index at the end of the file, in bytes.
    index_len: u64,
    chunk: Option<OpenChunk>,
    /// The log time of the last message, in nanoseconds since 1970.
    last_ns: u64,
}

/// A topic in the file.
#[derive(Clone, Copy)]
struct WrittenChannel {
    id: u16,
    messages: u32,
}

/// The chunk that is not flushed yet.
#[derive(Clone, Copy)]
struct OpenChunk {
    begin_ns: u64,
    /// An upper bound of its length in the file, in bytes.
    len: u64,
}

impl<W: Write> FileWriter<W> {
    /// Starts a file.
    pub(crate) fn begin(file: W, about: &About, start: Timestamp) -> McapResult<Self> {
        let written = Arc::new(AtomicU64::new(0));
        let counted = Counted {
            inner: file,
            count: Arc::clone(&written),
        };
        let mut file_writer = Self {
            writer: options().create(NoSeek::new(counted))?,
            written,
            channels: HashMap::new(),
            index_len: FRAME_LEN,
            chunk: None,
            last_ns: 0,
        };
        file_writer.write_about(about, start)?;
        Ok(file_writer)
    }

    /// Writes the metadata.
    pub(crate) fn write_about(&mut self, about: &About, start: Timestamp) -> McapResult<()> {
        self.flush()?;
        self.index_len += RECORD_LEN;
        self.writer.write_metadata(&about.metadata(start))?;
        self.writer.flush()
    }

    /// Writes a message; it is safe after the next [`FileWriter::flush`]. The log times are in
    /// order, as readers expect; the time of the message is its publish time.
    pub(crate) fn write(&mut self, message: &Message<'_>) -> McapResult<()> {
        self.last_ns = self.last_ns.max(message.at_ns);
        let log_time = self.last_ns;
        let (cost, index_len) = (self.cost(message), self.index_len);
        let channel = self.channel(message.topic)?;
        channel.messages = channel.messages.wrapping_add(1);
        let header = MessageHeader {
            channel_id: channel.id,
            sequence: channel.messages,
            log_time,
            publish_time: message.at_ns,
        };
        self.writer.write_to_known_channel(&header, &message.json)?;
        let chunk = self.chunk.get_or_insert(OpenChunk {
            begin_ns: message.at_ns,
            len: 0,
        });
        chunk.len += cost - (self.index_len - index_len);
        Ok(())
    }

    /// Whether a message would make the file longer than `limit`, in bytes.
    pub(crate) fn is_full_for(&self, message: &Message<'_>, limit: u64) -> bool {
        self.len_when_finished() + self.cost(message) > limit
    }

    /// Whether the file has room for another topic.
    pub(crate) fn has_room_for(&self, topic: &Topic) -> bool {
        self.channels.len() < TOPICS || self.channels.contains_key(topic.name())
    }

    /// Whether the unflushed data is worth a chunk.
    pub(crate) fn wants_flush(&self, now_ns: u64) -> bool {
        self.chunk.is_some_and(|chunk| {
            chunk.len >= CHUNK_LEN || now_ns.abs_diff(chunk.begin_ns) >= CHUNK_NS
        })
    }

    /// Flushes all written data to the file.
    pub(crate) fn flush(&mut self) -> McapResult<()> {
        if self.chunk.take().is_some() {
            self.index_len += RECORD_LEN + PER_CHANNEL_LEN * self.channels.len() as u64;
        }
        self.writer.flush()
    }

    /// Writes the index and the end mark, and returns the file.
    pub(crate) fn finish(mut self) -> McapResult<W> {
        self.writer.finish()?;
        let mut file = self.writer.into_inner().into_inner().inner;
        file.flush()?;
        Ok(file)
    }

    /// An upper bound of the length of the file if it is finished now, in bytes.
    fn len_when_finished(&self) -> u64 {
        let chunk_len = self.chunk.map_or(0, |chunk| chunk.len);
        self.written.load(Ordering::Relaxed) + chunk_len + self.index_len
    }

    /// An upper bound of the length that a message adds, in bytes.
    fn cost(&self, message: &Message<'_>) -> u64 {
        let topic = message.topic;
        let own = message.json.len() as u64 + RECORD_LEN;
        let channel = if self.channels.contains_key(topic.name()) {
            0
        } else {
            // In the chunk and in the index.
            2 * description_len(topic)
        };
        let chunk = match self.chunk {
            Some(_) => 0,
            None => 2 * (RECORD_LEN + PER_CHANNEL_LEN * self.channels.len() as u64),
        };
        // Incompressible data gets slightly longer.
        (own + channel) / 64 + own + channel + chunk
    }

    fn channel(&mut self, topic: &Topic) -> McapResult<&mut WrittenChannel> {
        match self.channels.entry(topic.name().to_owned()) {
            Entry::Occupied(known) => Ok(known.into_mut()),
            Entry::Vacant(new) => {
                let id = topic.add_to(&mut self.writer)?;
                self.index_len += description_len(topic);
                Ok(new.insert(WrittenChannel { id, messages: 0 }))
            }
        }
    }
}

impl<W: Write> std::fmt::Debug for FileWriter<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("FileWriter")
            .field("len_when_finished", &self.len_when_finished())
            .finish_non_exhaustive()
    }
}

/// The options of a file.
pub(crate) fn options() -> WriteOptions {
    WriteOptions::new()
        .library(concat!("dobot ", env!("CARGO_PKG_VERSION")))
        .compression(Some(Compression::Zstd))
        .compression_threads(0)
        // A chunk is complete in memory before any of it is written.
        .disable_seeking(true)
        .chunk_size(Some(MAX_CHUNK_LEN))
}

/// An upper bound of the length of schema and channel of a topic, and of its part in the indexes of
/// a chunk, in bytes.
const fn description_len(topic: &Topic) -> u64 {
    let names_len = 2 * (topic.name().len() + topic.schema_name().len());
    (topic.schema().len() + names_len) as u64 + RECORD_LEN + PER_CHANNEL_LEN
}

/// A writer that counts the bytes.
struct Counted<W> {
    inner: W,
    count: Arc<AtomicU64>,
}

impl<W: Write> Write for Counted<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.inner.write(bytes)?;
        self.count.fetch_add(count as u64, Ordering::Relaxed);
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

/// The largest number of topics of a file.
const TOPICS: usize = 64;

/// A chunk is flushed at this length ...
const CHUNK_LEN: u64 = 64 << 10;
/// ... or after this period, in nanoseconds.
const CHUNK_NS: u64 = 1_000_000_000;
/// The longest unflushed chunk; a single message may be long.
const MAX_CHUNK_LEN: u64 = 1 << 20;

/// Magic, header, statistics, footer.
const FRAME_LEN: u64 = 2048;
/// The fixed fields of a record and its index entries.
const RECORD_LEN: u64 = 160;
/// The part of each channel in the indexes of a chunk.
const PER_CHANNEL_LEN: u64 = 32;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;
    use serde_json::json;

    use super::*;

    /// A disk with a limited number of bytes.
    struct Disk(usize);

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            if self.0 == 0 {
                return Err(io::ErrorKind::StorageFull.into());
            }
            let count = bytes.len().min(self.0);
            self.0 -= count;
            Ok(count)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn topic(number: usize) -> Topic {
        let schema = json!({ "type": "object", "title": number });
        Topic::new(&format!("/{number}"), "x.X", &schema).unwrap()
    }

    #[test]
    fn a_full_disk_is_an_error_at_any_point() {
        let topic = topic(1);
        for room in 0..2000 {
            let written = || -> McapResult<()> {
                let (about, start) = (About::default(), Timestamp::UNIX_EPOCH);
                let mut file_writer = FileWriter::begin(Disk(room), &about, start)?;
                for at_ns in 0..100 {
                    let json = at_ns.to_string().into_bytes();
                    let topic = &topic;
                    let message = Message {
                        topic,
                        at_ns,
                        since_ns: at_ns,
                        json,
                    };
                    file_writer.write(&message)?;
                    file_writer.flush()?;
                }
                file_writer.finish().map(drop)
            };
            assert!(written().is_err(), "{room} bytes are not enough");
        }
    }

    proptest! {
        #[test]
        fn no_file_exceeds_its_predicted_size(
            messages in proptest::collection::vec((0..20_usize, 0..3000_usize, any::<bool>()), 1..200),
        ) {
            let topics: Vec<_> = (0..20).map(topic).collect();
            let (about, start) = (About::default(), Timestamp::UNIX_EPOCH);
            let mut file_writer = FileWriter::begin(Vec::new(), &about, start).unwrap();
            let mut noise = 1_u64;
            for (number, len, flush) in messages {
                let mut random = || {
                    noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    (noise >> 56) as u8
                };
                let json = (0..len).map(|_| random()).collect();
                let message = Message { topic: &topics[number], at_ns: 0, since_ns: 0, json };
                let foreseen = file_writer.len_when_finished() + file_writer.cost(&message);
                file_writer.write(&message).unwrap();
                prop_assert!(file_writer.len_when_finished() <= foreseen);
                if flush {
                    let foreseen = file_writer.len_when_finished();
                    file_writer.flush().unwrap();
                    prop_assert!(file_writer.len_when_finished() <= foreseen);
                }
            }
            let foreseen = file_writer.len_when_finished();
            let file = file_writer.finish().unwrap();
            prop_assert!(file.len() as u64 <= foreseen, "{} > {foreseen}", file.len());
        }
    }
}
