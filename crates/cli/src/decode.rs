//! `dobot decode`: from bytes to annotated lines.

use std::io::Read;
use std::path::Path;

use anyhow::{Context, bail};
use clap::ValueEnum;
use dobot_wire::{Command, Decoder, Dialect, Packet, ParseError, Status};
use serde_json::{Value, json};

use crate::failure::Failure;
use crate::output;

/// Say what bytes mean
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot decode a5 00004040 00000000 00004843 000048c2 0000a041 00007041 00000000 00000000 00000000 00000000 5a
  dobot decode capture.bin --from arm
  some-program | dobot decode - --json

What is given is a file, - for standard input, or the hex digits themselves. A file may hold the
bytes or their hex digits. Commands whose meaning differs between dialects are shown in each of them
unless --dialect chooses one.")]
pub(crate) struct Args {
    /// A file, - or hex digits
    #[arg(required = true)]
    input: Vec<String>,
    /// Who sent it
    #[arg(long, value_enum, default_value_t)]
    from: From,
    /// In which dialect: specification or firmware-1.1
    #[arg(long, value_name = "DIALECT")]
    dialect: Option<Dialect>,
    /// Print JSON, one object a line
    #[arg(long)]
    json: bool,
}

/// Who sent the bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
enum From {
    /// A client: commands
    Client,
    /// The arm: statuses
    Arm,
    /// Whichever makes more sense
    #[default]
    Auto,
}

/// Where in a stream or in time something is: as text, and as a field of its JSON.
pub(crate) struct Place {
    pub(crate) text: String,
    pub(crate) field: (&'static str, Value),
}

/// What a stretch of bytes is.
struct Piece {
    offset: u64,
    content: Content,
}

pub(crate) enum Content {
    /// A status of the arm.
    Status(Status),
    /// What a packet of a client says, in each of the dialects asked for.
    Command(Vec<(Dialect, Result<Command, ParseError>)>),
    /// So many bytes that belong to no packet.
    Skipped(u64),
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let bytes = read(&args.input)?;
    if bytes.is_empty() {
        return Err(Failure::new(
            anyhow::anyhow!("there are no bytes to decode"),
            "`dobot decode --help` shows examples",
        ));
    }
    let pieces = match args.from {
        From::Arm => statuses(&bytes),
        From::Client => commands(&bytes, args.dialect),
        From::Auto => likelier(&bytes, args.dialect),
    };
    let found = pieces
        .iter()
        .any(|it| !matches!(it.content, Content::Skipped(_)));
    for piece in pieces {
        print(&piece, args.json)?;
    }
    if found {
        Ok(())
    } else {
        Err(Failure::new(
            anyhow::anyhow!("no packet in {} bytes", bytes.len()),
            "a packet is 42 bytes: A5, ten little-endian floats, 5A",
        ))
    }
}

fn read(input: &[String]) -> anyhow::Result<Vec<u8>> {
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
        [name] if name.contains(['.', '/']) => bail!("there is no file {name}"),
        digits => return hex(&digits.concat()),
    };
    // A capture begins with a header or in the middle of a packet; hex digits are all text.
    let is_text = bytes
        .iter()
        .all(|&it| it.is_ascii_hexdigit() || it.is_ascii_whitespace());
    if is_text {
        hex(&String::from_utf8_lossy(&bytes))
    } else {
        Ok(bytes)
    }
}

fn hex(text: &str) -> anyhow::Result<Vec<u8>> {
    let digits: Vec<char> = text.chars().filter(|it| !it.is_whitespace()).collect();
    if let Some(at) = digits.iter().position(|it| !it.is_ascii_hexdigit()) {
        bail!(
            "hex digit {} is `{}`; allowed are 0 to 9 and a to f",
            at + 1,
            digits[at]
        );
    }
    if digits.len() % 2 == 1 {
        bail!("there are {} hex digits; a byte takes two", digits.len());
    }
    let digit = |it: char| {
        it.to_digit(16)
            .and_then(|it| u8::try_from(it).ok())
            .unwrap_or_default()
    };
    Ok(digits
        .chunks_exact(2)
        .map(|it| digit(it[0]) << 4 | digit(it[1]))
        .collect())
}

/// The direction that leaves fewer bytes unexplained.
fn likelier(bytes: &[u8], dialect: Option<Dialect>) -> Vec<Piece> {
    let skipped = |pieces: &[Piece]| -> u64 {
        let count = |piece: &Piece| match piece.content {
            Content::Skipped(count) => count,
            Content::Status(_) | Content::Command(_) => 0,
        };
        pieces.iter().map(count).sum()
    };
    let (from_arm, from_client) = (statuses(bytes), commands(bytes, dialect));
    if skipped(&from_arm) <= skipped(&from_client) {
        from_arm
    } else {
        from_client
    }
}

fn statuses(bytes: &[u8]) -> Vec<Piece> {
    let mut decoder = Decoder::statuses(dobot_client::plausible);
    let mut pieces = Pieces::default();
    for byte in bytes.chunks(1) {
        let frame = decoder.feed(byte).last();
        pieces.take(decoder.counts().skipped_bytes);
        if let Some(status) = frame.and_then(|frame| Status::parse(&frame).ok()) {
            pieces.push(Content::Status(status));
        }
    }
    pieces.finish(bytes.len())
}

