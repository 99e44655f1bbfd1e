//! A chunk: records that were compressed together.

use mcap::records::{Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};

/// A chunk: records that were compressed together, given out one by one. The checksum of a compressed
/// one is checked before any of it is.
pub(crate) struct Chunk {
    /// How long it is in the file, its header included.
    file_bytes: u64,
    reader: Box<LinearReader>,
}

impl Chunk {
    /// Opens a chunk, given as the body of its record.
    pub(crate) fn new(body: &[u8]) -> Result<Self, String> {
        let Ok(Record::Chunk { header, data }) = mcap::parse_record(op::CHUNK, body) else {
            return Err(BAD_RECORD.to_owned());
        };
        let is_whole = body.len() == NUMBERS_LEN + header.compression.len() + data.len();
        if !is_whole || header.uncompressed_size > LONGEST {
            return Err(BAD_RECORD.to_owned());
        }
        let is_compressed = match header.compression.as_str() {
            "" => false,
            "zstd" => true,
            other => {
                return Err(format!(
                    "a chunk is compressed with {other:?}; this program knows \"zstd\""
                ));
            }
        };
        let mut reader = LinearReader::new_with_options(LinearReaderOptions {
            skip_start_magic: true,
            skip_end_magic: true,
            prevalidate_chunk_crcs: is_compressed,
            record_length_limit: usize::try_from(LONGEST).ok(),
            ..LinearReaderOptions::default()
        });
        let record = [&[op::CHUNK][..], &(body.len() as u64).to_le_bytes(), body].concat();
        reader.insert(record.len()).copy_from_slice(&record);
        reader.notify_read(record.len());
        Ok(Self {
            file_bytes: record.len() as u64,
            reader: Box::new(reader),
        })
    }

    /// How long it is in the file, in bytes.
    pub(crate) const fn file_bytes(&self) -> u64 {
        self.file_bytes
    }

    /// The next record: its kind and its body.
    pub(crate) fn next(&mut self) -> Option<Result<(u8, Vec<u8>), String>> {
        loop {
            match self.reader.next_event()? {
                Ok(LinearReadEvent::Record { opcode, data }) => {
                    return Some(Ok((opcode, data.to_vec())));
                }
                // There is no more than the chunk.
                Ok(LinearReadEvent::ReadRequest(_)) => {}
                Err(error) => return Some(Err(format!("a chunk is damaged: {error}"))),
            }
            self.reader.notify_read(0);
        }
    }
}

/// The numbers before the records of a chunk, in bytes.
const NUMBERS_LEN: usize = 40;

/// The longest record and the longest chunk, in bytes.
pub(crate) const LONGEST: u64 = 8 << 20;

pub(crate) const BAD_RECORD: &str = "a record does not hold what its kind does";
