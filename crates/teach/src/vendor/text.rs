//! The encodings of old files.

/// Decodes bytes in any of the encodings of such files: UTF-8 and UTF-16 with or without a byte
/// order mark, and one-byte or Chinese encodings. In the latter, letters beyond ASCII become
/// others; the known keys and values are all ASCII. Returns a warning that names the encoding,
/// unless it is UTF-8.
#[must_use]
pub fn decode(bytes: &[u8]) -> (String, Option<String>) {
    let (text, encoding) = match bytes {
        [0xFF, 0xFE, rest @ ..] => (utf16(rest, u16::from_le_bytes), "UTF-16"),
        [0xFE, 0xFF, rest @ ..] => (utf16(rest, u16::from_be_bytes), "UTF-16"),
        [b'<', 0, ..] => (utf16(bytes, u16::from_le_bytes), "UTF-16 without a mark"),
        [0, b'<', ..] => (utf16(bytes, u16::from_be_bytes), "UTF-16 without a mark"),
        [0xEF, 0xBB, 0xBF, rest @ ..] => return utf8(rest),
        _ => return utf8(bytes),
    };
    (
        text,
        Some(format!("the file is in {encoding}; read as such")),
    )
}

fn utf8(bytes: &[u8]) -> (String, Option<String>) {
    if let Ok(text) = std::str::from_utf8(bytes) {
        return (text.to_owned(), None);
    }
    let text = bytes.iter().copied().map(char::from).collect();
    let warning = "the file is not in UTF-8; letters beyond ASCII are read as Latin-1";
    (text, Some(warning.to_owned()))
}

fn utf16(bytes: &[u8], number: fn([u8; 2]) -> u16) -> String {
    let units: Vec<u16> = bytes
        .chunks_exact(2)
        .map(|chunk| number([chunk[0], chunk[1]]))
        .collect();
    String::from_utf16_lossy(&units)
}

/// Parses a number, also with a decimal comma; returns whether it had one.
pub(super) fn number(text: &str) -> Option<(f64, bool)> {
    let text = text.trim();
    let is_comma = text.matches(',').count() == 1 && !text.contains('.');
    let number: f64 = if is_comma {
        text.replace(',', ".")
    } else {
        text.to_owned()
    }
    .parse()
    .ok()?;
    // Larger than any angle or time of an arm.
    (number.abs() <= 1e6).then_some((number, is_comma))
}
