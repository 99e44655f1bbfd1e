//! The input to decode: its format and its streams.

use serde_json::json;

use super::content::Place;
use crate::output;

/// The input.
#[derive(Debug)]
pub(super) struct Input {
    /// The detected format.
    pub(super) format: String,
    /// Remarks for the person.
    pub(super) notes: Vec<String>,
    /// One stream for each direction, or one for all if the directions are unknown.
    pub(super) streams: Vec<Stream>,
}

/// The bytes of one direction.
#[derive(Debug, Default)]
pub(super) struct Stream {
    pub(super) parts: Vec<Part>,
}

/// Bytes without a gap.
#[derive(Debug, Default)]
pub(super) struct Part {
    /// The number of missing bytes before them.
    pub(super) gap: u64,
    pub(super) bytes: Vec<u8>,
    /// The arrivals, if known, in the order of the bytes.
    pub(super) chunks: Vec<Chunk>,
}

/// Bytes that arrived together.
#[derive(Debug)]
pub(super) struct Chunk {
    /// The offset in the part.
    pub(super) begin: usize,
    /// The index among the chunks of both directions.
    pub(super) order: usize,
    pub(super) place: Place,
}

impl Input {
    /// Creates an input of plain bytes.
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

    /// The remarks for the person: the format, unless it is a plain one, and the notes.
    pub(super) fn notes(&self) -> impl Iterator<Item = String> {
        let is_plain = self.format == HEX_DIGITS || self.format == BINARY;
        let format = (!is_plain).then(|| {
            format!(
                "read as {}: {}",
                self.format,
                output::count(self.len(), "byte")
            )
        });
        format.into_iter().chain(self.notes.iter().cloned())
    }

    /// The number of bytes.
    pub(super) fn len(&self) -> usize {
        let parts = self.streams.iter().flat_map(|stream| &stream.parts);
        parts.map(|part| part.bytes.len()).sum()
    }
}

impl Part {
    /// The order and the place of a range of bytes: the arrival of its last byte, or its offset.
    pub(super) fn place(&self, offset: usize, last: usize) -> (usize, Place) {
        let arrived = self.chunks.partition_point(|chunk| chunk.begin <= last);
        match self.chunks[..arrived].last() {
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

/// Plain formats.
pub(super) const BINARY: &str = "binary";
pub(super) const HEX_DIGITS: &str = "hex digits";
