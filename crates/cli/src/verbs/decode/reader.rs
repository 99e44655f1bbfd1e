//! Reading the input to decode in any format.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, anyhow};

#[cfg(feature = "full")]
use super::capture;
use super::input::{BINARY, Input};
#[cfg(not(feature = "full"))]
use super::starts::is_capture;
use super::text;
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
            Failure::from(anyhow!("no file {}", input[0]))
        } else {
            not_read(error)
        }
    })
}

/// Detects the format of bytes: a capture, text or binary packets.
pub(super) fn of_bytes(bytes: Vec<u8>) -> Result<Input, Failure> {
    #[cfg(feature = "full")]
    if let Some(input) = capture::read(&bytes) {
        return Ok(input?);
    }
    #[cfg(not(feature = "full"))]
    if is_capture(&bytes) {
        return Err(dobot_api::NotBuilt("network captures").into());
    }
    match as_text(&bytes) {
        Some(text) => text::read(text).map_err(not_read),
        None => Ok(Input::plain(BINARY, bytes)),
    }
}

/// Returns the text of a file, unless it contains bytes that no text has.
fn as_text(bytes: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(bytes).ok()?;
    let is_control = |letter: char| letter.is_control() && !matches!(letter, '\t' | '\r' | '\n');
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    (!text.contains(is_control)).then_some(text)
}

fn not_read(error: anyhow::Error) -> Failure {
    Failure::new(
        error,
        "use hex digits, Python bytes, lists of numbers, or output of xxd, hexdump -C, od -t x1 or socat -x; \
         `dobot decode --help` describes the formats",
    )
}