fn commands(bytes: &[u8], dialect: Option<Dialect>) -> Vec<Piece> {
    let mut decoder = Decoder::commands();
    let mut pieces = Pieces::default();
    for byte in bytes.chunks(1) {
        let packet = decoder.feed(byte).last();
        pieces.take(decoder.counts().skipped_bytes);
        if let Some(packet) = packet {
            pieces.push(Content::Command(readings(&packet, dialect)));
        }
    }
    pieces.finish(bytes.len())
}

/// What a packet says: once where all dialects agree.
pub(crate) fn readings(
    packet: &Packet,
    dialect: Option<Dialect>,
) -> Vec<(Dialect, Result<Command, ParseError>)> {
    let read = |dialect: Dialect| (dialect, Command::parse(packet, &dialect));
    if let Some(dialect) = dialect {
        return vec![read(dialect)];
    }
    let [specification, firmware] = Dialect::ALL.map(read);
    let refused = specification.1.is_err() && firmware.1.is_err();
    if refused || specification.1 == firmware.1 {
        vec![specification]
    } else {
        vec![specification, firmware]
    }
}

/// Pieces in the order of the stream.
#[derive(Default)]
struct Pieces {
    found: Vec<Piece>,
    offset: u64,
    skipped: u64,
}

impl Pieces {
    /// Notes bytes that turned out to belong to no packet.
    fn take(&mut self, skipped: u64) {
        let count = skipped - self.skipped;
        self.skipped = skipped;
        self.skip(count);
    }

    fn skip(&mut self, count: u64) {
        if count == 0 {
            return;
        }
        match self.found.last_mut() {
            Some(Piece {
                content: Content::Skipped(before),
                ..
            }) => *before += count,
            _ => self.found.push(Piece {
                offset: self.offset,
                content: Content::Skipped(count),
            }),
        }
        self.offset += count;
    }

    fn push(&mut self, content: Content) {
        self.found.push(Piece {
            offset: self.offset,
            content,
        });
        self.offset += 42;
    }

    fn finish(mut self, len: usize) -> Vec<Piece> {
        let rest = (len as u64).saturating_sub(self.offset);
        self.skip(rest);
        self.found
    }
}

fn print(piece: &Piece, as_json: bool) -> std::io::Result<()> {
    let place = Place {
        text: format!("{:6}", piece.offset),
        field: ("offset", json!(piece.offset)),
    };
    show(&place, &piece.content, as_json)
}

/// Prints what something is, and where.
pub(crate) fn show(place: &Place, content: &Content, as_json: bool) -> std::io::Result<()> {
    match content {
        Content::Skipped(bytes) if as_json => place.json(json!({ "skipped_bytes": bytes })),
        Content::Skipped(bytes) => {
            place.line(&format!("skipped {bytes} bytes that belong to no packet"))
        }
        Content::Status(status) if as_json => place.json(json!({ "status": status })),
        Content::Status(status) => place.line(&format!("status  {}", output::fields(status))),
        Content::Command(readings) => readings.iter().try_for_each(|(dialect, command)| {
            show_command(place, dialect, readings.len() > 1, command, as_json)
        }),
    }
}

fn show_command(
    place: &Place,
    dialect: &Dialect,
    differs: bool,
    command: &Result<Command, ParseError>,
    as_json: bool,
) -> std::io::Result<()> {
    let dialect_text = if differs {
        format!("[{dialect}] ")
    } else {
        String::new()
    };
    match (command, as_json) {
        (Ok(command), true) => place.json(json!({ "dialect": dialect.name(), "command": command })),
        (Ok(command), false) => place.line(&format!(
            "{dialect_text}{}  {}",
            kind(command),
            output::fields(command)
        )),
        (Err(error), true) => {
            place.json(json!({ "dialect": dialect.name(), "error": error.to_string() }))
        }
        (Err(error), false) => place.line(&format!("{dialect_text}not allowed: {error}")),
    }
}

impl Place {
    pub(crate) fn line(&self, text: &str) -> std::io::Result<()> {
        output::line(&format!("{}  {text}", self.text))
    }

    /// Prints the fields of an object behind the place.
    pub(crate) fn json(&self, mut content: Value) -> std::io::Result<()> {
        let mut fields = serde_json::Map::new();
        fields.insert(self.field.0.to_owned(), self.field.1.clone());
        if let Some(content) = content.as_object_mut() {
            fields.append(content);
        }
        output::json(&fields)
    }
}

/// The kind of a command, as its JSON names it.
pub(crate) fn kind(command: &Command) -> String {
    serde_json::to_value(command)
        .ok()
        .and_then(|value| value.get("type").and_then(Value::as_str).map(str::to_owned))
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hex_digits_may_be_spaced_as_one_likes() {
        assert_eq!(hex("a5 00\n FF").expect("it is hex"), [0xA5, 0, 0xFF]);
        assert!(
            hex("a5 0")
                .expect_err("odd")
                .to_string()
                .contains("3 hex digits")
        );
        assert!(
            hex("a5 xy")
                .expect_err("no hex")
                .to_string()
                .contains("`x`")
        );
    }

    #[test]
    fn what_differs_between_the_dialects_is_read_in_both() {
        let mut bytes = [0; 42];
        bytes[0] = 0xA5;
        bytes[41] = 0x5A;
        bytes[1..5].copy_from_slice(&3.0_f32.to_le_bytes());
        bytes[29..33].copy_from_slice(&1.0_f32.to_le_bytes());
        let pieces = commands(&bytes, None);
        let Content::Command(readings) = &pieces[0].content else {
            panic!("it is a command");
        };
        assert_eq!(readings.len(), 2);
    }
}
