//! The records of an MCAP file, damaged or not, out of their chunks.

use std::io::{self, BufReader, Read};

use mcap::MAGIC;
use mcap::records::op;

use crate::OpenError;
use crate::chunk::{Chunk, MAX_LEN};

/// An iterator over the records of an MCAP file up to its end or to the damage. It uses a few
/// megabytes of memory at most, whatever the file declares.
pub(crate) struct Records {
    file: BufReader<Box<dyn Read + Send>>,
    chunk: Option<Chunk>,
    /// The number of good bytes before the last returned record.
    good_bytes: u64,
    /// The length of the last returned record; its bytes are good unless the caller finds
    /// otherwise.
    given_bytes: u64,
    over: bool,
    is_begun: bool,
}

/// The reason why a record cannot be read.
#[derive(Clone, Debug)]
pub(crate) struct Flaw {
    pub(crate) reason: String,
    /// Whether the file simply ends there.
    pub(crate) breaks_off: bool,
}

impl Records {
    /// Creates an iterator over the records of a reader.
    pub(crate) fn over(file: impl Read + Send + 'static) -> Result<Self, OpenError> {
        let file: Box<dyn Read + Send> = Box::new(file);
        let mut file = BufReader::new(file);
        let mut magic = Vec::new();
        file.by_ref()
            .take(MAGIC.len() as u64)
            .read_to_end(&mut magic)?;
        if !MAGIC.starts_with(&magic) {
            return Err(OpenError::NotMcap);
        }
        let is_begun = magic == MAGIC;
        Ok(Self {
            file,
            chunk: None,
            good_bytes: if is_begun { MAGIC.len() as u64 } else { 0 },
            given_bytes: 0,
            over: false,
            is_begun,
        })
    }

    /// Returns the next record: its type and its body. After a flaw there may be more: a damaged
    /// chunk does not hide later ones.
    pub(crate) fn next(&mut self) -> Option<Result<(u8, Vec<u8>), Flaw>> {
        self.good_bytes += std::mem::take(&mut self.given_bytes);
        while !self.over {
            if let Some(record) = self.step().transpose() {
                return Some(record);
            }
        }
        None
    }

    /// The number of good bytes before the last returned record.
    pub(crate) const fn good_bytes(&self) -> u64 {
        self.good_bytes
    }

    /// Returns the next record, if the next part of the file contains one.
    fn step(&mut self) -> Result<Option<(u8, Vec<u8>)>, Flaw> {
        let Some(chunk) = &mut self.chunk else {
            return self.part();
        };
        match chunk.next() {
            Some(Ok(record)) => Ok(GIVEN.contains(&record.0).then_some(record)),
            Some(Err(reason)) => {
                self.chunk = None;
                Err(Flaw::within(reason))
            }
            None => {
                self.good_bytes += chunk.file_bytes();
                self.chunk = None;
                Ok(None)
            }
        }
    }

    /// Continues outside a chunk.
    fn part(&mut self) -> Result<Option<(u8, Vec<u8>)>, Flaw> {
        // After a failure in the following, nothing more can be read.
        self.over = true;
        let (kind, len) = self.header()?;
        match kind {
            op::FOOTER => self.skip(len).and_then(|()| self.end()).map(|()| None),
            op::CHUNK => {
                let body = self.body(len)?;
                self.over = false;
                self.chunk = Some(Chunk::new(&body).map_err(Flaw::within)?);
                Ok(None)
            }
            _ if GIVEN.contains(&kind) => {
                let body = self.body(len)?;
                self.over = false;
                self.given_bytes = HEADER_LEN as u64 + len;
                Ok(Some((kind, body)))
            }
            _ => {
                self.skip(len)?;
                self.over = false;
                Ok(None)
            }
        }
    }

    /// Reads the kind and the length of the next record.
    fn header(&mut self) -> Result<(u8, u64), Flaw> {
        if !self.is_begun {
            // The power may have failed before.
            return Err(Flaw::end("the file ends within its header"));
        }
        let header = self.read(HEADER_LEN as u64)?;
        if header.is_empty() {
            return Err(Flaw::end("the file ends without its end mark"));
        }
        let Ok([kind, len @ ..]) = <[u8; HEADER_LEN]>::try_from(header) else {
            return Err(Flaw::end(CUT));
        };
        Ok((kind, u64::from_le_bytes(len)))
    }

    fn body(&mut self, len: u64) -> Result<Vec<u8>, Flaw> {
        if len > MAX_LEN {
            return Err(Flaw::within(format!(
                "a record has a length of {len} bytes; allowed are {MAX_LEN}"
            )));
        }
        let body = self.read(len)?;
        if (body.len() as u64) < len {
            return Err(Flaw::end(CUT));
        }
        Ok(body)
    }

    /// Reads up to `len` bytes; fewer only at the end of the file.
    fn read(&mut self, len: u64) -> Result<Vec<u8>, Flaw> {
        let mut bytes = Vec::new();
        let read = self.file.by_ref().take(len).read_to_end(&mut bytes);
        read.map_err(|error| Flaw::io(&error))?;
        Ok(bytes)
    }

    fn skip(&mut self, len: u64) -> Result<(), Flaw> {
        let skipped = io::copy(&mut self.file.by_ref().take(len), &mut io::sink());
        if skipped.map_err(|error| Flaw::io(&error))? < len {
            return Err(Flaw::end(CUT));
        }
        self.good_bytes += HEADER_LEN as u64 + len;
        Ok(())
    }

    fn end(&mut self) -> Result<(), Flaw> {
        let magic = self.read(MAGIC.len() as u64)?;
        if magic == MAGIC {
            Ok(())
        } else if MAGIC.starts_with(&magic) {
            Err(Flaw::end("the file ends within its end mark"))
        } else {
            Err(Flaw::within("the end mark of the file is damaged"))
        }
    }
}

impl Flaw {
    pub(crate) fn within(reason: impl Into<String>) -> Self {
        Self {
            reason: reason.into(),
            breaks_off: false,
        }
    }

    fn end(reason: &str) -> Self {
        Self {
            reason: reason.to_owned(),
            breaks_off: true,
        }
    }

    fn io(error: &io::Error) -> Self {
        Self::within(format!("cannot read further: {error}"))
    }
}

/// The record types that are returned; the others contain nothing new.
const GIVEN: [u8; 5] = [
    op::HEADER,
    op::SCHEMA,
    op::CHANNEL,
    op::MESSAGE,
    op::METADATA,
];

/// The type of a record and its length, in bytes.
const HEADER_LEN: usize = 9;

const CUT: &str = "the file ends in the middle of a record";
