//! Chunks: groups of compressed records.

use mcap::records::{Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};

/// A chunk of compressed records, read one by one. The checksum of the chunk is verified before its
/// first record.
pub(crate) struct Chunk {
    /// The length in the file including the header, in bytes.
    file_bytes: u64,
    reader: Box<LinearReader>,
}

impl Chunk {
    /// Opens a chunk from the body of its record.
    pub(crate) fn new(body: &[u8]) -> Result<Self, String> {
        let Ok(Record::Chunk { header, data }) = mcap::parse_record(op::CHUNK, body) else {
            return Err(BAD_RECORD.to_owned());
        };
        let is_whole = body.len() == NUMBERS_LEN + header.compression.len() + data.len();
        if !is_whole || header.uncompressed_size > MAX_LEN {
            return Err(BAD_RECORD.to_owned());
        }
        let is_compressed = is_compressed(&header.compression)?;
        let mut reader = LinearReader::new_with_options(LinearReaderOptions {
            skip_start_magic: true,
            skip_end_magic: true,
            prevalidate_chunk_crcs: is_compressed,
            record_length_limit: usize::try_from(MAX_LEN).ok(),
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

    /// The length in the file, in bytes.
    pub(crate) const fn file_bytes(&self) -> u64 {
        self.file_bytes
    }

    /// Returns the next record: its type and its body.
    pub(crate) fn next(&mut self) -> Option<Result<(u8, Vec<u8>), String>> {
        loop {
            match self.reader.next_event()? {
                Ok(LinearReadEvent::Record { opcode, data }) => {
                    return Some(Ok((opcode, data.to_vec())));
                }
                // The chunk is complete.
                Ok(LinearReadEvent::ReadRequest(_)) => {}
                Err(error) => return Some(Err(format!("a chunk is damaged: {error}"))),
            }
            self.reader.notify_read(0);
        }
    }
}

fn is_compressed(compression: &str) -> Result<bool, String> {
    match compression {
        "" => Ok(false),
        "zstd" => Ok(true),
        other => Err(format!(
            "a chunk is compressed with {other:?}; supported is \"zstd\""
        )),
    }
}

/// The length of the fields before the records of a chunk, in bytes.
const NUMBERS_LEN: usize = 40;

/// The longest record and the longest chunk, in bytes.
pub(crate) const MAX_LEN: u64 = 8 << 20;

pub(crate) const BAD_RECORD: &str = "a record does not match its type";
