//! Places in the text of a file.

use std::fmt;

/// A place in a text file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The line, from 1.
    pub line: u32,
    /// The column in characters, from 1.
    pub column: u32,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

impl Place {
    pub(crate) fn new(line: usize, column: usize) -> Self {
        let [line, column] = [line, column].map(|value| u32::try_from(value).unwrap_or(u32::MAX));
        Self { line, column }
    }
}

impl From<usvg::roxmltree::TextPos> for Place {
    fn from(at: usvg::roxmltree::TextPos) -> Self {
        Self {
            line: at.row,
            column: at.col,
        }
    }
}

/// Line and column of an offset.
pub(crate) fn place(text: &[u8], at: usize) -> Place {
    let before = &text[..at.min(text.len())];
    #[expect(
        clippy::naive_bytecount,
        reason = "fast enough for a thousand mistakes"
    )]
    let count = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let last = before.iter().rposition(|&byte| byte == b'\n');
    let last = &before[last.map_or(0, |end| end + 1)..];
    // Continuation bytes of a character are not columns.
    let columns = last.iter().filter(|&&byte| byte & 0xC0 != 0x80).count() + 1;
    Place::new(count, columns)
}

/// The start of a text after an optional UTF-8 byte order mark.
pub(crate) fn beginning(text: &[u8]) -> usize {
    let mark = "\u{FEFF}".as_bytes();
    if text.starts_with(mark) {
        mark.len()
    } else {
        0
    }
}

/// The text at an offset, shortened, in quotes; "the end of the file" at its end.
pub(crate) fn excerpt(text: &[u8], at: usize) -> String {
    let rest = text.get(at..).unwrap_or_default();
    let line = rest.split(|byte| b"\r\n".contains(byte)).next();
    let line = line.unwrap_or_default();
    match (rest.is_empty(), line.is_empty()) {
        (true, _) => "the end of the file".to_owned(),
        (_, true) => "the end of the line".to_owned(),
        _ => format!("{:?}", shortened(&String::from_utf8_lossy(line))),
    }
}

pub(crate) fn shortened(text: &str) -> String {
    match text.char_indices().nth(20) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// A text of a file prepared for a message: on one line, without terminal control characters.
pub(crate) fn printable(text: &str) -> String {
    let mut printable = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_control() {
            printable.extend(character.escape_debug());
        } else {
            printable.push(character);
        }
    }
    printable
}
