//! A chunk: records that were compressed together.

use mcap::records::op;
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};

use crate::fields::Fields;
use crate::records::{BAD_RECORD, HEADER_LEN, LONGEST};

/// A chunk: records that were compressed together, given out one by one. The checksum of a compressed
/// one is checked before any of it is.
pub(crate) struct Chunk {
    /// How long it is in the file, its header included.
    file_bytes: u64,
    content: Content,
}

enum Content {
    /// How much of the record was given out, and the record.
    Plain(usize, Vec<u8>),
    Compressed(Box<LinearReader>),
}

impl Chunk {
    /// Opens a chunk, given as the body of its record.
    pub(crate) fn new(body: Vec<u8>) -> Result<Self, String> {
        let file_bytes = HEADER_LEN + body.len() as u64;
        let (compression, records) = header(&body).ok_or(BAD_RECORD)?;
        let content = match compression {
            "" => Content::Plain(body.len() - records.len(), body),
            "zstd" => Content::Compressed(Box::new(reader(&body))),
            other => {
                return Err(format!(
                    "a chunk is compressed with {other:?}; this program knows \"zstd\""
                ));
            }
        };
        Ok(Self {
            file_bytes,
            content,
        })
    }

    /// How long it is in the file, in bytes.
    pub(crate) const fn file_bytes(&self) -> u64 {
        self.file_bytes
    }

    /// The next record: its kind and its body.
    pub(crate) fn next(&mut self) -> Option<Result<(u8, Vec<u8>), String>> {
        match &mut self.content {
            Content::Plain(begin, chunk) => plain(begin, chunk),
            Content::Compressed(reader) => compressed(reader),
        }
    }
}

/// How a chunk is compressed, and its records.
fn header(body: &[u8]) -> Option<(&str, &[u8])> {
    let mut fields = Fields(body);
    let (_begin, _end, len, _crc) = (fields.u64()?, fields.u64()?, fields.u64()?, fields.u32()?);
    let (compression, records_len) = (fields.text()?, fields.u64()?);
    let is_whole = fields.0.len() as u64 == records_len && len <= LONGEST;
    is_whole.then_some((compression, fields.0))
}

/// A reader of nothing but this chunk.
fn reader(body: &[u8]) -> LinearReader {
    let options = LinearReaderOptions {
        skip_start_magic: true,
        skip_end_magic: true,
        prevalidate_chunk_crcs: true,
        record_length_limit: usize::try_from(LONGEST).ok(),
        ..LinearReaderOptions::default()
    };
    let mut reader = LinearReader::new_with_options(options);
    let record = [&[op::CHUNK][..], &(body.len() as u64).to_le_bytes(), body].concat();
    reader.insert(record.len()).copy_from_slice(&record);
    reader.notify_read(record.len());
    reader
}

fn plain(begin: &mut usize, chunk: &[u8]) -> Option<Result<(u8, Vec<u8>), String>> {
    let mut rest = Fields(&chunk[*begin..]);
    if rest.0.is_empty() {
        return None;
    }
    let record = rest.record().map(|(kind, body)| (kind, body.to_vec()));
    *begin = chunk.len() - rest.0.len();
    Some(record.ok_or_else(|| BAD_RECORD.to_owned()))
}

fn compressed(reader: &mut LinearReader) -> Option<Result<(u8, Vec<u8>), String>> {
    loop {
        match reader.next_event()? {
            Ok(LinearReadEvent::Record { opcode, data }) => {
                return Some(Ok((opcode, data.to_vec())));
            }
            // There is no more than the chunk.
            Ok(LinearReadEvent::ReadRequest(_)) => {}
            Err(error) => return Some(Err(format!("a chunk is damaged: {error}"))),
        }
        reader.notify_read(0);
    }
}
