//! What is decoded: where it comes from, in which format it is, and in which directions it went.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, anyhow};
use serde_json::json;

use super::Place;
use super::{capture, text};
use crate::failure::Failure;

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

/// Reads what the arguments name: a file, standard input, or the bytes themselves.
pub(super) fn read(input: &[String]) -> Result<Input, Failure> {
    let bytes = match input {
        [dash] if dash == "-" => {
            let mut bytes = Vec::new();
            std::io::stdin()
                .read_to_end(&mut bytes)
                .context("cannot read standard input")?;
            bytes
        }
        [file] if Path::new(file).exists() => {
            std::fs::read(file).with_context(|| format!("cannot read {file}"))?
        }
        _ => return of_arguments(input),
    };
    of_bytes(bytes)
}

fn of_arguments(input: &[String]) -> Result<Input, Failure> {
    let is_name = matches!(input, [name] if name.contains(['.', '/']));
    text::read(&input.join(" ")).map_err(|error| {
        if is_name {
            Failure::from(anyhow!("there is no file {}", input[0]))
        } else {
            not_read(error)
        }
    })
}

/// Finds out what bytes hold: a capture, text, or the packets themselves.
pub(super) fn of_bytes(bytes: Vec<u8>) -> Result<Input, Failure> {
    if let Some(input) = capture::read(&bytes) {
        return Ok(input?);
    }
    match as_text(&bytes) {
        Some(text) => text::read(text).map_err(not_read),
        None => Ok(Input::plain(BINARY, bytes)),
    }
}

/// The text that a file holds, if it is one: packets hold bytes that no text has.
fn as_text(bytes: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(bytes).ok()?;
    let is_control = |it: char| it.is_control() && !matches!(it, '\t' | '\r' | '\n');
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    (!text.contains(is_control)).then_some(text)
}

fn not_read(error: anyhow::Error) -> Failure {
    Failure::new(
        error,
        "tried were hex digits, Python bytes, lists of numbers, xxd, hexdump -C, od -t x1 and socat -x; \
         `dobot decode --help` shows them",
    )
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
        let is_plain = self.format == text::HEX_DIGITS || self.format == BINARY;
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

const BINARY: &str = "binary";
