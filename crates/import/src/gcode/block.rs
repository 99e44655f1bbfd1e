//! Blocks of G-code: the words of a line.

use super::subroutine::{self, Subroutines};
use crate::error::SourceError;
use crate::number::{decimal, real};
use crate::place::beginning;

/// A block: its G and M codes in order, and the values of its other letters.
#[derive(Debug, Default)]
pub(super) struct Block {
    /// The position of its line.
    pub(super) begin: usize,
    /// The position of its first word.
    pub(super) at: usize,
    /// Codes in tenths with their positions: `G90.1` is 901.
    pub(super) g: Codes,
    pub(super) m: Codes,
    pub(super) kind: BlockKind,
    /// Whether it starts with `/`.
    pub(super) is_optional: bool,
    /// The values; valid for letters in the bit set.
    values: [f64; 26],
    places: [u32; 26],
    /// The letters with a value, as a bit set.
    letters: u32,
}

/// What a block is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum BlockKind {
    /// Words, or nothing.
    #[default]
    Words,
    /// A `$` line, a command to GRBL that does not draw.
    Setting,
    /// A lone `?`, `!` or `~`, a real-time command of GRBL.
    RealTime,
    /// A second `%`, after which nothing belongs to the program.
    End,
}

impl Block {
    /// Clears the block and sets its position.
    fn begin(&mut self, at: usize) {
        (self.begin, self.at) = (at, at);
        self.g.0.clear();
        self.m.0.clear();
        (self.kind, self.is_optional) = (BlockKind::Words, false);
        self.letters = 0;
    }

    /// The value of a letter.
    pub(super) fn value(&self, letter: u8) -> Option<f64> {
        let i = usize::from(letter - b'A');
        (self.letters & (1 << i) != 0).then(|| self.values[i])
    }

    /// The position of a letter, or else of the line.
    pub(super) fn place(&self, letter: u8) -> usize {
        match self.value(letter) {
            Some(_) => self.at + self.places[usize::from(letter - b'A')] as usize,
            None => self.at,
        }
    }

    pub(super) fn has_any(&self, letters: &[u8]) -> bool {
        let bits = letters
            .iter()
            .fold(0, |bits, letter| bits | 1 << (letter - b'A'));
        self.letters & bits != 0
    }

    pub(super) fn is_empty(&self) -> bool {
        self.letters == 0 && self.g.0.is_empty() && self.m.0.is_empty()
    }

    /// Whether letters may have no value here: `G28 X` names an axis.
    fn allows_bare_letters(&self) -> bool {
        let homes = self.g.0.iter().any(|entry| [280, 300].contains(&entry.1));
        homes || self.m.0.iter().any(|entry| entry.1 > 90)
    }

    /// Whether a laser or a spindle is switched: `M3 I` does so with the following moves (Marlin).
    fn switches_tool(&self) -> bool {
        self.m.first(&[30, 40, 50]).is_some()
    }

    fn add(&mut self, text: &[u8], at: usize, letter: u8, value: f64) -> Result<(), SourceError> {
        let codes = match letter {
            b'G' => &mut self.g,
            b'M' => &mut self.m,
            _ => return self.set(text, at, letter, value),
        };
        let tenths = (value * 10.0).round();
        if !(0.0..=99_999.0).contains(&value) || (tenths - value * 10.0).abs() > 1e-6 {
            return Err(SourceError::unexpected(
                text,
                at,
                "a code such as G1 or G90.1",
            ));
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number below a million"
        )]
        codes.0.push((at, tenths as u32));
        Ok(())
    }

    fn set(&mut self, text: &[u8], at: usize, letter: u8, value: f64) -> Result<(), SourceError> {
        let i = usize::from(letter - b'A');
        if self.letters & (1 << i) != 0 {
            let once = format!("{} only once per line", char::from(letter));
            return Err(SourceError::unexpected(text, at, &once));
        }
        self.letters |= 1 << i;
        self.values[i] = value;
        // Longer files are refused before.
        self.places[i] = u32::try_from(at - self.at).unwrap_or(u32::MAX);
        Ok(())
    }
}

