//! The output of `socat -x`: both directions with times.

use anyhow::bail;
use serde_json::json;

use super::super::content::Place;
use super::super::input::{Chunk, Input, Part, Stream};
use super::hex_bytes;

/// Reads the output of `socat -x`; `None` if the text is none.
pub(super) fn read(text: &str) -> Option<anyhow::Result<Input>> {
    let is_head = |line: &str| Head::of(line).is_some();
    text.lines().any(is_head).then(|| transfers(text))
}

fn transfers(text: &str) -> anyhow::Result<Input> {
    let mut ways = [('>', Part::default()), ('<', Part::default())];
    let mut current = None;
    let mut order = 0;
    for (number, line) in (1..).zip(text.lines()) {
        if let Some(head) = Head::of(line) {
            current = ways.iter_mut().position(|(sign, _)| *sign == head.sign);
            if let Some(at) = current {
                let part = &mut ways[at].1;
                order += 1;
                part.chunks.push(Chunk {
                    begin: part.bytes.len(),
                    order,
                    place: head.place(),
                });
            }
            continue;
        }
        // Older versions end each transfer with `--`; socat's own messages are between the transfers.
        if line.trim().is_empty() || line == "--" || is_message(line) {
            continue;
        }
        // With -v, text follows the digits.
        let digits = line.trim_start().split("  ").next().unwrap_or_default();
        let bytes: Option<Vec<_>> = digits.split_whitespace().map(hex_bytes).collect();
        let (Some(bytes), Some(at)) = (bytes, current) else {
            bail!(
                "line {number}: `{}` is neither hex digits nor a transfer of socat -x",
                line.trim()
            );
        };
        ways[at].1.bytes.extend(bytes.concat());
    }
    let ways = ways
        .into_iter()
        .map(|(_, part)| part)
        .filter(|part| !part.bytes.is_empty());
    let streams = ways.map(|part| Stream { parts: vec![part] }).collect();
    Ok(Input {
        format: "the output of socat -x".to_owned(),
        notes: Vec::new(),
        streams,
    })
}

/// The line before the bytes of a transfer: `> 2026/11/22 11:57:59.000792546  length=42 from=0 to=41`.
struct Head<'a> {
    sign: char,
    at: &'a str,
}

impl<'a> Head<'a> {
    fn of(line: &'a str) -> Option<Self> {
        let sign = line
            .chars()
            .next()
            .filter(|sign| matches!(sign, '>' | '<'))?;
        let (at, lengths) = line[1..].split_once("length=")?;
        (lengths.contains("from=") && lengths.contains("to=")).then_some(Self {
            sign,
            at: at.trim(),
        })
    }

    fn place(&self) -> Place {
        let (sign, at) = (self.sign.to_string(), self.at);
        Place {
            text: format!("{at}  {sign}"),
            fields: vec![("at", json!(at)), ("direction", json!(sign))],
        }
    }
}

/// Whether it is a line of socat's log: `2026/11/22 11:57:59 socat[815] N reading from ..`.
fn is_message(line: &str) -> bool {
    line.contains(" socat[")
}
