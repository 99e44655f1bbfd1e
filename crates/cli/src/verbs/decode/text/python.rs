//! Bytes as Python prints them: `b'\xa5\x00A'`.

use anyhow::{anyhow, bail};

use super::{Bytes, is_code};

/// Reads all bytes literals of a text; `None` if it has none.
pub(super) fn read(text: &str) -> Option<anyhow::Result<Bytes>> {
    begin_of_literal(text)?;
    Some(literals(text).map(|bytes| Bytes {
        format: "Python bytes",
        bytes,
    }))
}

fn literals(text: &str) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some(begin) = begin_of_literal(rest) {
        let line = line_of(text, rest) + rest[..begin].matches('\n').count();
        check_code(&rest[..begin], line)?;
        let mut inside = rest[begin + 1..].chars();
        let quote = inside.next();
        loop {
            let before = inside.as_str();
            match inside.next() {
                None | Some('\n') => bail!("line {line}: the bytes literal has no end"),
                end if end == quote => break,
                Some('\\') => bytes.push(escape(&mut inside).ok_or_else(|| unknown(before, line))?),
                Some(letter) if letter.is_ascii() => bytes.push(letter as u8),
                Some(_) => return Err(unknown(before, line)),
            }
        }
        rest = inside.as_str();
    }
    check_code(rest, line_of(text, rest))?;
    Ok(bytes)
}

/// The start of a literal: a `b` that does not end a word, followed by a quote.
fn begin_of_literal(text: &str) -> Option<usize> {
    let begins = |at: &usize| {
        let before = text[..*at].chars().next_back();
        before.is_none_or(|letter| !letter.is_alphanumeric() && letter != '_')
            && text[at + 1..].starts_with(['\'', '"'])
    };
    text.match_indices('b').map(|(at, _)| at).find(begins)
}

/// Parses the escape after a backslash.
fn escape(inside: &mut std::str::Chars) -> Option<u8> {
    let rest = inside.as_str();
    let (radix, begin, len) = match inside.next()? {
        'x' => (16, 1, 2),
        '0'..='7' => (
            8,
            0,
            rest.chars()
                .take(3)
                .take_while(|digit| digit.is_digit(8))
                .count(),
        ),
        name => {
            return ESCAPES
                .iter()
                .find_map(|(letter, byte)| (*letter == name).then_some(*byte));
        }
    };
    let digits = rest.get(begin..begin + len)?;
    *inside = rest[begin + len..].chars();
    let is_number = digits.chars().all(|digit| digit.is_digit(radix));
    is_number
        .then(|| u8::from_str_radix(digits, radix).ok())
        .flatten()
}

fn check_code(code: &str, line: usize) -> anyhow::Result<()> {
    if is_code(code) {
        return Ok(());
    }
    bail!(
        "line {line}: `{}` is not bytes; expected literals as in b'\\xa5\\x00A'",
        code.trim()
    )
}

fn unknown(found: &str, line: usize) -> anyhow::Error {
    let found: String = found
        .chars()
        .take(if found.starts_with('\\') { 4 } else { 1 })
        .collect();
    anyhow!(
        "line {line}: `{found}` is not a byte of a bytes literal; expected ASCII or escapes as in \\xa5"
    )
}

/// The line, counted from 1, at which the rest of a text starts.
fn line_of(text: &str, rest: &str) -> usize {
    let read = &text[..text.len() - rest.len()];
    read.matches('\n').count() + 1
}

const ESCAPES: [(char, u8); 10] = [
    ('\\', b'\\'),
    ('\'', b'\''),
    ('"', b'"'),
    ('a', 0x07),
    ('b', 0x08),
    ('t', b'\t'),
    ('n', b'\n'),
    ('v', 0x0B),
    ('f', 0x0C),
    ('r', b'\r'),
];