/// The codes with their positions.
#[derive(Debug, Default)]
pub(super) struct Codes(pub(super) Vec<(usize, u32)>);

impl Codes {
    pub(super) fn has(&self, code: u32) -> bool {
        self.0.iter().any(|entry| entry.1 == code)
    }

    pub(super) fn first(&self, codes: &[u32]) -> Option<(usize, u32)> {
        self.0
            .iter()
            .copied()
            .find(|entry| codes.contains(&entry.1))
    }
}

/// Passes on at most `most` lines with words one by one, in one reused block: a file has millions
/// of them. Subroutines are passed on where they are called. Returns the number of lines before
/// the first error, and the error.
pub(super) fn each(
    text: &[u8],
    most: usize,
    mut hand_on: impl FnMut(&Block) -> Result<(), SourceError>,
) -> (usize, Result<(), SourceError>) {
    let at = beginning(text);
    let mut lines = BlockLexer {
        text,
        at,
        has_percent: false,
        has_words: false,
    };
    let mut block = Block::default();
    let mut subroutines = Subroutines::new(text);
    let mut count = 0;
    while lines.at < text.len() && count < most {
        let read = lines.line(&mut block).and_then(|()| {
            lines.at = subroutines.next(lines.at, &block)?;
            if block.is_empty() && block.kind == BlockKind::Words {
                return Ok(());
            }
            hand_on(&block)
        });
        if read.is_err() {
            return (count, read);
        }
        count += 1;
    }
    (count, Ok(()))
}

struct BlockLexer<'a> {
    text: &'a [u8],
    at: usize,
    /// Whether a `%` has begun the program, and whether words have followed.
    has_percent: bool,
    has_words: bool,
}

