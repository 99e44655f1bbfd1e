//! Hex digits with or without separators.

use anyhow::{anyhow, bail};

use super::super::input::HEX_DIGITS;
use super::{Bytes, hex_byte, hex_bytes};
use crate::output;

/// Reads hex digits, also with spaces, `:`, `,`, `;`, `-`, `0x` or `\x` between the bytes. `#` and `//`
/// start a comment.
pub(super) fn read(text: &str) -> anyhow::Result<Bytes> {
    let text: Vec<_> = text
        .lines()
        .map(|line| without_comment(line).replace("\\x", " 0x"))
        .collect();
    let is_separated = text
        .iter()
        .any(|line| line.contains(SEPARATORS) || line.contains("0x"));
    let bytes = if is_separated {
        each(&text)?
    } else {
        row(&text)?
    };
    Ok(Bytes {
        format: HEX_DIGITS,
        bytes,
    })
}

/// Parses separated bytes.
fn each(lines: &[String]) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    for (number, word) in words(lines) {
        let prefixed = word.strip_prefix("0x").or_else(|| word.strip_prefix("0X"));
        let read = match prefixed {
            Some(digits) => hex_byte(digits).map(|byte| vec![byte]),
            None if word.len() == 1 => hex_byte(word).map(|byte| vec![byte]),
            None => hex_bytes(word),
        };
        bytes.extend(read.ok_or_else(|| invalid_digits(number, word))?);
    }
    Ok(bytes)
}

/// Parses digits without separators other than spaces.
fn row(lines: &[String]) -> anyhow::Result<Vec<u8>> {
    let mut row = String::new();
    for (number, word) in words(lines) {
        if !word.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return Err(invalid_digits(number, word));
        }
        row.push_str(word);
    }
    let Some(bytes) = hex_bytes(&row) else {
        bail!(
            "found {}; expected two for each byte",
            output::count(row.len(), "hex digit")
        );
    };
    Ok(bytes)
}

fn words(lines: &[String]) -> impl Iterator<Item = (usize, &str)> {
    let is_between = |letter: char| letter.is_whitespace() || SEPARATORS.contains(&letter);
    let words = move |(number, line)| {
        let words = str::split(line, is_between).filter(|word| !word.is_empty());
        words.map(move |word| (number, word))
    };
    (1..).zip(lines.iter().map(String::as_str)).flat_map(words)
}

fn invalid_digits(number: usize, word: &str) -> anyhow::Error {
    anyhow!(
        "line {number}: `{word}` is not hex digits; expected 0 to 9 and a to f, two for each byte"
    )
}

fn without_comment(line: &str) -> &str {
    let end = [line.find('#'), line.find("//")]
        .into_iter()
        .flatten()
        .min();
    &line[..end.unwrap_or(line.len())]
}

const SEPARATORS: [char; 4] = [':', ',', ';', '-'];
