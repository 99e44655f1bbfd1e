//! Subroutines without variables: `o100 sub`, `o100 endsub` and `o100 call`, as in `LinuxCNC`.

use std::collections::HashMap;

use super::block::{Block, ends_line};
use crate::error::SourceError;

/// The subroutines of a program, and the active calls.
#[derive(Debug)]
pub(super) struct Subroutines<'a> {
    text: &'a [u8],
    /// The starts of the bodies, by name.
    bodies: HashMap<Vec<u8>, usize>,
    /// The places after the active calls.
    returns: Vec<usize>,
    /// The number of bytes that calls may still read.
    left: usize,
}

impl<'a> Subroutines<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            bodies: HashMap::new(),
            returns: Vec::new(),
            left: MAX_CALLED,
        }
    }

    /// The place of the next line after a block that ends at `at`.
    pub(super) fn next(&mut self, at: usize, block: &Block) -> Result<usize, SourceError> {
        if !self.returns.is_empty() {
            let length = at - block.begin;
            let left = self.left.checked_sub(length);
            self.left = left.ok_or_else(|| self.found(block, "at most 16 MB of called lines"))?;
        }
        let line = words(&self.text[block.at..]).filter(|_| block.is_empty());
        let Some(Words { name, keyword, .. }) = line else {
            return Ok(at);
        };
        match keyword {
            Keyword::Begin => {
                self.bodies.insert(name.to_ascii_lowercase(), at);
                self.end_of(name, at, block)
            }
            Keyword::Call => {
                let body = self.bodies.get(&name.to_ascii_lowercase()).copied();
                let expected = "a call of a subroutine defined above in this file";
                let body = body.ok_or_else(|| self.found(block, expected))?;
                if self.returns.len() == MAX_DEPTH {
                    return Err(self.found(block, "calls nested at most 32 deep"));
                }
                self.returns.push(at);
                Ok(body)
            }
            Keyword::End => {
                let back = self.returns.pop();
                back.ok_or_else(|| self.found(block, "endsub only after sub"))
            }
        }
    }

    /// The place after the end of a subroutine.
    fn end_of(&self, name: &[u8], from: usize, block: &Block) -> Result<usize, SourceError> {
        let mut at = from;
        for line in self.text[from..].split_inclusive(|byte| b"\r\n".contains(byte)) {
            at += line.len();
            let is_end = words(line.trim_ascii_start()).is_some_and(|words| {
                words.keyword == Keyword::End && words.name.eq_ignore_ascii_case(name)
            });
            if is_end {
                return Ok(at);
            }
        }
        Err(self.found(block, "endsub with the same name after it"))
    }

    fn found(&self, block: &Block, expected: &str) -> SourceError {
        SourceError::unexpected(self.text, block.at, expected)
    }
}

/// The words of an `o` line.
pub(super) struct Words<'a> {
    name: &'a [u8],
    keyword: Keyword,
    /// Their length in bytes.
    pub(super) length: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Keyword {
    Begin,
    End,
    Call,
}

/// The words at the start of a line: `o100 sub`, `O<hole> call`.
pub(super) fn words(line: &[u8]) -> Option<Words<'_>> {
    let rest = line.strip_prefix(b"o").or(line.strip_prefix(b"O"))?;
    let is_named = rest.first() == Some(&b'<');
    let is_end = |byte: &u8| is_named && *byte == b'>' || !is_named && !byte.is_ascii_digit();
    let length = rest.iter().position(is_end)? + usize::from(is_named);
    let (name, rest) = rest.split_at(length);
    if name.is_empty() || name.iter().any(|byte| b"\r\n".contains(byte)) {
        return None;
    }
    let after = rest.trim_ascii_start();
    let letters = after.iter().take_while(|byte| byte.is_ascii_alphabetic());
    let (word, after) = after.split_at(letters.count());
    let keyword = match &*word.to_ascii_lowercase() {
        b"sub" => Keyword::Begin,
        b"endsub" => Keyword::End,
        b"call" => Keyword::Call,
        _ => return None,
    };
    ends_line(after).then_some(Words {
        name,
        keyword,
        length: line.len() - after.len(),
    })
}

const MAX_DEPTH: usize = 32;
/// The largest number of bytes of called lines: subroutines may call each other very often.
const MAX_CALLED: usize = if cfg!(test) { 1_000_000 } else { 16_000_000 };
