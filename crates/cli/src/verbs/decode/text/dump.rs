//! Dumps with an offset before each row: those of xxd, hexdump -C and od.

use anyhow::{anyhow, bail};

use super::{Bytes, hex_bytes};

/// Reads a dump; `None` where the text is none. Rows that `*` stands for are filled in.
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
    // Bytes alone may look like an offset, if the number of their digits is even.
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

/// Which program wrote it.
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
    /// As the one before, up to the next offset.
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

    /// The bases in which offsets may be written, likelier ones first.
    const fn radixes(self) -> &'static [u32] {
        match self {
            Self::Xxd | Self::Hexdump => &[16],
            Self::Od => &[8, 16, 10],
        }
    }

    /// Whether a dump begins with this row.
    fn fits(self, line: &str) -> bool {
        let is_offset = |offset: &str| {
            (6..=12).contains(&offset.len()) && offset.bytes().all(|it| it.is_ascii_hexdigit())
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

    /// Puts rows together, with the base in which their offsets fit.
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
        let mut bytes = Vec::new();
        for word in digits.unwrap_or_default().split_whitespace() {
            let read = hex_bytes(word).filter(|read| self == Self::Xxd || read.len() == 1);
            bytes.extend(read.ok_or_else(|| {
                anyhow!(
                    "line {number}: `{word}` is not what {} holds there: two hex digits a byte",
                    self.name()
                )
            })?);
        }
        Ok(Row::Bytes {
            number,
            offset,
            bytes,
        })
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
            bail!("line {number}: offset {at:#x}; {expected:#x} follows from the lines before");
        }
        repeats = false;
        last_len = bytes.len();
        all.extend(bytes);
    }
    if repeats {
        bail!("the dump ends with `*`: the offset behind it is missing");
    }
    Ok(all)
}

/// Repeats the last row for so many bytes.
fn fill(all: &mut Vec<u8>, row_len: usize, missing: usize, number: usize) -> anyhow::Result<()> {
    if missing > MOST_REPEATED {
        bail!("line {number}: `*` stands for {missing} bytes; at most {MOST_REPEATED} are read");
    }
    let row = all[all.len() - row_len..].to_vec();
    if row.is_empty() {
        bail!("line {number}: `*` has no line before it");
    }
    all.extend(row.iter().cycle().take(missing));
    Ok(())
}

/// Nobody looks at more.
const MOST_REPEATED: usize = 1 << 26;
