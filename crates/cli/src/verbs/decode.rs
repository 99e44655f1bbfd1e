//! `dobot decode`: decodes packets and prints their fields.

#[cfg(feature = "full")]
mod capture;
mod content;
mod input;
mod judge;
mod reader;
mod rounded;
mod starts;
mod stock;
mod text;

use anyhow::anyhow;
use clap::ValueEnum;
use dobot_wire::Dialect;

pub(crate) use self::content::{Content, Place, kind, readings, show};
use self::input::{Input, Part};
use self::judge::{Piece, pieces};
use crate::failure::Failure;
use crate::output;

/// Decode packets and print their fields
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot decode capture.bin --sender arm
  dobot decode both-ways.txt --dialect firmware-1.1
  some-program | dobot decode - --json
  dobot decode a5 00004040 00000000 00004843 000048c2 0000a041 00007041 \\
      00000000 00000000 00000000 00000000 5a
  socat -x TCP-LISTEN:5556 TCP:127.0.0.1:5555 2> both-ways.txt

The input is a file, - for standard input, or the bytes as text. The format of
a file is detected:

  bytes            as they are
  hex digits       also with spaces, `:`, `,`, `-`, 0x or \\x; # starts a comment
  source code      b'\\xa5\\x00A', bytearray(b'..'), [165, 0, 65], { 0xa5, 0x00 }
  dumps            of xxd, xxd -p, hexdump -C, od -t x1, and socat -x with both
                   directions
  pcap, pcapng     TCP connections, reassembled, with times; gaps are reported
                   (not in a program built without --features full)

Each packet is decoded by itself, so that a file may contain both directions.
A command whose meaning depends on the dialect is shown in each dialect unless
--dialect chooses one. A command that is not allowed but harmless to an arm as
sold is marked.")]
pub(crate) struct Args {
    /// File, - for standard input, or the bytes as text
    #[arg(required = true)]
    input: Vec<String>,
    /// Sender of the bytes
    #[arg(long, value_enum, default_value_t)]
    sender: SenderOption,
    /// Protocol dialect: specification or firmware-1.1 (default: show both)
    #[arg(long, value_name = "DIALECT")]
    dialect: Option<Dialect>,
    /// Print JSON, one object per line
    #[arg(long)]
    json: bool,
}

/// The sender of the bytes, or automatic detection.
#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
enum SenderOption {
    /// A client: commands
    Client,
    /// The arm: statuses
    Arm,
    /// Detected for each packet
    #[default]
    Auto,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let input = reader::read(&args.input)?;
    if input.len() == 0 {
        return Err(Failure::new(
            anyhow!("the input is empty"),
            "run `dobot decode --help` for examples",
        ));
    }
    for note in input.notes() {
        eprintln!("{note}");
    }
    let lines = lines(&input, args);
    for (_, place, content) in &lines {
        show(place, content, args.json)?;
    }
    if lines.iter().any(|(_, _, content)| is_packet(content)) {
        Ok(())
    } else {
        Err(no_packet(&input))
    }
}

fn no_packet(input: &Input) -> Failure {
    let found = anyhow!(
        "no packet in {}, read as {}",
        output::count(input.len(), "byte"),
        input.format
    );
    Failure::new(
        found,
        "check the input: a packet is 42 bytes: A5, ten little-endian floats, 5A",
    )
}

/// The lines to show, in the order of sending as far as it is known.
fn lines(input: &Input, args: &Args) -> Vec<(usize, Place, Content)> {
    let parts = input.streams.iter().flat_map(|stream| &stream.parts);
    let mut lines: Vec<_> = parts.flat_map(|part| part_lines(part, args)).collect();
    lines.sort_by_key(|(order, ..)| *order);
    lines
}

fn part_lines(part: &Part, args: &Args) -> Vec<(usize, Place, Content)> {
    let gap = (part.gap > 0).then(|| {
        let (order, place) = part.place(0, 0);
        (order, place, Content::Gap(part.gap))
    });
    let in_step = part.gap == 0;
    let pieces = pieces(&part.bytes, args.sender, args.dialect, in_step);
    let line = |Piece {
                    offset,
                    len,
                    content,
                }| {
        let (order, place) = part.place(offset, offset + len - 1);
        (order, place, content)
    };
    gap.into_iter()
        .chain(pieces.into_iter().map(line))
        .collect()
}

const fn is_packet(content: &Content) -> bool {
    !matches!(content, Content::Skipped(_) | Content::Gap(_))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANY: Args = Args {
        input: Vec::new(),
        sender: SenderOption::Auto,
        dialect: None,
        json: false,
    };

    proptest::proptest! {
        #[test]
        fn no_input_makes_it_panic(
            bytes: Vec<u8>,
            which in 0..SAMPLES.len(),
            hits in proptest::collection::vec((0..2000_usize, proptest::prelude::any::<u8>()), 0..6),
        ) {
            let mut sample = SAMPLES[which].to_vec();
            for (at, byte) in hits {
                if let Some(hit) = sample.get_mut(at) {
                    *hit = byte;
                }
            }
            for bytes in [bytes, sample] {
                if let Ok(input) = reader::of_bytes(bytes) {
                    lines(&input, &ANY);
                }
            }
        }
    }

    const SAMPLES: [&[u8]; 6] = [
        include_bytes!("../../tests/process/samples/decode/awkward.pcapng"),
        include_bytes!("../../tests/process/samples/decode/sll.pcap"),
        include_bytes!("../../tests/process/samples/decode/socat.txt"),
        include_bytes!("../../tests/process/samples/decode/hexdump-C.txt"),
        include_bytes!("../../tests/process/samples/decode/python.txt"),
        include_bytes!("../../tests/process/samples/decode/packets.bin"),
    ];
}
