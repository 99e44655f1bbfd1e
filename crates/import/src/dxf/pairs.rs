//! A DXF file is pairs of lines: a group code, which tells what the value below it is.

use std::borrow::Cow;

use crate::error::SourceError;
use crate::limits::MAX_NUMBER;
use crate::place::{beginning, shortened};

/// A group code with its value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'a> {
    /// All of the file.
    text: &'a [u8],
    pub(super) code: i32,
    pub(super) value: &'a [u8],
    /// Where the code stands in the text.
    pub(super) at: usize,
    /// Where the value stands.
    pub(super) value_at: usize,
}

impl<'a> Pair<'a> {
    /// The same value under another code.
    pub(super) const fn with_code(self, code: i32) -> Self {
        Self { code, ..self }
    }

    pub(super) fn is(&self, code: i32, value: &[u8]) -> bool {
        self.code == code && self.value == value
    }

    /// The value as a number. That of a coordinate may be as large as it is in a plan in millimetres, in the
    /// coordinates of the country.
    pub(super) fn number(&self) -> Result<f64, SourceError> {
        let (most, expected) = match self.code {
            10..=39 => (MOST_COORDINATE, "a number from -1e12 to 1e12"),
            _ => (MAX_NUMBER, "a number from -1e9 to 1e9"),
        };
        let number = std::str::from_utf8(self.value)
            .ok()
            .and_then(|it| it.parse().ok());
        let number = number.filter(|it: &f64| it.abs() <= most);
        number.ok_or_else(|| self.refused(expected))
    }

    pub(super) fn refused(&self, expected: &str) -> SourceError {
        let found = format!("{:?} for group {}", shortened(&self.text()), self.code);
        SourceError::found(self.text, self.value_at, found, expected)
    }

    /// The value as text.
    pub(super) fn text(&self) -> Cow<'a, str> {
        String::from_utf8_lossy(self.value)
    }

    /// The same with the spaces around it.
    pub(super) fn whole_text(&self) -> Cow<'a, str> {
        let rest = &self.text[self.value_at..];
        let line = rest.split(|&byte| byte == b'\n').next();
        let line = line.unwrap_or_default();
        String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line))
    }
}

/// The same text with line feeds, where its lines end with carriage returns alone, as on old Macs: all of it is its
/// first line then.
pub(super) fn with_line_feeds(text: &[u8]) -> Cow<'_, [u8]> {
    if !next_line(text, &mut beginning(text)).contains(&b'\r') {
        return Cow::Borrowed(text);
    }
    let mut text = text.to_vec();
    for i in 0..text.len() {
        if text[i] == b'\r' && text.get(i + 1) != Some(&b'\n') {
            text[i] = b'\n';
        }
    }
    Cow::Owned(text)
}

/// The pairs of a text, from an offset on.
pub(super) fn pairs(
    text: &[u8],
    from: usize,
) -> impl Iterator<Item = Result<Pair<'_>, SourceError>> {
    let mut at = from;
    std::iter::from_fn(move || {
        if at >= text.len() || text[at..].iter().all(u8::is_ascii_whitespace) {
            return None;
        }
        let code_at = at;
        let code = next_line(text, &mut at);
        let Some(code) = std::str::from_utf8(code)
            .ok()
            .and_then(|it| it.parse().ok())
        else {
            at = text.len();
            let expected = "a group code such as 0 or 10";
            return Some(Err(SourceError::unexpected(text, code_at, expected)));
        };
        let value_at = at;
        if at >= text.len() {
            let expected = "the value of the group";
            return Some(Err(SourceError::unexpected(text, at, expected)));
        }
        Some(Ok(Pair {
            text,
            code,
            value: next_line(text, &mut at),
            at: code_at,
            value_at,
        }))
    })
}

/// A line without the spaces around it.
fn next_line<'a>(text: &'a [u8], at: &mut usize) -> &'a [u8] {
    let rest = &text[*at..];
    let length = rest.iter().position(|&byte| byte == b'\n');
    *at += length.map_or(rest.len(), |length| length + 1);
    rest[..length.unwrap_or(rest.len())].trim_ascii()
}

/// Beyond that two places 0.0001 apart are the same.
pub(super) const MOST_COORDINATE: f64 = 1e12;
