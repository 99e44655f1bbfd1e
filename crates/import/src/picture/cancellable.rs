//! Bytes of a file that cannot be read any more once the reading is cancelled.

use std::io::{self, BufRead, Cursor, Read, Seek, SeekFrom};

use dobot_geometry::CancelToken;

/// The bytes of a file for a decoder, which itself cannot be cancelled: it gets an error instead of further
/// bytes. They are given in small parts, because packed pixels may take a thousand times as much.
#[derive(Debug)]
pub(super) struct CancellableBytes<'a> {
    bytes: Cursor<&'a [u8]>,
    cancel: CancelToken,
}

impl<'a> CancellableBytes<'a> {
    pub(super) fn new(bytes: &'a [u8], cancel: &CancelToken) -> Self {
        Self {
            bytes: Cursor::new(bytes),
            cancel: cancel.clone(),
        }
    }
}

impl Read for CancellableBytes<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

impl BufRead for CancellableBytes<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.cancel.check().map_err(io::Error::other)?;
        let rest = self.bytes.fill_buf()?;
        Ok(&rest[..rest.len().min(MAX_PART)])
    }

    fn consume(&mut self, count: usize) {
        self.bytes.consume(count);
    }
}

impl Seek for CancellableBytes<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(to)
    }
}

const MAX_PART: usize = 4096;
