//! Pairs of lines of a DXF file: a group code and its value.

use std::borrow::Cow;

use crate::error::SourceError;
use crate::limits::MAX_NUMBER;
use crate::place::{beginning, shortened};

/// A group code with its value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'a> {
    /// The whole file.
    text: &'a [u8],
    pub(super) code: i32,
    pub(super) value: &'a [u8],
    /// The position of the code in the text.
    pub(super) at: usize,
    /// The position of the value.
    pub(super) value_at: usize,
}

impl<'a> Pair<'a> {
    /// The value under another code.
    pub(super) const fn with_code(self, code: i32) -> Self {
        Self { code, ..self }
    }

    pub(super) fn is(&self, code: i32, value: &[u8]) -> bool {
        self.code == code && self.value == value
    }

    /// The value as a number. Coordinates may be as large as national grid coordinates in
    /// millimetres.
    pub(super) fn number(&self) -> Result<f64, SourceError> {
        let (most, expected) = match self.code {
            10..=39 => (MAX_COORDINATE, "a number from -1e12 to 1e12"),
            _ => (MAX_NUMBER, "a number from -1e9 to 1e9"),
        };
        let number = std::str::from_utf8(self.value)
            .ok()
            .and_then(|from_utf8| from_utf8.parse().ok());
        let number = number.filter(|x: &f64| x.abs() <= most);
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

    /// The value with surrounding spaces.
    pub(super) fn whole_text(&self) -> Cow<'a, str> {
        let rest = &self.text[self.value_at..];
        let line = rest.split(|&byte| byte == b'\n').next();
        let line = line.unwrap_or_default();
        String::from_utf8_lossy(line.strip_suffix(b"\r").unwrap_or(line))
    }
}

/// Replaces carriage returns by line feeds if the file has carriage returns only, as on old Macs.
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
            .and_then(|from_utf8| from_utf8.parse().ok())
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

/// A line without surrounding spaces.
fn next_line<'a>(text: &'a [u8], at: &mut usize) -> &'a [u8] {
    let rest = &text[*at..];
    let length = rest.iter().position(|&byte| byte == b'\n');
    *at += length.map_or(rest.len(), |length| length + 1);
    rest[..length.unwrap_or(rest.len())].trim_ascii()
}

/// Beyond this, places 0.0001 apart are equal.
pub(super) const MAX_COORDINATE: f64 = 1e12;
