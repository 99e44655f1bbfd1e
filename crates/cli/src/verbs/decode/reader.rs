//! Reads what is to be decoded, whatever format it is in.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, anyhow};

use super::input::{BINARY, Input};
use super::{capture, text};
use crate::failure::Failure;

/// Reads what the arguments name: a file, standard input, or the bytes themselves.
pub(super) fn read(input: &[String]) -> Result<Input, Failure> {
    let bytes = match input {
        [dash] if dash == "-" => {
            let mut bytes = Vec::new();
            std::io::stdin()
                .read_to_end(&mut bytes)
                .context("cannot read standard input")?;
            bytes
        }
        [file] if Path::new(file).exists() => {
            std::fs::read(file).with_context(|| format!("cannot read {file}"))?
        }
        _ => return of_arguments(input),
    };
    of_bytes(bytes)
}

fn of_arguments(input: &[String]) -> Result<Input, Failure> {
    let is_name = matches!(input, [name] if name.contains(['.', '/']));
    text::read(&input.join(" ")).map_err(|error| {
        if is_name {
            Failure::from(anyhow!("there is no file {}", input[0]))
        } else {
            not_read(error)
        }
    })
}

/// Finds out what bytes hold: a capture, text, or the packets themselves.
pub(super) fn of_bytes(bytes: Vec<u8>) -> Result<Input, Failure> {
    if let Some(input) = capture::read(&bytes) {
        return Ok(input?);
    }
    match as_text(&bytes) {
        Some(text) => text::read(text).map_err(not_read),
        None => Ok(Input::plain(BINARY, bytes)),
    }
}

/// The text that a file holds, if it is one: packets hold bytes that no text has.
fn as_text(bytes: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(bytes).ok()?;
    let is_control = |it: char| it.is_control() && !matches!(it, '\t' | '\r' | '\n');
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    (!text.contains(is_control)).then_some(text)
}

fn not_read(error: anyhow::Error) -> Failure {
    Failure::new(
        error,
        "tried were hex digits, Python bytes, lists of numbers, xxd, hexdump -C, od -t x1 and socat -x; \
         `dobot decode --help` shows them",
    )
}