impl BlockLexer<'_> {
    fn line(&mut self, block: &mut Block) -> Result<(), SourceError> {
        let begin = self.at;
        block.begin(begin);
        while let Some(byte) = self.peek() {
            match byte {
                b'\n' | b'\r' => {
                    self.at += 1;
                    break;
                }
                b' ' | b'\t' => self.at += 1,
                b'(' => self.comment()?,
                b';' => self.skip_line(),
                b'%' if block.is_empty() => {
                    if self.has_percent && self.has_words {
                        block.kind = BlockKind::End;
                    }
                    self.has_percent = true;
                    self.skip_line();
                }
                b'$' if block.is_empty() => {
                    (block.at, block.kind) = (self.at, BlockKind::Setting);
                    self.skip_line();
                }
                b'?' | b'!' | b'~' if block.is_empty() && self.is_last_word() => {
                    (block.at, block.kind) = (self.at, BlockKind::RealTime);
                    self.at += 1;
                }
                b'/' if block.is_empty() => {
                    block.is_optional = true;
                    self.at += 1;
                }
                b'*' => self.checksum(begin)?,
                b'O' | b'o' | b':' if block.is_empty() => self.program_number(block)?,
                _ => self.word(block)?,
            }
        }
        Ok(())
    }

    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    fn skip_line(&mut self) {
        let rest = &self.text[self.at..];
        let end = rest.iter().position(|byte| b"\r\n".contains(byte));
        self.at += end.unwrap_or(rest.len());
    }

    fn comment(&mut self) -> Result<(), SourceError> {
        let begin = self.at;
        self.skip_line();
        let line = &self.text[begin..self.at];
        let Some(end) = comment_end(line) else {
            return Err(self.found(begin, "a comment closed by ) on the same line"));
        };
        self.at = begin + end + 1;
        Ok(())
    }

    /// Whether only a comment follows this character.
    fn is_last_word(&self) -> bool {
        ends_line(&self.text[self.at + 1..])
    }

    /// Skips `O1234` or `:1234` with at most a comment, the name of the program, or the words of a
    /// subroutine.
    fn program_number(&mut self, block: &mut Block) -> Result<(), SourceError> {
        let at = self.at;
        if let Some(line) = subroutine::words(&self.text[at..]) {
            block.at = at;
            self.at += line.length;
            return Ok(());
        }
        let is_digit = |byte: &u8| byte.is_ascii_digit();
        let digits = self.text[at + 1..].iter().take_while(|byte| is_digit(byte));
        let end = at + 1 + digits.count();
        if end == at + 1 || !ends_line(&self.text[end..]) {
            return Err(self.found(at, WORD));
        }
        self.at = end;
        Ok(())
    }

    /// Checks `*71` after a line: the exclusive or of its bytes.
    fn checksum(&mut self, begin: usize) -> Result<(), SourceError> {
        let line = &self.text[begin..self.at];
        let expected = line.iter().fold(0, |sum, byte| sum ^ byte);
        let found = decimal(&self.text[self.at + 1..]);
        match found {
            Some((sum, length)) if sum == f64::from(expected) => self.at += 1 + length,
            _ => {
                let sum = format!("*{expected}, the checksum (XOR of the bytes of the line)");
                return Err(self.found(self.at, &sum));
            }
        }
        Ok(())
    }

    fn word(&mut self, block: &mut Block) -> Result<(), SourceError> {
        let at = self.at;
        let letter = self.text[at].to_ascii_uppercase();
        if !letter.is_ascii_uppercase() || letter == b'O' {
            return Err(self.found(at, WORD));
        }
        if block.is_empty() {
            block.at = at;
        }
        self.has_words = true;
        self.at += 1;
        while matches!(self.peek(), Some(b' ' | b'\t')) {
            self.at += 1;
        }
        let rest = &self.text[self.at..];
        let plain = decimal(rest);
        let number = match plain {
            Some((_, digits)) if has_exponent(&self.text[at..], &rest[digits..]) => {
                Some(real(rest).ok_or_else(|| self.found(at, NUMBER))?)
            }
            _ => plain,
        };
        let Some((value, length)) = number else {
            if block.allows_bare_letters() {
                return block.set(self.text, at, letter, 0.0);
            }
            if letter == b'I' && block.switches_tool() {
                return Ok(());
            }
            return Err(self.found(at, WORD));
        };
        self.at += length;
        // A message may contain anything.
        if letter == b'M' && [117.0, 118.0].contains(&value) {
            self.skip_line();
        }
        if letter == b'N' {
            return Ok(());
        }
        block.add(self.text, at, letter, value)
    }

    fn found(&self, at: usize, expected: &str) -> SourceError {
        SourceError::unexpected(self.text, at, expected)
    }
}

/// Whether only a comment precedes the end of the line.
pub(super) fn ends_line(rest: &[u8]) -> bool {
    let next = rest.iter().find(|byte| !b" \t".contains(byte));
    next.is_none_or(|next| b"\r\n(;".contains(next))
}

/// Whether a number continues with an exponent, as in `X1e-05`. `X1E5` has a word E after X: that
/// of an extruder.
fn has_exponent(word: &[u8], after: &[u8]) -> bool {
    match *after {
        // Programs write words in upper case, and exponents in lower case.
        [b'e', b'+' | b'-', b'0'..=b'9', ..] | [b'e', b'0'..=b'9', ..] => {
            word.first().is_some_and(u8::is_ascii_uppercase)
        }
        // No program writes 5 as 05.
        [b'E', b'+' | b'-', b'0', b'0'..=b'9', ..] => true,
        _ => false,
    }
}

/// The end of a comment at the start of a text: its own bracket, if inner ones are balanced.
fn comment_end(line: &[u8]) -> Option<usize> {
    let first = line.iter().position(|&byte| byte == b')')?;
    let semicolon = line[first..].iter().position(|&byte| byte == b';');
    let until = semicolon.map_or(line.len(), |length| first + length);
    let mut depth = 0_usize;
    let own = line[..until].iter().position(|byte| {
        match byte {
            b'(' => depth += 1,
            b')' => depth -= 1,
            _ => {}
        }
        depth == 0
    });
    own.or(Some(first))
}

const NUMBER: &str = "a number from -1e9 to 1e9";
const WORD: &str = "a word such as G1 or X-2.5 (variables, formulas, loops and conditions are not supported; expand them in the program that made the file)";
