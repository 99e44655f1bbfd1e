//! What is decoded: in which format it was, and in which directions it went.

use serde_json::json;

use super::content::Place;

/// What was read.
#[derive(Debug)]
pub(super) struct Input {
    /// The format that it was in.
    pub(super) format: String,
    /// What else a person has to know about it.
    pub(super) notes: Vec<String>,
    /// What went each way; all in one where that is not known.
    pub(super) streams: Vec<Stream>,
}

/// What went one way.
#[derive(Debug, Default)]
pub(super) struct Stream {
    pub(super) parts: Vec<Part>,
}

/// Bytes that followed each other without a gap.
#[derive(Debug, Default)]
pub(super) struct Part {
    /// How many bytes are missing before them.
    pub(super) gap: u64,
    pub(super) bytes: Vec<u8>,
    /// When they came, where that is known: in the order of their bytes.
    pub(super) chunks: Vec<Chunk>,
}

/// Bytes that came at once.
#[derive(Debug)]
pub(super) struct Chunk {
    /// Where they begin in their part.
    pub(super) begin: usize,
    /// Which they are of all chunks, both ways.
    pub(super) order: usize,
    pub(super) place: Place,
}

impl Input {
    /// Bytes of which nothing else is known.
    pub(super) fn plain(format: impl Into<String>, bytes: Vec<u8>) -> Self {
        let part = Part {
            bytes,
            ..Part::default()
        };
        Self {
            format: format.into(),
            notes: Vec::new(),
            streams: vec![Stream { parts: vec![part] }],
        }
    }

    /// What a person has to know about what was read: the format, unless it is one of the plain ones,
    /// and the notes.
    pub(super) fn notes(&self) -> impl Iterator<Item = String> {
        let is_plain = self.format == HEX_DIGITS || self.format == BINARY;
        let format = (!is_plain).then(|| format!("read as {}: {} bytes", self.format, self.len()));
        format.into_iter().chain(self.notes.iter().cloned())
    }

    /// How many bytes were read.
    pub(super) fn len(&self) -> usize {
        let parts = self.streams.iter().flat_map(|stream| &stream.parts);
        parts.map(|part| part.bytes.len()).sum()
    }
}

impl Part {
    /// Where a stretch of bytes is, with its place in the order of all: when its last byte came, or else
    /// its offset.
    pub(super) fn place(&self, offset: usize, last: usize) -> (usize, Place) {
        let behind = self.chunks.partition_point(|chunk| chunk.begin <= last);
        match self.chunks[..behind].last() {
            Some(chunk) => (chunk.order, chunk.place.clone()),
            None => (offset, Place::of_offset(offset)),
        }
    }
}

impl Place {
    fn of_offset(offset: usize) -> Self {
        Self {
            text: format!("{offset:6}"),
            fields: vec![("offset", json!(offset))],
        }
    }
}

/// Formats that need no remark.
pub(super) const BINARY: &str = "binary";
pub(super) const HEX_DIGITS: &str = "hex digits";
