//! The records of an MCAP file, damaged or not, out of their chunks.

use std::io::{self, BufReader, Read};

use mcap::MAGIC;
use mcap::records::op;

use crate::OpenError;
use crate::chunk::{Chunk, LONGEST};

/// The records of an MCAP file up to its end or to where it cannot be read on. It takes a few
/// megabytes of memory at the most, whatever the file says about itself.
pub(crate) struct Records {
    file: BufReader<Box<dyn Read + Send>>,
    chunk: Option<Chunk>,
    /// How many bytes of the file were good before what was given out last.
    good_bytes: u64,
    /// How many bytes were given out last; they are good unless somebody finds otherwise.
    given_bytes: u64,
    over: bool,
    is_begun: bool,
}

/// Why a record cannot be read.
#[derive(Clone, Debug)]
pub(crate) struct Flaw {
    pub(crate) reason: String,
    /// There is nothing behind it: the file ends.
    pub(crate) breaks_off: bool,
}

impl Records {
    /// The records of what is read from there.
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

    /// The next record: its kind and its body. After a flaw there may be more: a damaged chunk does
    /// not hide what comes behind it.
    pub(crate) fn next(&mut self) -> Option<Result<(u8, Vec<u8>), Flaw>> {
        self.good_bytes += std::mem::take(&mut self.given_bytes);
        while !self.over {
            if let Some(record) = self.step().transpose() {
                return Some(record);
            }
        }
        None
    }

    /// How many bytes of the file were good before the record that was given out last.
    pub(crate) const fn good_bytes(&self) -> u64 {
        self.good_bytes
    }

    /// The next record, if what comes next holds one.
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

    /// Reads on where no chunk is open.
    fn part(&mut self) -> Result<Option<(u8, Vec<u8>)>, Flaw> {
        // Wherever what follows fails, nothing can be read on.
        self.over = true;
        if !self.is_begun {
            // The power may have been cut before.
            return Err(Flaw::end("the file ends before it begins"));
        }
        let header = self.read(HEADER_LEN as u64)?;
        if header.is_empty() {
            return Err(Flaw::end("the file ends without its end mark"));
        }
        let Ok([kind, len @ ..]) = <[u8; HEADER_LEN]>::try_from(header) else {
            return Err(Flaw::end(CUT));
        };
        let len = u64::from_le_bytes(len);
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

    fn body(&mut self, len: u64) -> Result<Vec<u8>, Flaw> {
        if len > LONGEST {
            return Err(Flaw::within(format!(
                "a record says that it has {len} bytes; allowed are {LONGEST}"
            )));
        }
        let body = self.read(len)?;
        if (body.len() as u64) < len {
            return Err(Flaw::end(CUT));
        }
        Ok(body)
    }

    /// Up to `len` bytes, fewer only where the file ends.
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
            Err(Flaw::end("the file ends before its end mark does"))
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
        Self::within(format!("the file cannot be read on: {error}"))
    }
}

/// The kinds of records that are given out; the others say nothing new.
const GIVEN: [u8; 5] = [
    op::HEADER,
    op::SCHEMA,
    op::CHANNEL,
    op::MESSAGE,
    op::METADATA,
];

/// The kind of a record and its length, in bytes.
const HEADER_LEN: usize = 9;

const CUT: &str = "the file ends in the middle of a record";
