//! Lists of numbers in source code or output of programs.

use anyhow::anyhow;

use super::{Bytes, hex_byte, is_code};

/// Reads lists in `[]` or `{}`, or decimal numbers with commas; `None` if the text has none.
pub(super) fn read(text: &str) -> Option<anyhow::Result<Bytes>> {
    let lists = if text.contains(['[', '{']) {
        in_brackets(text)?
    } else {
        vec![decimals(text)?]
    };
    let numbers = lists.iter().flat_map(|list| list.split([',', '\n']));
    let numbers = numbers.map(str::trim).filter(|number| !number.is_empty());
    let bytes: anyhow::Result<_> = numbers.map(byte).collect();
    Some(bytes.map(|bytes| Bytes {
        format: "a list of numbers",
        bytes,
    }))
}

/// Returns the texts in brackets if only code surrounds them.
fn in_brackets(text: &str) -> Option<Vec<&str>> {
    let mut lists = Vec::new();
    let mut rest = text;
    while let Some(begin) = rest.find(['[', '{']) {
        let inside = &rest[begin + 1..];
        let end = inside.find([']', '}'])?;
        let code = &rest[..begin];
        // Of nested brackets the inner ones count.
        let inner = inside[..end].rfind(['[', '{']).map_or(0, |at| at + 1);
        lists.push(&inside[inner..end]);
        rest = &inside[end + 1..];
        is_code(code).then_some(())?;
    }
    is_code(rest).then_some(lists)
}

/// Numbers of up to three digits: bytes in hex digits have two each.
fn decimals(text: &str) -> Option<&str> {
    let mut numbers = text
        .split(',')
        .map(str::trim)
        .filter(|number| !number.is_empty())
        .peekable();
    let is_decimal =
        |number: &str| number.len() <= 3 && number.bytes().all(|digit| digit.is_ascii_digit());
    let is_list = text.contains(',')
        && numbers.clone().all(is_decimal)
        && numbers.any(|number| number.len() != 2);
    is_list.then_some(text)
}

fn byte(number: &str) -> anyhow::Result<u8> {
    let byte = match number
        .strip_prefix("0x")
        .or_else(|| number.strip_prefix("0X"))
    {
        Some(digits) => hex_byte(digits),
        None => number.parse().ok(),
    };
    byte.ok_or_else(|| anyhow!("`{number}` is not a byte; expected 0 to 255 or 0x00 to 0xff"))
}
