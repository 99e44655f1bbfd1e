//! Dumps with an offset before each row: those of xxd, hexdump -C and od.

use anyhow::{anyhow, bail};

use super::{Bytes, hex_bytes};

/// Reads a dump; `None` if the text is none. Rows replaced by `*` are filled in.
pub(super) fn read(text: &str) -> Option<anyhow::Result<Bytes>> {
    let lines = || {
        (1..)
            .zip(text.lines())
            .filter(|(_, line)| !line.trim().is_empty())
    };
    let (_, first) = lines().next()?;
    let style = Style::ALL.into_iter().find(|style| style.fits(first))?;
    let rows: anyhow::Result<Vec<_>> = lines()
        .map(|(number, line)| style.row(number, line))
        .collect();
    // Plain bytes may look like an offset if their number of digits is even.
    let is_certain = style != Style::Od
        || first.find(' ').is_some_and(|len| len % 2 == 1)
        || rows.as_ref().is_ok_and(|rows| rows.len() > 1);
    if !is_certain {
        return None;
    }
    let bytes = rows.and_then(|rows| style.assemble(&rows));
    Some(bytes.map(|bytes| Bytes {
        format: style.name(),
        bytes,
    }))
}

/// The program that wrote a dump.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Style {
    Xxd,
    Hexdump,
    Od,
}

/// A row of a dump.
enum Row<'a> {
    Bytes {
        number: usize,
        offset: &'a str,
        bytes: Vec<u8>,
    },
    /// Copies of the previous row, up to the next offset.
    Repeated,
}

impl Style {
    const ALL: [Self; 3] = [Self::Xxd, Self::Hexdump, Self::Od];

    const fn name(self) -> &'static str {
        match self {
            Self::Xxd => "the output of xxd",
            Self::Hexdump => "the output of hexdump -C",
            Self::Od => "the output of od -t x1",
        }
    }

    /// The possible radixes of offsets, the likely ones first.
    const fn radixes(self) -> &'static [u32] {
        match self {
            Self::Xxd | Self::Hexdump => &[16],
            Self::Od => &[8, 16, 10],
        }
    }

    /// Whether a dump of this style may start with a row.
    fn fits(self, line: &str) -> bool {
        let is_offset = |offset: &str| {
            (6..=12).contains(&offset.len())
                && offset.bytes().all(|digit| digit.is_ascii_hexdigit())
        };
        match self {
            Self::Xxd => line
                .split_once(": ")
                .is_some_and(|(offset, _)| is_offset(offset)),
            Self::Hexdump => line.contains('|') && line.split(' ').next().is_some_and(is_offset),
            Self::Od => line
                .split_once(' ')
                .is_some_and(|(offset, _)| is_offset(offset)),
        }
    }

    /// Joins rows, with the radix that matches their offsets.
    fn assemble(self, rows: &[Row]) -> anyhow::Result<Vec<u8>> {
        let assembled = self.radixes().iter().map(|radix| assemble(rows, *radix));
        let better = |found: anyhow::Result<_>, next: anyhow::Result<_>| {
            if found.is_ok() || next.is_err() {
                found
            } else {
                next
            }
        };
        assembled.reduce(better).unwrap_or_else(|| Ok(Vec::new()))
    }

    fn row(self, number: usize, line: &str) -> anyhow::Result<Row<'_>> {
        let line = line.trim_end();
        if line == "*" {
            return Ok(Row::Repeated);
        }
        let (offset, rest) = match self {
            Self::Xxd => line
                .split_once(": ")
                .ok_or_else(|| anyhow!("line {number}: `{line}` has no offset"))?,
            Self::Hexdump | Self::Od => line.split_once(' ').unwrap_or((line, "")),
        };
        let digits = match self {
            Self::Xxd => rest.split("  ").next(),
            Self::Hexdump => rest.split('|').next(),
            Self::Od => rest.split('>').next(),
        };
        let bytes = self.bytes(number, digits.unwrap_or_default())?;
        Ok(Row::Bytes {
            number,
            offset,
            bytes,
        })
    }

    fn bytes(self, number: usize, digits: &str) -> anyhow::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        for word in digits.split_whitespace() {
            let read = hex_bytes(word).filter(|read| self == Self::Xxd || read.len() == 1);
            bytes.extend(read.ok_or_else(|| {
                anyhow!(
                    "line {number}: `{word}` does not fit {}; expected two hex digits for each byte",
                    self.name()
                )
            })?);
        }
        Ok(bytes)
    }
}

fn assemble(rows: &[Row], radix: u32) -> anyhow::Result<Vec<u8>> {
    let mut all: Vec<u8> = Vec::new();
    let mut begin = None;
    let mut last_len = 0;
    let mut repeats = false;
    for row in rows {
        let Row::Bytes {
            number,
            offset,
            bytes,
        } = row
        else {
            repeats = true;
            continue;
        };
        let Ok(at) = usize::from_str_radix(offset, radix) else {
            bail!("line {number}: `{offset}` is not an offset");
        };
        let expected = all.len().saturating_add(*begin.get_or_insert(at));
        if repeats {
            fill(&mut all, last_len, at.saturating_sub(expected), *number)?;
        } else if at != expected {
            bail!(
                "line {number}: offset is {at:#x}; expected {expected:#x} after the lines before"
            );
        }
        repeats = false;
        last_len = bytes.len();
        all.extend(bytes);
    }
    if repeats {
        bail!("the dump ends with `*`; expected an offset after it");
    }
    Ok(all)
}

/// Repeats the last row for a number of bytes.
fn fill(all: &mut Vec<u8>, row_len: usize, missing: usize, number: usize) -> anyhow::Result<()> {
    if missing > MAX_REPEATED {
        bail!("line {number}: `*` replaces {missing} bytes; at most {MAX_REPEATED} are allowed");
    }
    let row = all[all.len() - row_len..].to_vec();
    if row.is_empty() {
        bail!("line {number}: `*` has no previous line");
    }
    all.extend(row.iter().cycle().take(missing));
    Ok(())
}

/// The maximum number of repeated bytes.
const MAX_REPEATED: usize = 1 << 26;
