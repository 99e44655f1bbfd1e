//! `dobot decode`: from bytes to annotated lines.

mod capture;
mod content;
mod input;
mod judge;
mod reader;
mod rounded;
mod stock;
mod text;

use anyhow::anyhow;
use clap::ValueEnum;
use dobot_wire::Dialect;

pub(crate) use self::content::{Content, Place, kind, readings, show};
use self::input::{Input, Part};
use self::judge::{Piece, pieces};
use crate::failure::Failure;

/// Say what bytes mean
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot decode a5 00004040 00000000 00004843 000048c2 0000a041 00007041 00000000 00000000 00000000 00000000 5a
  dobot decode capture.bin --from arm
  socat -x TCP-LISTEN:5556 TCP:127.0.0.1:5555 2> both-ways.txt; dobot decode both-ways.txt
  some-program | dobot decode - --json

What is given is a file, - for standard input, or the bytes themselves as text. What a file holds is
found out:

  bytes            as they are
  hex digits       with or without blanks, `:`, `,`, `-`, 0x, \\x; # begins a comment
  a program's      b'\\xa5\\x00A', bytearray(b'..'), [165, 0, 65], { 0xa5, 0x00 }
  dumps            of xxd, xxd -p, hexdump -C, od -t x1, and socat -x with its directions
  pcap, pcapng     TCP connections, each way put in order, with times; what is missing is told

Each packet is judged by itself, so both directions may be in one file. Commands whose meaning differs
between dialects are shown in each of them unless --dialect chooses one. A command that is not allowed
but does no harm to a stock arm is marked so.")]
pub(crate) struct Args {
    /// A file, - or the bytes as text
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
    /// Each packet is what makes more sense
    #[default]
    Auto,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let input = reader::read(&args.input)?;
    if input.len() == 0 {
        return Err(Failure::new(
            anyhow!("there are no bytes to decode"),
            "`dobot decode --help` shows examples",
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
        let found = anyhow!(
            "no packet in {} bytes, read as {}",
            input.len(),
            input.format
        );
        Err(Failure::new(
            found,
            "a packet is 42 bytes: A5, ten little-endian floats, 5A",
        ))
    }
}

/// What is told: in the order in which it was sent, as far as that is known.
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
    let pieces = pieces(&part.bytes, args.from, args.dialect, in_step);
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
        from: From::Auto,
        dialect: None,
        json: false,
    };

    proptest::proptest! {
        #[test]
        fn nothing_that_is_given_makes_it_panic(
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
